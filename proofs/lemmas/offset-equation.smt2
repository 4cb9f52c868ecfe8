; One equation for the offset of a line and of an arc
;
; Clauses: [TRC-PLANE-04], [TRC-CORNER-04]
;
; Let P be the origin, n the normal of an arc there, κ = σ·δ/R and w = |z|² - r². The point z lies on the circle about
; the arc's centre n/κ with the radius R' exactly when z·n = r + w·κ/2; the equation of the offset line is that with κ
; = 0. The implementation forms inner corners by it.
;
; Twin replaces: (/ (* w curvature) 2)
; Twin has:      (* w curvature)
(set-logic QF_NRA)
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const r Real)
(assert (> r 0))
(declare-const na Real)
(declare-const nb Real)
(assert (= (+ (* na na) (* nb nb)) 1))
(declare-const inside Real) ; sigma*delta
(assert (or (= inside 1) (= inside (- 1))))
(declare-const big Real) ; R
(assert (> big 0))
(declare-const curvature Real)
(assert (= (* curvature big) inside))
(declare-const za Real)
(declare-const zb Real)
(define-fun w () Real (- (+ (* za za) (* zb zb)) (* r r)))
(define-fun ca () Real (* inside big na)) ; the centre, n/curvature
(define-fun cb () Real (* inside big nb))
(define-fun offset () Real (- big (* inside r))) ; R'
(define-fun on-circle () Bool (= (+ (* (- za ca) (- za ca)) (* (- zb cb) (- zb cb))) (* offset offset)))
(assert (not
  (= on-circle (= (dot za zb na nb) (+ r (/ (* w curvature) 2))))))
(check-sat)
