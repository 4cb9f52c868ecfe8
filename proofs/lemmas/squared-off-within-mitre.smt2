; Squaring off shortens the way: A and B stand at r·√2, the mitre farther
;
; Clauses: [TRC-CORNER-08]
;
; At an outer corner with d < 0 that is no reversal, A and B are r·√2 away from P, and the mitre that they replace is
; farther away. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (assert (< d 0))
; Twin has:      (assert (> d 0))
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
(declare-const t Real) ; tan(|phi|/2)
(assert (and (> d (- 1)) (= (* t (+ 1 d)) (mag c))))
(assert (< d 0))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun aa () Real (+ (* r n1a) r)) ; A = P + r*n(u1) + r*u1
(define-fun ab () Real (* r n1b))
(define-fun ba () Real (- (* r n2a) (* r d))) ; B = P + r*n(u2) - r*u2
(define-fun bb () Real (- (* r n2b) (* r c)))
(assert (not
  (and
    (= (+ (* aa aa) (* ab ab)) (* 2 r r))
    (= (+ (* ba ba) (* bb bb)) (* 2 r r))
    (> (+ (* r r) (* r t r t)) (* 2 r r)))))
(check-sat)
