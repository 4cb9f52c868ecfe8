; An entry move to its own normal touches the line that it stands for
;
; Clauses: [TRC-START-07], [TRC-PLANE-04]
;
; The entry goes from S to P + r·n(u1), u1 the direction from S to P: that vector is r away from the line through S
; and P, on the side in force, its nearest point on that line is P, and it lies the whole length of the entry ahead of
; S. S is the origin and u1 the first axis.
;
; Twin replaces: (= (* sigma (cross 1 0 va vb)) r)
; Twin has:      (= (cross 1 0 va vb) r)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const l Real) ; the distance from S to P
(assert (> l r))
(define-fun va () Real l)
(define-fun vb () Real (* r sigma))
(assert (not
  (and
    (= (* sigma (cross 1 0 va vb)) r)
    (= (dot (- va l) vb 1 0) 0)
    (= (dot va vb 1 0) l))))
(check-sat)
