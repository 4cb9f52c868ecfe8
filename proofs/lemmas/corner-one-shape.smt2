; Every corner has exactly one shape
;
; Clauses: [TRC-CORNER-01], [TRC-CORNER-02], [TRC-CORNER-03], [TRC-CORNER-04], [TRC-CORNER-06], [TRC-CORNER-08], [TRC-CORNER-09], [TRC-CORNER-10], [TRC-CORNER-13], [TRC-CORNER-14], [TRC-CORNER-16]
;
; For every turn (c, d), either side, lines or arcs, every outer corner in force, either extension of arcs, every
; limit angle and every turn that counts as straight, exactly one of these holds: tangent (02); straight (16); inner
; with two lines (03) or an arc (04); outer by an arc (10), below a limit angle (13) too; outer by intersection and
; extended by the arcs themselves (14), or else one point of an obtuse corner (06), one point of an acute one (13),
; squared off (08), squared off at a reversal (09).
;
; Twin replaces: (define-fun above () Bool (and (>= (+ d limit) 0) (not back)))
; Twin has:      (define-fun above () Bool (>= (+ d limit) 0))
(set-logic QF_NRA)
(declare-const sigma Real) ; +1 left, -1 right
(assert (or (= sigma 1) (= sigma (- 1))))
(declare-const c Real) ; u1 = (1, 0) and u2 = (d, c): cross(u1, u2) = c, dot(u1, u2) = d
(declare-const d Real)
(assert (= (+ (* c c) (* d d)) 1))
(declare-const an-arc Bool) ; an arc on one side or both
(declare-const curve Bool) ; arc-extension is curve
(declare-const round Bool) ; the outer corner in force is arc
(declare-const limited Bool) ; it is limit-angle
(assert (not (and round limited)))
(declare-const limit Real) ; corner-limit-cosine
(assert (and (>= limit 0) (<= limit 1)))
(declare-const band Real) ; straight-band-cosine; 0: none
(assert (and (>= band 0) (<= band 1)))
(define-fun tangent () Bool (and (= c 0) (> d 0)))
(define-fun back () Bool (and (= c 0) (< d 0)))
(define-fun straight () Bool (and (> band 0) (>= d band)))
(define-fun formed () Bool (not (or tangent straight)))
(define-fun inner () Bool (and formed (> (* sigma c) 0)))
(define-fun outer () Bool (and formed (or (< (* sigma c) 0) back)))
(define-fun above () Bool (and (>= (+ d limit) 0) (not back)))
(define-fun below () Bool (or (< (+ d limit) 0) back))
(define-fun crossed () Bool (and outer (not round) (=> limited above))) ; by intersection
(define-fun tangents () Bool (not (and curve an-arc)))
(define-fun c02 () Bool tangent)
(define-fun c16 () Bool (and straight (not tangent)))
(define-fun c03 () Bool (and inner (not an-arc)))
(define-fun c04 () Bool (and inner an-arc))
(define-fun c10 () Bool (and outer (or round (and limited below))))
(define-fun c14 () Bool (and crossed curve an-arc))
(define-fun c06 () Bool (and crossed tangents (>= d 0)))
(define-fun c13 () Bool (and crossed tangents limited (< d 0)))
(define-fun c08 () Bool (and crossed tangents (not limited) (< d 0) (not (= c 0))))
(define-fun c09 () Bool (and crossed tangents (not limited) (< d 0) (= c 0)))
(define-fun one ((holds Bool)) Real (ite holds 1 0))
(assert (not
  (= (+ (one c02) (one c16) (one c03) (one c04) (one c10) (one c14) (one c06) (one c13) (one c08) (one c09)) 1)))
(check-sat)
