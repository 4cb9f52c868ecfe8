; An entry longer than the radius runs backwards only where the path turns by more than a right angle
;
; Clauses: [TRC-START-07], [TRC-WEDGE-02], [TRC-CORNER-03]
;
; The entry of length l > r ends at the inner corner with the next line, P + r·n(u1) - r·t·u1 with t = tan(|φ|/2).
; From S it leads l - r·t along u1; where d ≥ 0, that is more than nothing.
;
; Twin replaces: (assert (> l r))
; Twin has:      (assert (> l 0))
(set-logic QF_NRA)
(declare-const r Real)
(assert (> r 0))
(declare-const l Real) ; the distance from S to P
(assert (> l r))
(declare-const d Real) ; dot(u1, u2)
(assert (and (>= d 0) (<= d 1)))
(declare-const t Real) ; tan(|phi|/2)
(assert (and (>= t 0) (= (* t t (+ 1 d)) (- 1 d))))
(assert (not
  (> (- l (* r t)) 0)))
(check-sat)
