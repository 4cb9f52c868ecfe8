; Arc, then arc: the vector lies on both circles
;
; Clauses: [TRC-CORNER-04]
;
; V = C1 + a·e + σ·δ1·δ2·√(R1'² - a²)·perp(e) with a = (R1'² - R2'² + D²) / (2·D) is R1' away from C1 and R2' from C2.
; C1 is the origin and e the first axis.
;
; Twin replaces: (assert (= (* 2 apart along) (+
; Twin has:      (assert (= (* 1 apart along) (+
(set-logic QF_NRA)
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
(define-fun vb () Real (* sigma delta1 delta2 root))
(define-fun wa () Real (- va apart)) ; V - C2
(assert (not
  (and
    (= (+ (* va va) (* vb vb)) (* big1 big1))
    (= (+ (* wa wa) (* vb vb)) (* big2 big2)))))
(check-sat)
