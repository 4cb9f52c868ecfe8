; The point of a change of side touches both lines, each on its own side
;
; Clauses: [TRC-SIDE-02]
;
; When the path turns, c ≠ 0, V = P + r·n(u1) + σ·r·(1 + d)/c·u1 is r away from the first line on the old side σ and r
; away from the second line on the new side -σ. P is the origin and u1 the first axis: frame-rotation says why that is
; no loss.
;
; Twin replaces: (= (* (- sigma) (cross d c va vb)) r)
; Twin has:      (= (* sigma (cross d c va vb)) r)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (not (= c 0)))
(declare-const k Real) ; (1 + d)/c
(assert (= (* k c) (+ 1 d)))
(define-fun va () Real (* sigma r k))
(define-fun vb () Real (* sigma r))
(assert (not
  (and
    (= (* sigma (cross 1 0 va vb)) r)
    (= (* (- sigma) (cross d c va vb)) r))))
(check-sat)
