//! Vectors given by the program: `spec/clauses/12-vectors.md`, and the imaginary lines of [TRC-START-11] and
//! [TRC-CANCEL-08].

use radcomp_spec::{DecisionKind, Direction, Segment, Side};

use super::corner::{Kind, kind, mitre};
use super::inner::{Turning, common_point_if_any};
use super::junction::Refused;
use crate::decision::Judgement;
use crate::element::Arm;
use crate::geometry::Vector;
use crate::number::Real;

/// Where the offsets of a contour's element and of an imaginary line meet, inner and outer corners alike; none where
/// they are parallel at the corner, and where they have no common point.
pub(crate) fn meet(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Option<Vector>, Refused> {
    let turning = match kind(before, after, side, judgement)? {
        Kind::Tangent | Kind::Reversal => return Ok(None),
        Kind::Inner => Turning::Toward,
        Kind::Outer => Turning::Away,
    };
    if before.circle.is_none() && after.circle.is_none() {
        return mitre(before, after, side, radius).map(Some).ok_or(Refused::Contradiction);
    }
    common_point_if_any(before, after, side, radius, (turning, DecisionKind::ImaginaryLineMet), judgement)
}

/// [TRC-VEC-02] the arc about the corner, from the normal of the element before, which has its own side, to that of the
/// direction `after`; none where the two are one.
pub(crate) fn corner_arc(
    (before, side_before): (&Arm, Side),
    after: &Arm,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Option<Segment<Real>>, Refused> {
    // On sides that differ they are one where the path turns back.
    let one = if side_before == side { Kind::Tangent } else { Kind::Reversal };
    if kind(before, after, side, judgement)? == one {
        return Ok(None);
    }
    let (end, centre) = (after.normal(side, radius), &before.point);
    let direction = match side {
        Side::Left => Direction::Clockwise,
        Side::Right => Direction::Counterclockwise,
    };
    Ok(Some(Segment::Arc { end: [end.a, end.b], centre: [centre.a.clone(), centre.b.clone()], direction, full: false }))
}
