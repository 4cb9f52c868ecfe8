; Where a crossing block starts
;
; Clauses: [TRC-SIDE-06], [TRC-PLANE-04]
;
; The block that crosses starts at P + r·n(u1), on the old side σ of the block before: r·d away from its own line on
; the wrong side, never deeper than the radius, and on its own offset line at an exact reversal alone. P is the origin
; and u1 the first axis.
;
; Twin replaces: (= (= stands r) (= d (- 1)))
; Twin has:      (= (= stands r) (<= d 0))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(define-fun stands () Real (* (- sigma) (cross d c 0 (* r sigma)))) ; its distance on the new side
(assert (not
  (and
    (= stands (- (* r d)))
    (>= stands (- r))
    (= (= stands r) (= d (- 1))))))
(check-sat)
