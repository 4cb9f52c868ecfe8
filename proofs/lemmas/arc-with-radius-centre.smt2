; The centre of an arc with R is R away from both ends
;
; Clauses: [TRC-ARC-01]
;
; With q the chord's length, w its direction and m its midpoint, m ± √(R² - q²/4)·perp(w) is |R| away from start and
; end. The start is the origin and w the first axis.
;
; Twin replaces: (/ (* q q) 4)
; Twin has:      (/ (* q q) 2)
(set-logic QF_NRA)
(declare-const radius Real) ; R
(declare-const q Real)
(assert (> q 0))
(declare-const sign Real) ; s
(assert (or (= sign 1) (= sign (- 1))))
(declare-const root Real)
(assert (and (>= root 0) (= (* root root) (- (* radius radius) (/ (* q q) 4)))))
(define-fun ca () Real (/ q 2))
(define-fun cb () Real (* sign root))
(assert (not
  (and
    (= (+ (* ca ca) (* cb cb)) (* radius radius))
    (= (+ (* (- q ca) (- q ca)) (* cb cb)) (* radius radius)))))
(check-sat)
