; The inserted arc joins the two offset lines without a kink
;
; Clauses: [TRC-CORNER-10]
;
; The circle about P with radius r, run clockwise (δ = -1) when the tool is left and counter-clockwise when it is
; right, δ = -σ, passes both normals, and its direction of travel δ·perp(ray) there is u1 at the first and u2 at the
; second. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (define-fun delta () Real (- sigma))
; Twin has:      (define-fun delta () Real sigma)
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun delta () Real (- sigma))
(assert (not
  (and
    (= (+ (* r n1a r n1a) (* r n1b r n1b)) (* r r))
    (= (+ (* r n2a r n2a) (* r n2b r n2b)) (* r r))
    (= (* delta (- n1b)) 1)
    (= (* delta n1a) 0)
    (= (* delta (- n2b)) d)
    (= (* delta n2a) c))))
(check-sat)
