; A limit angle bounds how far the point of a corner stands off
;
; Clauses: [TRC-CORNER-13], [TRC-CORNER-06]
;
; At a corner formed by intersection down to a limit angle with the cosine L < 1, d + L ≥ 0, the point M = P + r·n(u1)
; + r·t·u1 stands no farther than r·√(2/(1 - L)) from the corner; at the limit itself exactly so far.
;
; Twin replaces: (assert (>= (+ d limit) 0))
; Twin has:      (assert (>= (+ d limit) (- 1)))
(set-logic QF_NRA)
(declare-const r Real)
(assert (> r 0))
(declare-const limit Real) ; the cosine of the limit
(assert (and (>= limit 0) (< limit 1)))
(declare-const d Real) ; dot(u1, u2)
(assert (and (> d (- 1)) (<= d 1)))
(assert (>= (+ d limit) 0))
(declare-const t Real) ; tan(|phi|/2)
(assert (and (>= t 0) (= (* t t (+ 1 d)) (- 1 d))))
(define-fun off () Real (+ (* r r) (* r t r t))) ; the square of the distance from P to M
(assert (not
  (and
    (<= (* off (- 1 limit)) (* 2 r r))
    (=> (= (+ d limit) 0) (= (* off (- 1 limit)) (* 2 r r))))))
(check-sat)
