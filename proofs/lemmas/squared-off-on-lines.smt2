; The two points of a squared-off corner stand on the offset lines
;
; Clauses: [TRC-CORNER-08], [TRC-PLANE-04]
;
; A lies on the first offset line, r beyond its normal, and B on the second one, r before its normal. P is the origin
; and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (* sigma (cross d c ba bb)) r)
; Twin has:      (* sigma (cross 1 0 ba bb)) r)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(define-fun aa () Real (+ (* r n1a) r)) ; A = P + r*n(u1) + r*u1
(define-fun ab () Real (* r n1b))
(define-fun ba () Real (- (* r n2a) (* r d))) ; B = P + r*n(u2) - r*u2
(define-fun bb () Real (- (* r n2b) (* r c)))
(assert (not
  (and
    (= (* sigma (cross 1 0 aa ab)) r)
    (= (dot aa ab 1 0) r)
    (= (* sigma (cross d c ba bb)) r)
    (= (dot ba bb d c) (- r)))))
(check-sat)
