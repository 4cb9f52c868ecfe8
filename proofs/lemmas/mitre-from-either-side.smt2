; The mitre is the same point from either line
;
; Clauses: [TRC-CORNER-06], [TRC-CORNER-08]
;
; At an outer corner that is no reversal, going r·tan(|φ|/2) forward from the first normal and going as far back from
; the second one leads to one point: a program run backwards on the other side has the same mitre. P is the origin and
; u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (- (* r n2b) (* r t c))
; Twin has:      (+ (* r n2b) (* r t c))
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
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(assert (not
  (and
    (= (+ (* r n1a) (* r t)) (- (* r n2a) (* r t d)))
    (= (* r n1b) (- (* r n2b) (* r t c))))))
(check-sat)
