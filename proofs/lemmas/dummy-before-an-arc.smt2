; A dummy block of the arc's centre words points along its tangent
;
; Clauses: [TRC-DUMMY-03]
;
; With (a, b) the vector from the start to the centre, the tangent of the arc at its start is that of δ·perp(-(a, b)):
; (b, -a) for G03 and (-b, a) for G02, the dummy vector that the clause names.
;
; Twin replaces: (ite (= delta 1) b (- b))
; Twin has:      (ite (= delta 1) (- b) b)
(set-logic QF_NRA)
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(define-fun perp-a ((va Real) (vb Real)) Real (- vb))
(define-fun perp-b ((va Real) (vb Real)) Real va)
(declare-const a Real)
(declare-const b Real)
(define-fun dummy-a () Real (ite (= delta 1) b (- b)))
(define-fun dummy-b () Real (ite (= delta 1) (- a) a))
(assert (not
  (and
    (= (* delta (perp-a (- a) (- b))) dummy-a)
    (= (* delta (perp-b (- a) (- b))) dummy-b))))
(check-sat)
