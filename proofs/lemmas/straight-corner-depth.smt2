; A corner that counts as straight is cut by at most r·(1 - L)
;
; Clauses: [TRC-CORNER-16], [TRC-PLANE-04]
;
; The first element ends on its normal P + r·n(u1), which stands r·d from the line of the second element, on its tool
; side: where d ≥ L that is nearer than r by at most r·(1 - L), at an inner corner and at an outer one. P is the
; origin and u1 the first axis.
;
; Twin replaces: (assert (>= d band))
; Twin has:      (assert (>= (+ d c) band))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(declare-const band Real) ; L, the cosine of the turn
(assert (and (> band 0) (<= band 1)))
(assert (>= d band))
(define-fun stands () Real (* sigma (cross d c 0 (* r sigma))))
(assert (not
  (and
    (= stands (* r d))
    (<= (- r stands) (* r (- 1 band))))))
(check-sat)
