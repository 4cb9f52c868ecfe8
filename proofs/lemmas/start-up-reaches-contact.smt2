; Start-up ends with the tool touching the next line at its start
;
; Clauses: [TRC-START-02], [TRC-PLANE-04]
;
; Whatever the angle, at the end of start-up the tool is r away from the next line on the tool's side, and the nearest
; point of that line is its start P. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (= (* sigma (cross d c (* r n2a) (* r n2b))) r)
; Twin has:      (= (* sigma (cross 1 0 (* r n2a) (* r n2b))) r)
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
(assert (not
  (and
    (= (* sigma (cross d c (* r n2a) (* r n2b))) r)
    (= (dot (* r n2a) (* r n2b) d c) 0))))
(check-sat)
