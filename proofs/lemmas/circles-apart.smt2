; Two circles far apart, or one within the other, have no common point
;
; Clauses: [TRC-CORNER-05], [TRC-SIDE-02]
;
; Circles of radius R1' > 0 and R2' > 0, their centres D > 0 apart: no point lies on both when D > R1' + R2' or when D
; < |R1' - R2'|. The first centre is the origin, the second lies on the first axis.
;
; Twin replaces: (< apart (mag (- big1 big2)))
; Twin has:      (<= apart (mag (- big1 big2)))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const big1 Real) ; R1'
(declare-const big2 Real) ; R2'
(declare-const apart Real) ; D
(assert (and (> big1 0) (> big2 0) (> apart 0)))
(assert (or (> apart (+ big1 big2)) (< apart (mag (- big1 big2)))))
(declare-const x Real)
(declare-const y Real)
(assert (not
  (not (and
    (= (+ (* x x) (* y y)) (* big1 big1))
    (= (+ (* (- x apart) (- x apart)) (* y y)) (* big2 big2))))))
(check-sat)
