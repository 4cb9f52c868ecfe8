; The closed form of an inner corner satisfies both offset equations
;
; Clauses: [TRC-CORNER-04]
;
; The closed form by which the implementation forms an inner corner, with w/2 = share·(1 - d) and share = 1/(b + √Δ):
; z·n1 = r + w·κ1/2 and z·n2 = r + w·κ2/2. Radius 1, P the origin, u1 the first axis, the tool on the left: by frame-
; rotation, frame-mirror and a change of unit that is no loss.
;
; Twin replaces: (* share (- k2 (* d k1)))
; Twin has:      (* share (- k1 (* d k2)))
(set-logic QF_NRA)
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
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
  (and
    (= (dot za zb 0 1) (+ 1 (* half-w k1)))
    (= (dot za zb (- c) d) (+ 1 (* half-w k2))))))
(check-sat)
