; When a line and a circle have a common point
;
; Clauses: [TRC-CORNER-05], [TRC-SIDE-02]
;
; A circle of radius R' > 0 and a line at the distance h ≥ 0 from its centre: every common point is away from the foot
; by the root of R'² - h², so that there is none when h > R'. The line is parallel to the first axis, the centre the
; origin.
;
; Twin replaces: (<= h big)
; Twin has:      (< h big)
(set-logic QF_NRA)
(declare-const big Real) ; R'
(declare-const h Real)
(assert (and (> big 0) (>= h 0)))
(declare-const x Real) ; a point of the line, (x, h), that lies on the circle
(assert (= (+ (* x x) (* h h)) (* big big)))
(assert (not
  (and (<= h big) (= (* x x) (- (* big big) (* h h))))))
(check-sat)
