; The tangent of half the turn, by two quotients
;
; Clauses: [TRC-CORNER-03], [TRC-CORNER-06]
;
; Let t = |c| / (1 + d), for every turn but a reversal. Then t = tan(|φ|/2): t is not negative, and by the half-angle
; formulas d = (1 - t²) / (1 + t²) and |c| = 2t / (1 + t²). The other quotient, (1 - d) / |c|, is the same number.
;
; Twin replaces: (= (* t (mag c)) (- 1 d))
; Twin has:      (= (* t (mag c)) (+ 1 d))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(declare-const t Real) ; tan(|phi|/2)
(assert (and (> d (- 1)) (= (* t (+ 1 d)) (mag c))))
(assert (not
  (and
    (>= t 0)
    (= (* d (+ 1 (* t t))) (- 1 (* t t)))
    (= (* (mag c) (+ 1 (* t t))) (* 2 t))
    (= (* t (mag c)) (- 1 d)))))
(check-sat)
