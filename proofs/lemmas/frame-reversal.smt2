; A program run backwards on the other side has the same normals and corners
;
; Clauses: [TRC-PLANE-02], [TRC-CORNER-01], [TRC-START-02], [TRC-CANCEL-01]
;
; Run backwards, a path has the tangents -u2 and -u1 in place of u1 and u2; with the other side, σ' = -σ. The normals
; are the same, and so are σ·c and d: an inner corner stays inner, an acute one acute.
;
; Twin replaces: (dot (- wa) (- wb) (- va) (- vb))
; Twin has:      (dot (- wa) wb (- va) (- vb))
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
    (= (* (- sigma) (perp-a (- va) (- vb))) (* sigma (perp-a va vb)))
    (= (* (- sigma) (perp-b (- va) (- vb))) (* sigma (perp-b va vb)))
    (= (* (- sigma) (cross (- wa) (- wb) (- va) (- vb))) (* sigma (cross va vb wa wb)))
    (= (dot (- wa) (- wb) (- va) (- vb)) (dot va vb wa wb)))))
(check-sat)
