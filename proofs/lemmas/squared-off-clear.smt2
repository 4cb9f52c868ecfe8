; A squared-off corner never comes nearer than r to the corner
;
; Clauses: [TRC-CORNER-08], [TRC-CORNER-09]
;
; At an outer corner with d ≤ 0, the reversal among them, every point of the straight line from A to B is at least r
; away from P. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (* qb qb)) (* r r))
; Twin has:      (* qb qb)) (* 2 r r))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(assert (<= d 0))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun aa () Real (+ (* r n1a) r)) ; A = P + r*n(u1) + r*u1
(define-fun ab () Real (* r n1b))
(define-fun ba () Real (- (* r n2a) (* r d))) ; B = P + r*n(u2) - r*u2
(define-fun bb () Real (- (* r n2b) (* r c)))
(declare-const k Real) ; the share of the way from A to B
(assert (and (>= k 0) (<= k 1)))
(define-fun qa () Real (+ aa (* k (- ba aa))))
(define-fun qb () Real (+ ab (* k (- bb ab))))
(assert (not
  (>= (+ (* qa qa) (* qb qb)) (* r r))))
(check-sat)
