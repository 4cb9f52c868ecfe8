; Start-up and cancel of type B are mirror images
;
; Clauses: [TRC-START-06], [TRC-CANCEL-05], [TRC-CORNER-06], [TRC-CORNER-08], [TRC-CORNER-15]
;
; Run the program of a start-up of type B backwards on the other side: its corner is inner, or below the smallest one,
; when the corner of the start-up is, and the vectors of the cancel are those of the start-up in reverse: the mitre M
; is the same point, A is B, B is A, and the normal put behind the last vector is the one put before the first. P is
; the origin and u1 the first axis.
;
; Twin replaces: (define-fun b2a () Real (- (* r n2a) (* r v2a)))
; Twin has:      (define-fun b2a () Real (+ (* r n2a) (* r v2a)))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(declare-const limit Real) ; the smallest corner
(declare-const t Real) ; tan(|phi|/2)
(assert (and (>= t 0) (=> (> d (- 1)) (= (* t t (+ 1 d)) (- 1 d)))))
; The start-up: u1 = (1, 0), then u2 = (d, c).
(define-fun inner1 () Bool (or (> (* sigma c) 0) (and (= c 0) (> d 0))))
(define-fun m1a () Real (* r t)) ; M = P + r*n(u1) + r*t*u1
(define-fun m1b () Real (* r sigma))
(define-fun a1a () Real r) ; A = P + r*n(u1) + r*u1
(define-fun a1b () Real (* r sigma))
(define-fun b1a () Real (- (* r sigma (- c)) (* r d))) ; B = P + r*n(u2) - r*u2
(define-fun b1b () Real (- (* r sigma d) (* r c)))
; The cancel: v1 = -u2, then v2 = -u1, on the side -sigma.
(define-fun v1a () Real (- d))
(define-fun v1b () Real (- c))
(define-fun v2a () Real (- 1))
(define-fun v2b () Real 0)
(define-fun c2 () Real (- (* v1a v2b) (* v1b v2a)))
(define-fun d2 () Real (+ (* v1a v2a) (* v1b v2b)))
(define-fun inner2 () Bool (or (> (* (- sigma) c2) 0) (and (= c2 0) (> d2 0))))
(define-fun n1a () Real (* (- sigma) (- v1b)))
(define-fun n1b () Real (* (- sigma) v1a))
(define-fun n2a () Real (* (- sigma) (- v2b)))
(define-fun n2b () Real (* (- sigma) v2a))
(define-fun m2a () Real (+ (* r n1a) (* r t v1a)))
(define-fun m2b () Real (+ (* r n1b) (* r t v1b)))
(define-fun a2a () Real (+ (* r n1a) (* r v1a)))
(define-fun a2b () Real (+ (* r n1b) (* r v1b)))
(define-fun b2a () Real (- (* r n2a) (* r v2a)))
(define-fun b2b () Real (- (* r n2b) (* r v2b)))
(assert (not
  (and
    (= inner1 inner2)
    (= (< (+ d limit) 0) (< (+ d2 limit) 0))
    (=> (and (not inner1) (> d (- 1))) (and (= m1a m2a) (= m1b m2b)))
    (= a1a b2a)
    (= a1b b2b)
    (= b1a a2a)
    (= b1b a2b)
    (= (* r n2a) 0)
    (= (* r n2b) (* r sigma)))))
(check-sat)
