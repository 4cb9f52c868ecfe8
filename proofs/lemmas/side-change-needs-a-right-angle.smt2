; Lines change side at a contact point when the path turns by a right angle or more
;
; Clauses: [TRC-SIDE-02], [TRC-SIDE-03]
;
; |(1 + d)/c| ≤ 1 exactly when d ≤ 0: V lies within r of both offset ends at P exactly when the path turns by at least
; a right angle, to either side. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (= (<= (mag k) 1) (<= d 0))
; Twin has:      (= (<= (mag k) 1) (< d 0))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (not (= c 0)))
(declare-const k Real) ; (1 + d)/c
(assert (= (* k c) (+ 1 d)))
(define-fun va () Real (* sigma r k))
(define-fun vb () Real (* sigma r))
(assert (not
  (= (<= (mag k) 1) (<= d 0))))
(check-sat)
