; Arc, then arc: the vector at which the path turns away from the tool
;
; Clauses: [TRC-CORNER-14]
;
; V = C1 + a·e - σ·δ1·δ2·√(R1'² - a²)·perp(e) is R1' away from C1 and R2' from C2, and when the circles cross there
; σ·cross(t1, t2) < 0 with ti = δi·perp(V - Ci)/Ri'. C1 is the origin and e the first axis.
;
; Twin replaces: (- (* sigma delta1 delta2 root))
; Twin has:      (* sigma delta1 delta2 root)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const delta1 Real)
(assert (or (= delta1 1) (= delta1 (- 1))))
(declare-const delta2 Real)
(assert (or (= delta2 1) (= delta2 (- 1))))
(declare-const big1 Real) ; R1'
(declare-const big2 Real) ; R2'
(declare-const apart Real) ; D
(assert (and (> big1 0) (> big2 0) (> apart 0)))
(declare-const along Real) ; a
(assert (= (* 2 apart along) (+ (- (* big1 big1) (* big2 big2)) (* apart apart))))
(declare-const root Real) ; sqrt(R1'^2 - a^2)
(assert (and (>= root 0) (= (* root root) (- (* big1 big1) (* along along)))))
(define-fun va () Real along)
(define-fun vb () Real (- (* sigma delta1 delta2 root)))
(define-fun wa () Real (- va apart)) ; V - C2
(assert (not
  (and
    (= (+ (* va va) (* vb vb)) (* big1 big1))
    (= (+ (* wa wa) (* vb vb)) (* big2 big2))
    (=> (> root 0)
      (< (* sigma (cross (* delta1 (- vb)) (* delta1 va) (* delta2 (- vb)) (* delta2 wa))) 0)))))
(check-sat)
