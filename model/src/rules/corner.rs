//! Corners: `spec/clauses/04-corner.md`.

use core::cmp::Ordering;

use radcomp_spec::clause;
use radcomp_spec::parameters::{CornerOwner, Reversal};
use radcomp_spec::{AdvisoryKind, AlarmKind, DecisionKind, Direction, OuterCorner, Segment, Side};

use super::inner;
use super::junction::{Junction, Refused, Setting};
use crate::decision::Judgement;
use crate::element::Arm;
use crate::geometry::{Vector, larger, signed};
use crate::number::Real;

/// The corner of two elements on one side of the tool.
///
/// [TRC-CORNER-01] inner when σ·c > 0, or c = 0 and d > 0; outer otherwise.
pub(crate) fn corner(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    match turn(before, after, side, judgement) {
        Ordering::Greater => {
            let junction = inner::inner(before, after, side, setting.radius, judgement)?;
            far_intersection(before, &junction, setting, judgement);
            Ok(junction)
        }
        Ordering::Less => outer(before, after, side, setting, false, judgement),
        Ordering::Equal => match right_angle(before, after, judgement) {
            // [TRC-CORNER-02] the two normals are one.
            Ordering::Greater => Ok(Junction::single(clause::TRC_CORNER_02, before.normal(side, setting.radius))),
            // [TRC-CORNER-09] exact reversal.
            Ordering::Less => match setting.parameters.reversal {
                Reversal::Outer => outer(before, after, side, setting, true, judgement),
                Reversal::Alarm => Err(Refused::Alarm(AlarmKind::Reversal)),
            },
            Ordering::Equal => Err(Refused::Contradiction),
        },
    }
}

/// σ·c as a displacement: the sine of the turn times the shorter arm.
fn turn(before: &Arm, after: &Arm, side: Side, judgement: &mut Judgement<'_>) -> Ordering {
    let cross = signed(side, &before.tangent.cross(&after.tangent));
    let margin = displacement(&cross, before, after);
    judgement.decide(DecisionKind::Turn, &cross, margin)
}

/// d as a displacement: the cosine of the turn times the shorter arm.
fn right_angle(before: &Arm, after: &Arm, judgement: &mut Judgement<'_>) -> Ordering {
    let dot = before.tangent.dot(&after.tangent);
    let margin = displacement(&dot, before, after);
    judgement.decide(DecisionKind::RightAngle, &dot, margin)
}

/// A product of the two tangents, divided by the longer one.
fn displacement(product: &Real, before: &Arm, after: &Arm) -> Real {
    product.checked_div(&larger(&before.length, &after.length)).unwrap_or_else(Real::zero)
}

fn outer(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    reversal: bool,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    match setting.outer_corner {
        OuterCorner::Arc => Ok(arc_corner(before, after, side, setting.radius)),
        OuterCorner::Intersection => by_intersection(before, after, side, setting.radius, reversal, judgement),
    }
}

/// [TRC-CORNER-06] obtuse, [TRC-CORNER-08] acute, [TRC-CORNER-07] with the normals of arcs.
fn by_intersection(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    reversal: bool,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    let acute = reversal || right_angle(before, after, judgement) == Ordering::Less;
    let (arc_before, arc_after) = (before.circle.is_some(), after.circle.is_some());
    let mut vectors = Vec::with_capacity(4);
    if arc_before {
        vectors.push(before.normal(side, radius));
    }
    if acute {
        vectors.push(before.normal(side, radius).plus(&before.advance(radius)));
        vectors.push(after.normal(side, radius).minus(&after.advance(radius)));
    } else {
        vectors.push(mitre(before, after, side, radius).ok_or(Refused::Contradiction)?);
    }
    if arc_after {
        vectors.push(after.normal(side, radius));
    }
    let clause = if reversal {
        clause::TRC_CORNER_09
    } else if acute {
        clause::TRC_CORNER_08
    } else if arc_before || arc_after {
        clause::TRC_CORNER_07
    } else {
        clause::TRC_CORNER_06
    };
    Ok(Junction::through(clause, vectors))
}

/// The intersection of the two offset tangents, `P + r·n(u1) - σ·r·tan(φ/2)·u1`: [TRC-CORNER-03] and [TRC-CORNER-06]
/// in one formula, with `tan(φ/2) = sin φ / (1 + cos φ) = c / (l1·l2 + d)`. None at an exact reversal.
pub(crate) fn mitre(before: &Arm, after: &Arm, side: Side, radius: &Real) -> Option<Vector> {
    let (cross, dot) = (before.tangent.cross(&after.tangent), before.tangent.dot(&after.tangent));
    let tangent = cross.checked_div(&(&(&before.length * &after.length) + &dot))?;
    Some(before.normal(side, radius).along(&before.advance(radius), &-signed(side, &tangent)))
}

/// [TRC-CORNER-10]
fn arc_corner(before: &Arm, after: &Arm, side: Side, radius: &Real) -> Junction {
    let (first, last) = (before.normal(side, radius), after.normal(side, radius));
    let direction = match side {
        Side::Left => Direction::Clockwise,
        Side::Right => Direction::Counterclockwise,
    };
    let moves = if first == last {
        Vec::new()
    } else {
        vec![Segment::Arc {
            end: [last.a.clone(), last.b.clone()],
            centre: [before.point.a.clone(), before.point.b.clone()],
            direction,
            full: false,
        }]
    };
    Junction { clause: clause::TRC_CORNER_10, first, moves }
}

/// [TRC-WEDGE-01]
fn far_intersection(before: &Arm, junction: &Junction, setting: Setting<'_>, judgement: &mut Judgement<'_>) {
    let limit = super::mode::ratio(setting.parameters.far_intersection);
    let limit = &limit * setting.radius;
    let distance = junction.first.minus(&before.point).length();
    let margin = &limit - &distance;
    if judgement.decide(DecisionKind::NearCorner, &margin, margin.clone()) == Ordering::Less {
        judgement.advise(AdvisoryKind::FarIntersection, distance);
    }
}

/// Whether the corner's moves belong to the next block ([TRC-CORNER-12]).
pub(crate) fn next_owns(owner: CornerOwner) -> bool {
    owner == CornerOwner::Next
}
