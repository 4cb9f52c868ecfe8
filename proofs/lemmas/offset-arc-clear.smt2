; The offset of an arc keeps the radius from the whole circle
;
; Clauses: [TRC-PLANE-04], [TRC-ARC-05]
;
; When the tool runs outside the arc, or inside one with R ≥ r, the vector at a point of the arc is at least r away
; from every point Q of the arc's circle. C is the origin, and the point of the arc lies on the first axis.
;
; Twin replaces: (or (= inside (- 1)) (>= big r))
; Twin has:      (or (= inside (- 1)) (>= (* 2 big) r))
(set-logic QF_NRA)
(declare-const r Real)
(assert (> r 0))
(declare-const inside Real) ; sigma*delta: +1 when the tool runs inside
(assert (or (= inside 1) (= inside (- 1))))
(declare-const big Real) ; R
(assert (> big 0))
(assert (or (= inside (- 1)) (>= big r)))
(define-fun offset () Real (- big (* inside r))) ; R'
(declare-const qa Real)
(declare-const qb Real)
(assert (= (+ (* qa qa) (* qb qb)) (* big big)))
(define-fun apart () Real (- offset qa))
(assert (not
  (>= (+ (* apart apart) (* qb qb)) (* r r))))
(check-sat)
