; The inner intersection lies at distance r on the tool side of both lines
;
; Clauses: [TRC-CORNER-03], [TRC-PLANE-04]
;
; At an inner corner P + r·n(u1) - r·tan(|φ|/2)·u1 lies at the signed distance r from both programmed lines. P is the
; origin and u1 the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (define-fun va () Real (- (* r t)))
; Twin has:      (define-fun va () Real (* r t))
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
(define-fun va () Real (- (* r t)))
(define-fun vb () Real (* r sigma))
(assert (not
  (and
    (= (* sigma (cross 1 0 va vb)) r)
    (= (* sigma (cross d c va vb)) r))))
(check-sat)
