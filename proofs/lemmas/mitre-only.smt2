; Two offset lines have one common point
;
; Clauses: [TRC-CORNER-03], [TRC-CORNER-06]
;
; When the path turns, c ≠ 0, two points that both lie at the signed distance r from both lines are one point: the
; intersection that the clauses name is unique. P is the origin and u1 the first axis: frame-rotation says why that is
; no loss.
;
; Twin replaces: (assert (not (= c 0)))
; Twin has:      (assert (= c 0))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (not (= c 0)))
(declare-const pa Real)
(declare-const pb Real)
(declare-const qa Real)
(declare-const qb Real)
(define-fun on-both ((a Real) (b Real)) Bool (and (= (* sigma (cross 1 0 a b)) r) (= (* sigma (cross d c a b)) r)))
(assert (on-both pa pb))
(assert (on-both qa qb))
(assert (not
  (and (= pa qa) (= pb qb))))
(check-sat)
