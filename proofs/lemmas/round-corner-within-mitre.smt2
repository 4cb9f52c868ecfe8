; The inserted arc is tangent to the lines of the mitre
;
; Clauses: [TRC-CORNER-06], [TRC-CORNER-10]
;
; At an outer corner that is no reversal no point of the inserted arc lies beyond the offset lines that the mitre
; extends: the arc cuts the mitre's corner off. P is the origin and u1 the first axis: frame-rotation says why that is
; no loss.
;
; Twin replaces: (<= (* sigma (cross d c qa qb)) r)
; Twin has:      (< (* sigma (cross d c qa qb)) r)
(set-logic QF_NRA)
(define-fun cross ((va Real) (vb Real) (wa Real) (wb Real)) Real (- (* va wb) (* vb wa)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (or (< (* sigma c) 0) (and (= c 0) (< d 0)))) ; an outer corner
(declare-const qa Real)
(declare-const qb Real)
(assert (= (+ (* qa qa) (* qb qb)) (* r r)))
(assert (not
  (and (<= (* sigma (cross 1 0 qa qb)) r) (<= (* sigma (cross d c qa qb)) r))))
(check-sat)
