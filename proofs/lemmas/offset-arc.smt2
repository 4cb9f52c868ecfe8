; The vectors of an arc lie on a circle about its centre
;
; Clauses: [TRC-PLANE-04], [TRC-ARC-04]
;
; With u = δ·perp(e) the tangent at C + R·e, the vector P + r·n(u) is C + R'·e with R' = R - σ·δ·r: it stands on the
; ray from C through P, for every arc and side. C is the origin.
;
; Twin replaces: (- big (* sigma delta r))
; Twin has:      (+ big (* sigma delta r))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const ea Real) ; the ray from the centre, the origin, to a point of the arc
(declare-const eb Real)
(assert (= (+ (* ea ea) (* eb eb)) 1))
(declare-const big Real) ; R
(assert (> big 0))
(define-fun ua () Real (* delta (- eb))) ; the tangent there
(define-fun ub () Real (* delta ea))
(define-fun va () Real (+ (* big ea) (* r (* sigma (- ub))))) ; P + r*n(u)
(define-fun vb () Real (+ (* big eb) (* r (* sigma ua))))
(define-fun offset () Real (- big (* sigma delta r))) ; R'
(assert (not
  (and (= va (* offset ea)) (= vb (* offset eb)))))
(check-sat)
