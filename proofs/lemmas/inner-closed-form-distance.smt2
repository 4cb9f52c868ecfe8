; The closed form of an inner corner is consistent
;
; Clauses: [TRC-CORNER-04]
;
; The w of the closed form is |z|² - r², so that with inner-closed-form-curves and offset-equation z lies on both
; offset curves. Radius 1, P the origin, u1 the first axis, the tool on the left.
;
; Twin replaces: (* 2 half-w)
; Twin has:      (* 3 half-w)
(set-logic QF_NRA)
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (and (= (+ (* c c) (* d d)) 1) (> c 0))) ; an inner corner, the tool on the left
(declare-const t Real) ; tan(|phi|/2)
(assert (= (* t (+ 1 d)) c))
(declare-const k1 Real) ; r times the curvature of the first element, 0 for a line
(declare-const k2 Real)
(define-fun b () Real (- (+ 1 d) (+ k1 k2)))
(define-fun meets () Real (+ (- (+ 1 d) (* 2 (+ k1 k2))) (* 2 k1 k2)))
(declare-const root Real)
(assert (and (>= root 0) (= (* root root) (* (+ 1 d) meets))))
(declare-const share Real)
(assert (= (* share (+ b root)) 1))
(define-fun along-normal () Real (+ 1 (* share (- 1 d) k1)))
(define-fun back () Real (* t (+ 1 (* share (- k2 (* d k1))))))
(define-fun za () Real (- back)) ; z = along-normal*n1 - back*u1, with n1 = (0, 1)
(define-fun zb () Real along-normal)
(define-fun half-w () Real (* share (- 1 d)))
(assert (not
  (= (- (+ (* za za) (* zb zb)) 1) (* 2 half-w))))
(check-sat)
