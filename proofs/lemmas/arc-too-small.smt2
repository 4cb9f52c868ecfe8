; A tool greater than the arc that it runs in cuts the other side
;
; Clauses: [TRC-ARC-05]
;
; With the tool inside and R < r the vector is nearer than r to the point of the circle opposite: the alarm is due. At
; R = r it is exactly r away from all of the circle, being its centre. C is the origin, and the arc's point lies on
; the first axis.
;
; Twin replaces: (assert (> r big))
; Twin has:      (assert (>= r big))
(set-logic QF_NRA)
(declare-const r Real)
(assert (> r 0))
(declare-const big Real) ; R
(assert (> big 0))
(assert (> r big))
(define-fun offset () Real (- big r)) ; R'
(define-fun opposite () Real (- big))
(define-fun apart () Real (- offset opposite))
(assert (not
  (< (* apart apart) (* r r))))
(check-sat)
