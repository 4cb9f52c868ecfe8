; A mirror changes left and right, and nothing else
;
; Clauses: [TRC-PLANE-02], [TRC-CORNER-01]
;
; In the mirror (a, b) → (a, -b) cross changes its sign, dot does not, and the normal sigma·perp of the mirrored
; tangent with the other side is the mirrored normal: σ·c, by which inner and outer corners are told apart, is the
; same in the mirror with the side changed.
;
; Twin replaces: (* (- sigma) (cross va (- vb) wa (- wb)))
; Twin has:      (* sigma (cross va (- vb) wa (- wb)))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(define-fun perp-a ((va Real) (vb Real)) Real (- vb))
(define-fun perp-b ((va Real) (vb Real)) Real va)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const va Real)
(declare-const vb Real)
(declare-const wa Real)
(declare-const wb Real)
(assert (not
  (and
    (= (* sigma (cross va vb wa wb)) (* (- sigma) (cross va (- vb) wa (- wb))))
    (= (dot va vb wa wb) (dot va (- vb) wa (- wb)))
    (= (* (- sigma) (perp-a va (- vb))) (* sigma (perp-a va vb)))
    (= (* (- sigma) (perp-b va (- vb))) (- (* sigma (perp-b va vb)))))))
(check-sat)
