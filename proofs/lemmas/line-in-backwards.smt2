; The move to the normal of an arc runs backwards at inner corners only
;
; Clauses: [TRC-LOOK-05]
;
; From the normal that a lost look-ahead leaves, P + r·n(u1), to the arc's own normal, P + r·n(u2): the move runs
; against the tangent u2 exactly when σ·c > 0, at an inner corner. P is the origin and u1 the first axis: frame-
; rotation says why that is no loss.
;
; Twin replaces: (> (* sigma c) 0)
; Twin has:      (< (* sigma c) 0)
(set-logic QF_NRA)
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun move-a () Real (* r (- n2a n1a)))
(define-fun move-b () Real (* r (- n2b n1b)))
(assert (not
  (= (< (dot move-a move-b d c) 0) (> (* sigma c) 0))))
(check-sat)
