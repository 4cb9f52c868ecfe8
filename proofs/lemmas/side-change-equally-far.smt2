; The point of a change of side lies as far along both lines
;
; Clauses: [TRC-SIDE-02]
;
; Measured from P along the path, V lies as far along the first line as along the second, σ·r·(1 + d)/c; so one
; comparison with r tells how far V lies beyond either offset line's end at P. P is the origin and u1 the first axis:
; frame-rotation says why that is no loss.
;
; Twin replaces: (= (dot va vb d c) (* sigma r k))
; Twin has:      (= (dot va vb d c) (- (* sigma r k)))
(set-logic QF_NRA)
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
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
(assert (not
  (and (= (dot va vb 1 0) (* sigma r k)) (= (dot va vb d c) (* sigma r k)))))
(check-sat)
