; R > 0 names the arc of at most a half turn
;
; Clauses: [TRC-ARC-01]
;
; With s = δ for R > 0 and -δ for R < 0, the turn from the start's ray to the end's in the sense δ is at most a half
; turn, δ·cross(ray, ray') ≥ 0, for R > 0, and at least a half turn, ≤ 0, for R < 0. The start is the origin and the
; chord lies on the first axis.
;
; Twin replaces: (ite (> radius 0) delta (- delta))
; Twin has:      (ite (> radius 0) (- delta) delta)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const radius Real) ; R
(assert (not (= radius 0)))
(declare-const q Real)
(assert (> q 0))
(declare-const root Real)
(assert (and (>= root 0) (= (* root root) (- (* radius radius) (/ (* q q) 4)))))
(define-fun ca () Real (/ q 2))
(define-fun cb () Real (* (ite (> radius 0) delta (- delta)) root))
(define-fun turn () Real (* delta (cross (- ca) (- cb) (- q ca) (- cb))))
(assert (not
  (ite (> radius 0) (>= turn 0) (<= turn 0))))
(check-sat)
