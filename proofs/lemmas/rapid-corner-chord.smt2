; The chord of a rapid corner comes nearer than the radius to the corner
;
; Clauses: [TRC-CORNER-17], [TRC-CORNER-10]
;
; The middle of the chord from P + r·n(u1) to P + r·n(u2) stands r·√((1 + d)/2) from P: nearer than r wherever the
; path turns. P is the origin and u1 the first axis.
;
; Twin replaces: (assert (< d 1))
; Twin has:      (assert (<= d 1))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (< d 1))
(define-fun ma () Real (/ (* r sigma (- c)) 2))
(define-fun mb () Real (/ (+ (* r sigma) (* r sigma d)) 2))
(define-fun off () Real (+ (* ma ma) (* mb mb)))
(assert (not
  (and
    (= (* 2 off) (* r r (+ 1 d)))
    (< off (* r r)))))
(check-sat)
