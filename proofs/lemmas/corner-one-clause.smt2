; Every corner is formed by exactly one clause
;
; Clauses: [TRC-CORNER-01], [TRC-CORNER-02], [TRC-CORNER-03], [TRC-CORNER-04], [TRC-CORNER-06], [TRC-CORNER-07], [TRC-CORNER-08], [TRC-CORNER-09], [TRC-CORNER-10]
;
; For every turn (c, d), c² + d² = 1, either side, lines or arcs, and either outer corner in force, exactly one of
; these holds: tangent (02); inner with two lines (03) or an arc (04); outer formed by an arc (10); outer by
; intersection and turning back (09), else acute (08), else with an arc (07), else of two lines (06).
;
; Twin replaces: (define-fun c08 () Bool (and outer (not round) (not back) (< d 0)))
; Twin has:      (define-fun c08 () Bool (and outer (not round) (not back) (<= d 0)))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(declare-const an-arc Bool) ; an arc on one side or both
(declare-const round Bool) ; outer corners are formed by an arc
(define-fun inner () Bool (or (> (* sigma c) 0) (and (= c 0) (> d 0))))
(define-fun outer () Bool (not inner))
(define-fun tangent () Bool (and (= c 0) (> d 0)))
(define-fun back () Bool (and (= c 0) (< d 0)))
(define-fun c02 () Bool tangent)
(define-fun c03 () Bool (and inner (not tangent) (not an-arc)))
(define-fun c04 () Bool (and inner (not tangent) an-arc))
(define-fun c06 () Bool (and outer (not round) (>= d 0) (not an-arc)))
(define-fun c07 () Bool (and outer (not round) (>= d 0) an-arc))
(define-fun c08 () Bool (and outer (not round) (not back) (< d 0)))
(define-fun c09 () Bool (and outer (not round) back))
(define-fun c10 () Bool (and outer round))
(define-fun one ((holds Bool)) Real (ite holds 1 0))
(assert (not
  (= (+ (one c02) (one c03) (one c04) (one c06) (one c07) (one c08) (one c09) (one c10)) 1)))
(check-sat)
