; The inserted arc stays clear of both programmed lines
;
; Clauses: [TRC-CORNER-10]
;
; At an outer corner every point q of the circle of radius r about P that the arc passes between the two normals, in
; its sense δ = -σ, lies beyond the end of the first line and before the start of the second: P is the nearest point
; of both, and it is r away. A point lies between when it is turned from the first normal towards the second by less
; than a half turn, and the second from it. P is the origin and u1 the first axis: frame-rotation says why that is no
; loss.
;
; Twin replaces: (assert (>= (* delta (cross n1a n1b qa qb)) 0))
; Twin has:      (assert (>= (* delta (cross n1a n1b qa qb)) (- r)))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun delta () Real (- sigma))
(declare-const qa Real)
(declare-const qb Real)
(assert (= (+ (* qa qa) (* qb qb)) (* r r)))
(assert (>= (* delta (cross n1a n1b qa qb)) 0))
(assert (>= (* delta (cross qa qb n2a n2b)) 0))
(assert (not
  (and (>= (dot qa qb 1 0) 0) (<= (dot qa qb d c) 0))))
(check-sat)
