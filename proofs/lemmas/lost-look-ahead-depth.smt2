; What a lost look-ahead leaves of the distance to the next line
;
; Clauses: [TRC-LOOK-03], [TRC-LOOK-06]
;
; The tool stands on the normal of the last line, P + r·n(u1). Its signed distance to the next line is r·dot(n1, n2) =
; r·d: it is too near by r·(1 - d), the amount of the advisory. P is the origin and u1 the first axis: frame-rotation
; says why that is no loss.
;
; Twin replaces: (* r (- 1 d))
; Twin has:      (* r (- 1 c))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
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
(define-fun distance () Real (* sigma (cross d c (* r n1a) (* r n1b))))
(assert (not
  (and
    (= distance (* r (dot n1a n1b n2a n2b)))
    (= (- r distance) (* r (- 1 d))))))
(check-sat)
