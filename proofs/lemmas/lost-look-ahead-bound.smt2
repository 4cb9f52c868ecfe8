; A lost look-ahead cuts no deeper than r·tan(|φ|/2)
;
; Clauses: [TRC-LOOK-03], [TRC-LOOK-06]
;
; At an inner corner the depth r·(1 - d) by which the tool enters the next line's side is at most r·tan(|φ|/2), the
; length by which it has run past the inner intersection, and not negative. P is the origin and u1 the first axis:
; frame-rotation says why that is no loss.
;
; Twin replaces: (* r t))
; Twin has:      (* r t d))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (> (* sigma c) 0) (and (= c 0) (> d 0)))) ; an inner corner
(declare-const t Real) ; tan(|phi|/2)
(assert (and (> d (- 1)) (= (* t (+ 1 d)) (mag c))))
(assert (not
  (and (>= (* r (- 1 d)) 0) (<= (* r (- 1 d)) (* r t)))))
(check-sat)
