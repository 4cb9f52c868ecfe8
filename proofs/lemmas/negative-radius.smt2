; A negative radius is a positive one on the other side
;
; Clauses: [TRC-SIDE-07], [TRC-PLANE-02], [TRC-PLANE-04]
;
; For ρ < 0 the vector ρ·n(u) and the offset radius R - σ·δ·ρ, computed with ρ itself on the side of the code, are
; those of the radius r = |ρ| on the other side: to compute with ρ as a number and to exchange the sides is one rule.
;
; Twin replaces: (define-fun r () Real (- rho))
; Twin has:      (define-fun r () Real rho)
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const rho Real)
(assert (< rho 0))
(define-fun r () Real (- rho))
(declare-const ua Real)
(declare-const ub Real)
(assert (= (+ (* ua ua) (* ub ub)) 1))
(declare-const big Real) ; R
(assert (> big 0))
(assert (not
  (and
    (= (* rho sigma (- ub)) (* r (- sigma) (- ub)))
    (= (* rho sigma ua) (* r (- sigma) ua))
    (= (- big (* sigma delta rho)) (- big (* (- sigma) delta r))))))
(check-sat)
