//! Corners: `spec/clauses/04-corner.md`. Inner and outer corners have files of their own.

use core::cmp::Ordering;

use radcomp_spec::clause;
use radcomp_spec::parameters::{CornerOwner, Ratio, Reversal};
use radcomp_spec::{AdvisoryKind, AlarmKind, DecisionKind, Side};

use super::junction::{Junction, Refused, Setting};
use super::outer::{self, Outer};
use super::{inner, mode};
use crate::decision::Judgement;
use crate::element::Arm;
use crate::geometry::{Vector, larger, signed, smaller};
use crate::number::Real;

/// The kinds of a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Straight on ([TRC-CORNER-02]).
    Tangent,
    Inner,
    Outer,
    /// Straight back ([TRC-CORNER-09]).
    Reversal,
}

/// The corner of two elements of offset mode on one side of the tool.
pub(crate) fn corner(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    if counts_as_straight(before, after, setting, judgement) {
        // The clause alone depends on whether the turn is exactly zero, not the path.
        let tangent = before.tangent.cross(&after.tangent).is_zero();
        let clause = if tangent { clause::TRC_CORNER_02 } else { clause::TRC_CORNER_16 };
        return Ok(Junction::single(clause, before.normal(side, setting.radius)));
    }
    let reversal = match kind(before, after, side, judgement)? {
        // [TRC-CORNER-02] the two normals are one.
        Kind::Tangent => {
            return Ok(Junction::single(clause::TRC_CORNER_02, before.normal(side, setting.radius)));
        }
        Kind::Inner => {
            let junction = inner::inner(before, after, side, setting.radius, judgement)?;
            far_intersection(before, &junction, setting, judgement);
            return Ok(junction);
        }
        Kind::Outer => false,
        // [TRC-CORNER-09]
        Kind::Reversal if setting.parameters.reversal == Reversal::Alarm => {
            return Err(Refused::Alarm(AlarmKind::Reversal));
        }
        Kind::Reversal => true,
    };
    let outer = outer::outer(before, after, side, setting, reversal, judgement)?;
    Ok(outer.without_small_vectors(after.circle.is_some(), setting, judgement).junction())
}

/// The outer corner of start-up and cancel of type B ([TRC-START-06], [TRC-CANCEL-05]); none at an inner corner and at
/// one below the smallest, where type A holds.
pub(crate) fn of_type_b(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Option<Outer>, Refused> {
    let reversal = match kind(before, after, side, judgement)? {
        Kind::Tangent | Kind::Inner => return Ok(None),
        Kind::Outer => false,
        Kind::Reversal => true,
    };
    // [TRC-CORNER-15]
    let limit = setting.parameters.smallest_corner_cosine;
    let smallest = |judgement| not_below(before, after, limit, DecisionKind::SmallestCorner, judgement);
    if limit.numerator > 0 && smallest(judgement) == Ordering::Less {
        return Ok(None);
    }
    outer::outer(before, after, side, setting, reversal, judgement).map(Some)
}

/// [TRC-CORNER-01] inner when σ·c > 0, or c = 0 and d > 0; outer otherwise.
pub(super) fn kind(before: &Arm, after: &Arm, side: Side, judgement: &mut Judgement<'_>) -> Result<Kind, Refused> {
    Ok(match turn(before, after, side, judgement) {
        Ordering::Greater => Kind::Inner,
        Ordering::Less => Kind::Outer,
        Ordering::Equal => match right_angle(before, after, judgement) {
            Ordering::Greater => Kind::Tangent,
            Ordering::Less => Kind::Reversal,
            Ordering::Equal => return Err(Refused::Contradiction),
        },
    })
}

/// σ·c as a displacement: the sine of the turn times the shorter arm.
fn turn(before: &Arm, after: &Arm, side: Side, judgement: &mut Judgement<'_>) -> Ordering {
    let cross = signed(side, &before.tangent.cross(&after.tangent));
    let margin = displacement(&cross, before, after);
    judgement.decide(DecisionKind::Turn, &cross, margin)
}

/// d as a displacement: the cosine of the turn times the shorter arm.
pub(super) fn right_angle(before: &Arm, after: &Arm, judgement: &mut Judgement<'_>) -> Ordering {
    let dot = before.tangent.dot(&after.tangent);
    let margin = displacement(&dot, before, after);
    judgement.decide(DecisionKind::RightAngle, &dot, margin)
}

/// A product of the two tangents, divided by the longer one.
pub(super) fn displacement(product: &Real, before: &Arm, after: &Arm) -> Real {
    product.checked_div(&larger(&before.length, &after.length)).unwrap_or_else(Real::zero)
}

/// `d + L` as a displacement, for the cosine L of an angle α: negative is a corner with a smaller α.
pub(super) fn not_below(
    before: &Arm,
    after: &Arm,
    cosine: Ratio,
    kind: DecisionKind,
    judgement: &mut Judgement<'_>,
) -> Ordering {
    turned_by(before, after, mode::ratio(cosine), kind, judgement)
}

/// [TRC-CORNER-16] `d ≥ L`.
fn counts_as_straight(before: &Arm, after: &Arm, setting: Setting<'_>, judgement: &mut Judgement<'_>) -> bool {
    let limit = setting.parameters.straight_band_cosine;
    limit.numerator > 0
        && turned_by(before, after, -mode::ratio(limit), DecisionKind::StraightBand, judgement) != Ordering::Less
}

/// `d + summand` as a displacement: times the shorter arm.
fn turned_by(before: &Arm, after: &Arm, summand: Real, kind: DecisionKind, judgement: &mut Judgement<'_>) -> Ordering {
    let dot = before.tangent.dot(&after.tangent);
    let sign = &dot + &(&summand * &(&before.length * &after.length));
    let shorter = smaller(before.length.clone(), after.length.clone());
    let margin = displacement(&dot, before, after) + &summand * &shorter;
    judgement.decide(kind, &sign, margin)
}

/// The intersection of the two offset tangents, `P + r·n(u1) - σ·r·tan(φ/2)·u1`: [TRC-CORNER-03] and [TRC-CORNER-06]
/// in one formula, with `tan(φ/2) = sin φ / (1 + cos φ) = c / (l1·l2 + d)`. None at an exact reversal.
pub(crate) fn mitre(before: &Arm, after: &Arm, side: Side, radius: &Real) -> Option<Vector> {
    let (cross, dot) = (before.tangent.cross(&after.tangent), before.tangent.dot(&after.tangent));
    let tangent = cross.checked_div(&(&(&before.length * &after.length) + &dot))?;
    Some(before.normal(side, radius).along(&before.advance(radius), &-signed(side, &tangent)))
}

/// [TRC-WEDGE-01]
fn far_intersection(before: &Arm, junction: &Junction, setting: Setting<'_>, judgement: &mut Judgement<'_>) {
    let limit = mode::ratio(setting.parameters.far_intersection);
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
