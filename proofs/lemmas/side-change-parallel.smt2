; Straight on, a change of side has no contact point
;
; Clauses: [TRC-SIDE-02], [TRC-SIDE-03]
;
; When c = 0 and d > 0 no point is r away from the first line on the old side and r away from the second on the new
; one. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (= (* (- sigma) (cross d c pa pb)) r)
; Twin has:      (= (* sigma (cross d c pa pb)) r)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (and (= c 0) (> d 0)))
(declare-const pa Real)
(declare-const pb Real)
(assert (not
  (not (and (= (* sigma (cross 1 0 pa pb)) r) (= (* (- sigma) (cross d c pa pb)) r)))))
(check-sat)
