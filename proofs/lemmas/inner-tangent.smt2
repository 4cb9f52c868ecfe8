; A tangent junction is the limit of the inner corner
;
; Clauses: [TRC-CORNER-02], [TRC-CORNER-03]
;
; When c = 0 and d > 0 the two normals are one and the formula of the inner corner names it too: the two clauses do
; not contradict each other where the text counts a tangent junction among the inner corners. P is the origin and u1
; the first axis: frame-rotation says why that is no loss.
;
; Twin replaces: (assert (and (= c 0) (> d 0)))
; Twin has:      (assert (= c 0))
(set-logic QF_NRA)
(define-fun mag ((v Real)) Real (ite (>= v 0) v (- v)))
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const r Real)
(assert (> r 0))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(assert (and (= c 0) (> d 0)))
(declare-const t Real) ; tan(|phi|/2)
(assert (= (* t (+ 1 d)) (mag c)))
(define-fun n1a () Real 0)
(define-fun n1b () Real sigma)
(define-fun n2a () Real (- (* sigma c)))
(define-fun n2b () Real (* sigma d))
(assert (not
  (and
    (= (* r n1a) (* r n2a))
    (= (* r n1b) (* r n2b))
    (= (- (* r n1a) (* r t)) (* r n2a)))))
(check-sat)
