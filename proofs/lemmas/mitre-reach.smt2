; The mitre of an obtuse corner stands between r and r·√2 from the corner
;
; Clauses: [TRC-CORNER-06]
;
; At an outer corner with d ≥ 0 the mitre is at least r and at most r·√2 away from P. P is the origin and u1 the first
; axis: frame-rotation says why that is no loss.
;
; Twin replaces: (assert (>= d 0))
; Twin has:      (assert (>= d (- (/ 1 2))))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(assert (>= d 0))
(declare-const t Real) ; tan(|phi|/2)
(assert (and (> d (- 1)) (= (* t (+ 1 d)) (mag c))))
(define-fun distance-squared () Real (+ (* r r) (* r t r t)))
(assert (not
  (and (<= (* r r) distance-squared) (<= distance-squared (* 2 r r)))))
(check-sat)
