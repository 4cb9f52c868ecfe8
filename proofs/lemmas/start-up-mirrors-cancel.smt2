; Start-up and cancel are mirror images
;
; Clauses: [TRC-START-02], [TRC-START-08], [TRC-CANCEL-01], [TRC-CANCEL-02], [TRC-CANCEL-06]
;
; Take any start-up: from S in a straight line to P + r·n(u2) on side σ. Run the program backwards on the other side:
; the element behind P ends there with the tangent -u2, and the cancel block goes from the vector that it leaves to S.
; The vector is the same point, so that the two moves are one segment in opposite directions. With S = P that
; is start-up and cancel without movement, type C.
;
; Twin replaces: (* (- sigma) (- ua))
; Twin has:      (* sigma (- ua))
(set-logic QF_NRA)
(define-fun perp-a ((va Real) (vb Real)) Real (- vb))
(define-fun perp-b ((va Real) (vb Real)) Real va)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const pa Real) ; P
(declare-const pb Real)
(declare-const ua Real) ; u2
(declare-const ub Real)
(assert (= (+ (* ua ua) (* ub ub)) 1))
(define-fun start-a () Real (+ pa (* r (* sigma (- ub))))) ; the vector of start-up
(define-fun start-b () Real (+ pb (* r (* sigma ua))))
(define-fun end-a () Real (+ pa (* r (* (- sigma) (- (- ub)))))) ; the vector before the cancel block
(define-fun end-b () Real (+ pb (* r (* (- sigma) (- ua)))))
(assert (not
  (and (= start-a end-a) (= start-b end-b))))
(check-sat)
