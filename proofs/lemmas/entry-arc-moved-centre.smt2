; The moved centre of an arc as entry is as far from S as from V
;
; Clauses: [TRC-START-09], [TRC-ARC-04]
;
; B = V + k·(C - V) with k = dot(S - V, S - V)/(2·dot(S - V, C - V)) is as far from S as from V, and where dot(S - V,
; C - V) > 0 it lies on the same side of V as C: the circle about B, run in the sense of the arc, has the direction of
; the arc at V. V is the origin and C lies on the first axis, at a distance of any sign but zero.
;
; Twin replaces: (assert (> (* sa ca) 0))
; Twin has:      (assert (not (= (* sa ca) 0)))
(set-logic QF_NRA)
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const ca Real) ; C - V
(declare-const sa Real) ; S - V
(declare-const sb Real)
(assert (> (* sa ca) 0))
(declare-const k Real)
(assert (= (* 2 k (* sa ca)) (+ (* sa sa) (* sb sb))))
(define-fun ba () Real (* k ca)) ; B - V
(define-fun along () Real (* delta (- ca))) ; the direction about C at V, perp(V - C) times delta, second coordinate
(define-fun along-b () Real (* delta (- ba))) ; about B
(assert (not
  (and
    (= (+ (* (- sa ba) (- sa ba)) (* sb sb)) (* ba ba))
    (> (* along along-b) 0))))
(check-sat)
