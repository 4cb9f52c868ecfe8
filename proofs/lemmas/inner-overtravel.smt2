; A line between two inner corners runs backwards when both cut off more than its length
;
; Clauses: [TRC-WEDGE-02], [TRC-CORNER-03]
;
; On a line of length l between inner corners of two lines, whose vectors stand r·t1 behind its start and r·t2 before
; its end, the centre travels l - r·(t1 + t2) along it: backwards exactly when r·(t1 + t2) > l. The line lies on the
; first axis and starts at the origin.
;
; Twin replaces: (> (* r (+ t1 t2)) l)
; Twin has:      (>= (* r (+ t1 t2)) l)
(set-logic QF_NRA)
(define-fun dot ((va Real) (vb Real) (wa Real) (wb Real)) Real (+ (* va wa) (* vb wb)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const l Real)
(declare-const t1 Real)
(declare-const t2 Real)
(assert (and (> l 0) (>= t1 0) (>= t2 0)))
(define-fun start-a () Real (* r t1))
(define-fun end-a () Real (- l (* r t2)))
(define-fun across () Real (* r sigma))
(assert (not
  (= (< (dot (- end-a start-a) (- across across) 1 0) 0) (> (* r (+ t1 t2)) l))))
(check-sat)
