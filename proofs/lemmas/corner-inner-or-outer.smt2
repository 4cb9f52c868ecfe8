; Every corner is inner or outer, never both
;
; Clauses: [TRC-CORNER-01]
;
; With c = cross(u1, u2) and d = dot(u1, u2) of two unit tangents, on either side: a corner is inner when σ·c > 0 or
; when c = 0 and d > 0; it is outer when σ·c < 0 or when c = 0 and d < 0. Exactly one of the two holds: c and d are
; never both zero.
;
; Twin replaces: (or (< sc 0) (and (= c 0) (< d 0)))
; Twin has:      (or (< sc 0) (and (= c 0) (<= d 0) (< sc 0)))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const ua Real)
(declare-const ub Real)
(assert (= (+ (* ua ua) (* ub ub)) 1))
(declare-const va Real)
(declare-const vb Real)
(assert (= (+ (* va va) (* vb vb)) 1))
(define-fun c () Real (cross ua ub va vb))
(define-fun d () Real (dot ua ub va vb))
(define-fun sc () Real (* sigma c))
(define-fun inner () Bool (or (> sc 0) (and (= c 0) (> d 0))))
(define-fun outer () Bool (or (< sc 0) (and (= c 0) (< d 0))))
(assert (not
  (xor inner outer)))
(check-sat)
