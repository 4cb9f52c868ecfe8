; Arc, then line: the vector at which the path turns away from the tool
;
; Clauses: [TRC-CORNER-14]
;
; V = F + σ·δ·√(R'² - h²)·u2 lies on the offset line and on the circle of radius R' about C, and when the two cross
; there the path turns away from the tool's side: σ·cross(t1, u2) < 0 with t1 = δ·perp(V - C)/R'. Where they touch it
; is the vector of an inner corner too. P is the origin and u2 the first axis.
;
; Twin replaces: (define-fun va () Real (+ fa (* sigma delta root)))
; Twin has:      (define-fun va () Real (- fa (* sigma delta root)))
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const ca Real) ; the centre; P is the origin, u2 = (1, 0)
(declare-const cb Real)
(declare-const big Real) ; R'
(assert (> big 0))
(define-fun fa () Real ca) ; F, the foot of the perpendicular from C on the offset line
(define-fun fb () Real (* sigma r))
(define-fun h () Real (- cb fb))
(declare-const root Real) ; sqrt(R'^2 - h^2)
(assert (and (>= root 0) (= (* root root) (- (* big big) (* h h)))))
(define-fun va () Real (+ fa (* sigma delta root)))
(define-fun vb () Real fb)
(define-fun wa () Real (- va ca))
(define-fun wb () Real (- vb cb))
(assert (not
  (and
    (= (* sigma (cross 1 0 va vb)) r)
    (= (+ (* wa wa) (* wb wb)) (* big big))
    (=> (= root 0) (and (= va fa) (= vb fb)))
    (=> (> root 0) (< (* sigma (cross (* delta (- wb)) (* delta wa) 1 0)) 0)))))
(check-sat)
