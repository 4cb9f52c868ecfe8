; An arc with R exists unless its chord is longer than its diameter
;
; Clauses: [TRC-ARC-01], [TRC-ARC-06]
;
; R² - q²/4 is not negative exactly when q ≤ 2·|R|: every arc with R has a centre or raises the alarm, never both.
;
; Twin replaces: (<= q (* 2 (mag radius)))
; Twin has:      (< q (* 2 (mag radius)))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const radius Real) ; R
(declare-const q Real)
(assert (> q 0))
(assert (not
  (= (>= (- (* radius radius) (/ (* q q) 4)) 0) (<= q (* 2 (mag radius))))))
(check-sat)
