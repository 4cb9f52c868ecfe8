; A rotation changes no product
;
; Clauses: [TRC-PLANE-02], [TRC-CORNER-01]
;
; For every rotation (p, q), p² + q² = 1, and all vectors v and w: cross and dot of the rotated vectors are those of v
; and w, and perp of the rotated vector is the rotated perp. All that the rules say of a corner they say by these, so
; that a lemma may choose the direction of u1; the place of P is free, for only differences of points occur.
;
; Twin replaces: (= (+ (* p p) (* q q)) 1)
; Twin has:      (= (+ (* p p) (* q q)) 2)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(define-fun perp-a ((va Real) (vb Real)) Real (- vb))
(define-fun perp-b ((va Real) (vb Real)) Real va)
(declare-const p Real)
(declare-const q Real)
(assert (= (+ (* p p) (* q q)) 1))
(define-fun turned-a ((va Real) (vb Real)) Real (- (* p va) (* q vb)))
(define-fun turned-b ((va Real) (vb Real)) Real (+ (* q va) (* p vb)))
(declare-const va Real)
(declare-const vb Real)
(declare-const wa Real)
(declare-const wb Real)
(define-fun xa () Real (turned-a va vb))
(define-fun xb () Real (turned-b va vb))
(define-fun ya () Real (turned-a wa wb))
(define-fun yb () Real (turned-b wa wb))
(assert (not
  (and
    (= (cross xa xb ya yb) (cross va vb wa wb))
    (= (dot xa xb ya yb) (dot va vb wa wb))
    (= (perp-a xa xb) (turned-a (perp-a va vb) (perp-b va vb)))
    (= (perp-b xa xb) (turned-b (perp-a va vb) (perp-b va vb))))))
(check-sat)
