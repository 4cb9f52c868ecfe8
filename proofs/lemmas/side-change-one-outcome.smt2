; A change of side has exactly one outcome
;
; Clauses: [TRC-SIDE-02], [TRC-SIDE-03]
;
; Of up to two common points, each of which counts or not, at distances f and g from P: exactly one of the first, the
; second, and no point is taken.
;
; Twin replaces: (< g f)
; Twin has:      (<= g f)
(set-logic QF_NRA)
(declare-const first Bool) ; the first point exists and counts
(declare-const second Bool)
(declare-const f Real)
(declare-const g Real)
(define-fun takes-first () Bool (and first (or (not second) (< f g))))
(define-fun takes-second () Bool (and second (or (not first) (< g f))))
(define-fun takes-none () Bool (or (and (not first) (not second)) (and first second (= f g))))
(define-fun one ((holds Bool)) Real (ite holds 1 0))
(assert (not
  (= (+ (one takes-first) (one takes-second) (one takes-none)) 1)))
(check-sat)
