; At a right angle the squared-off corner is the mitre
;
; Clauses: [TRC-CORNER-06], [TRC-CORNER-08]
;
; At an outer corner A, B and M are one point when d = 0, and A and B are two points whenever d < 0: the two clauses
; agree where one gives way to the other. P is the origin and u1 the first axis: frame-rotation says why that is no
; loss.
;
; Twin replaces: (and (= aa ba) (= ab bb) (= aa (* r t)))
; Twin has:      (and (= aa ba) (= ab bb) (= aa (* 2 r t)))
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
(assert (<= d 0))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun aa () Real (+ (* r n1a) r)) ; A = P + r*n(u1) + r*u1
(define-fun ab () Real (* r n1b))
(define-fun ba () Real (- (* r n2a) (* r d))) ; B = P + r*n(u2) - r*u2
(define-fun bb () Real (- (* r n2b) (* r c)))
(assert (not
  (ite (= d 0)
    (and (= aa ba) (= ab bb) (= aa (* r t)))
    (not (and (= aa ba) (= ab bb))))))
(check-sat)
