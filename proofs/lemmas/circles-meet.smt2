; Otherwise the root of two circles exists
;
; Clauses: [TRC-CORNER-04], [TRC-CORNER-05]
;
; When |R1' - R2'| ≤ D ≤ R1' + R2' and D > 0, R1'² - a² is not negative: the clause that forms the vector and the
; clause that raises the alarm are complete and disjoint.
;
; Twin replaces: (<= apart (+ big1 big2))
; Twin has:      (<= apart (+ big1 big2 1))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const big1 Real) ; R1'
(declare-const big2 Real) ; R2'
(declare-const apart Real) ; D
(assert (and (> big1 0) (> big2 0) (> apart 0)))
(assert (and (<= apart (+ big1 big2)) (>= apart (mag (- big1 big2)))))
(declare-const along Real) ; a
(assert (= (* 2 apart along) (+ (- (* big1 big1) (* big2 big2)) (* apart apart))))
(assert (not
  (>= (- (* big1 big1) (* along along)) 0)))
(check-sat)
