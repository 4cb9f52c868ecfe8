//! Outer corners: by intersection, squared off, by an arc, and the exact reversal. [TRC-CORNER-06] to [TRC-CORNER-10],
//! [TRC-CORNER-13], [TRC-CORNER-14], [TRC-CORNER-17]

use core::cmp::Ordering;

use radcomp_spec::parameters::{ArcExtension, ArcOnRapid, CornerOwner};
use radcomp_spec::{AlarmKind, Direction, OuterCorner, clause};

use crate::element::Element;
use crate::junction::{Junction, Turn, in_range};
use crate::meet;
use crate::rules::Rules;
use crate::sign::sign;

/// Forms an outer corner, an exact reversal among them.
///
/// # Errors
/// [TRC-CORNER-14]; [TRC-MODE-07], where a turn of which rounding leaves nothing puts the corner too far away.
#[inline(always)]
pub(crate) fn outer(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    rules: &Rules,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let by_arc = match rules.outer {
        OuterCorner::Intersection => false,
        OuterCorner::Arc => true,
        // [TRC-CORNER-13]
        OuterCorner::LimitAngle => turn.is_reversal() || turn.against(rules.limit) == Ordering::Less,
    };
    if by_arc {
        round(first, second, radius, rules, junction);
        return Ok(());
    }
    if rules.extension == ArcExtension::Curve && (first.arc.is_some() || second.arc.is_some()) {
        return extended(first, second, radius, turn, junction);
    }
    by_intersection(first, second, radius, turn, rules.outer == OuterCorner::Intersection, junction)
}

/// [TRC-CORNER-10], [TRC-CORNER-17]
fn round(first: &Element, second: &Element, radius: f64, rules: &Rules, junction: &mut Junction) {
    junction.set(clause::TRC_CORNER_10, first.end_vector(radius));
    junction.push(second.start_vector(radius));
    let owner = if rules.owner == CornerOwner::Previous { first } else { second };
    if rules.arc_on_rapid == ArcOnRapid::Line && owner.rapid {
        junction.clause = clause::TRC_CORNER_17;
        return;
    }
    junction.round = Some(if first.side > 0.0 { Direction::Clockwise } else { Direction::Counterclockwise });
    junction.centre = first.end;
}

/// [TRC-CORNER-14]
#[inline(never)]
fn extended(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    if meet::concentric(first, second) {
        return Err(AlarmKind::NoIntersection);
    }
    if radius == 0.0 {
        // Without a radius P is the intersection, and on the normal of an arc.
        junction.set(clause::TRC_CORNER_14, first.end);
        return Ok(());
    }
    let vector = meet::around(first, second, radius, turn).ok_or(AlarmKind::NoIntersection)?;
    junction.set(clause::TRC_CORNER_14, first.end + vector);
    junction.leave_normals();
    in_range(junction.first)
}

/// `squared`: an acute corner is squared off. [TRC-CORNER-08]
#[inline(always)]
fn by_intersection(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    squared: bool,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let acute = sign(turn.dot, turn.error) == Ordering::Less;
    let with_arc = first.arc.is_some() || second.arc.is_some();
    let clause = match (turn.toward_tool(first.side), acute) {
        (_, true) if !squared => clause::TRC_CORNER_13,
        (Ordering::Equal, _) => clause::TRC_CORNER_09,
        (_, true) => clause::TRC_CORNER_08,
        (_, false) if with_arc => clause::TRC_CORNER_07,
        (_, false) => clause::TRC_CORNER_06,
    };
    let normal = first.end_vector(radius);
    // A of [TRC-CORNER-08], or M of [TRC-CORNER-06]; [TRC-CORNER-09] is [TRC-CORNER-08] with α = 0.
    let beyond = if acute && squared { radius } else { radius * turn.half_tangent() };
    let before = normal + first.last * beyond;
    in_range(before)?;
    // [TRC-CORNER-07]: the normal of an arc comes before or after.
    if first.arc.is_some() {
        junction.set(clause, normal);
        junction.push(before);
    } else {
        junction.set(clause, before);
    }
    if acute && squared {
        // B of [TRC-CORNER-08].
        junction.push(second.start_vector(radius) - second.first * radius);
    }
    if second.arc.is_some() {
        junction.push(second.start_vector(radius));
    }
    Ok(())
}
