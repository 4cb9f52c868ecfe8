; At an outer corner a lost look-ahead stands clear of the next line
;
; Clauses: [TRC-LOOK-03]
;
; At an outer corner the tool on the normal P + r·n(u1) is at least r away from every point of the next line, s·u2
; with s ≥ 0. P is the origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (assert (>= s 0))
; Twin has:      (assert (>= s (- 1)))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(declare-const s Real)
(assert (>= s 0))
(define-fun apart-a () Real (- (* r n1a) (* s d)))
(define-fun apart-b () Real (- (* r n1b) (* s c)))
(assert (not
  (>= (+ (* apart-a apart-a) (* apart-b apart-b)) (* r r))))
(check-sat)
