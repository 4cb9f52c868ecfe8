; A line and a tangent arc have no point that counts at a change of side
;
; Clauses: [TRC-SIDE-05], [TRC-SIDE-03]
;
; The centre of the arc is P + δ·R·perp(u1), and on the new side -σ its offset has R' = R + σ·δ·r. When the arc bends
; to the old side, σ·δ = 1, the offset curves have two common points, equally near to P, so that neither counts; when it
; bends to the new side they have none. P is the origin and u1 the first axis.
;
; Twin replaces: (define-fun offset () Real (+ big (* sigma delta r)))
; Twin has:      (define-fun offset () Real (- big (* sigma delta r)))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const delta Real) ; +1 for G03, -1 for G02
(assert (or (= delta 1) (= delta (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const big Real) ; R
(assert (> big r))
(define-fun ca () Real 0) ; C
(define-fun cb () Real (* delta big))
(define-fun offset () Real (+ big (* sigma delta r))) ; R'
(define-fun h () Real (- cb (* sigma r)))
(define-fun square () Real (- (* offset offset) (* h h)))
(declare-const root Real)
(assert (and (>= root 0) (=> (>= square 0) (= (* root root) square))))
(define-fun va () Real (+ ca root)) ; one point, and the other
(define-fun wa () Real (- ca root))
(define-fun vb () Real (* sigma r))
(assert (not
  (and
    (= (> square 0) (= (* sigma delta) 1))
    (=> (= (* sigma delta) (- 1)) (< square 0))
    (=> (> square 0) (and (not (= va wa)) (= (+ (* va va) (* vb vb)) (+ (* wa wa) (* vb vb))))))))
(check-sat)
