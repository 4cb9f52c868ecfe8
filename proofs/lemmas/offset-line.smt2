; The offset line keeps the radius from its line
;
; Clauses: [TRC-PLANE-04]
;
; Every point of the line moved by r·n(u) is at least r away from every point of the line, and r away from the one
; beside it. The line is the first axis.
;
; Twin replaces: (>= (+ (* apart apart) (* r r)) (* r r))
; Twin has:      (> (+ (* apart apart) (* r r)) (* r r))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const x Real) ; a point of the offset line, (x, sigma*r)
(declare-const y Real) ; a point of the line, (y, 0)
(define-fun apart () Real (- x y))
(define-fun across () Real (* sigma r))
(assert (not
  (and (= (* across across) (* r r)) (>= (+ (* apart apart) (* r r)) (* r r)))))
(check-sat)
