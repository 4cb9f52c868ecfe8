; How far the point of a change of side stands from the corner
;
; Clauses: [TRC-SIDE-02], [TRC-SIDE-05]
;
; The point V = P + r·n(u1) + σ·r·(1 + d)/c·u1 stands r·√(2/(1 - d)) from P: taken wherever it lies, it has no
; greatest distance, and it is within r·√2 where the path turns by a right angle or more. P is the origin and u1 the
; first axis.
;
; Twin replaces: (=> (<= d 0) (<= off (* 2 r r)))
; Twin has:      (=> (<= d 0) (< off (* 2 r r)))
(set-logic QF_NRA)
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
(define-fun off () Real (+ (* va va) (* vb vb)))
(assert (not
  (and
    (= (* off (- 1 d)) (* 2 r r))
    (=> (<= d 0) (<= off (* 2 r r))))))
(check-sat)
