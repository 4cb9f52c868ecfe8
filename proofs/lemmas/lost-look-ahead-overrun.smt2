; A lost look-ahead runs past the inner intersection by r·tan(|φ|/2)
;
; Clauses: [TRC-LOOK-03], [TRC-CORNER-03]
;
; The normal P + r·n(u1), where the tool ends without look-ahead, lies r·tan(|φ|/2) beyond the inner intersection, in
; the direction of u1 and on the same offset line. P is the origin and u1 the first axis: frame-rotation says why that
; is no loss.
;
; Twin replaces: (* r t)) (= (- (* r n1b) vb) 0)
; Twin has:      (* r c)) (= (- (* r n1b) vb) 0)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (> (* sigma c) 0) (and (= c 0) (> d 0)))) ; an inner corner
(declare-const t Real) ; tan(|phi|/2)
(assert (and (> d (- 1)) (= (* t (+ 1 d)) (mag c))))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(declare-const va Real) ; the inner intersection: r away from both lines
(declare-const vb Real)
(assert (not (= c 0)))
(assert (= (* sigma (cross 1 0 va vb)) r))
(assert (= (* sigma (cross d c va vb)) r))
(assert (not
  (and (= (- (* r n1a) va) (* r t)) (= (- (* r n1b) vb) 0))))
(check-sat)
