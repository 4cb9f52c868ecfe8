//! Outer corners: by intersection, squared off, by an arc, and the exact reversal. [TRC-CORNER-06] to [TRC-CORNER-10]

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, Direction, OuterCorner, clause};

use crate::element::Element;
use crate::junction::{Junction, Turn, in_range};
use crate::sign::sign;

/// Forms an outer corner.
///
/// # Errors
/// [TRC-MODE-07], where a turn of which rounding leaves nothing puts the corner too far away.
#[inline(always)]
pub(crate) fn outer(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    rule: OuterCorner,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    match rule {
        OuterCorner::Arc => {
            round(first, second, radius, junction);
            Ok(())
        }
        OuterCorner::Intersection => by_intersection(first, second, radius, turn, junction),
    }
}

/// [TRC-CORNER-10]
fn round(first: &Element, second: &Element, radius: f64, junction: &mut Junction) {
    junction.set(clause::TRC_CORNER_10, first.end_vector(radius));
    junction.push(second.start_vector(radius));
    junction.round = Some(if first.side > 0.0 { Direction::Clockwise } else { Direction::Counterclockwise });
    junction.centre = first.end;
}

#[inline(always)]
fn by_intersection(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let acute = sign(turn.dot, turn.error) == Ordering::Less;
    let with_arc = first.arc.is_some() || second.arc.is_some();
    let clause = match (turn.toward_tool(first.side), acute) {
        (Ordering::Equal, _) => clause::TRC_CORNER_09,
        (_, true) => clause::TRC_CORNER_08,
        (_, false) if with_arc => clause::TRC_CORNER_07,
        (_, false) => clause::TRC_CORNER_06,
    };
    let normal = first.end_vector(radius);
    // A of [TRC-CORNER-08], or M of [TRC-CORNER-06]; [TRC-CORNER-09] is [TRC-CORNER-08] with α = 0.
    let beyond = if acute { radius } else { radius * turn.half_tangent() };
    let before = normal + first.last * beyond;
    in_range(before)?;
    // [TRC-CORNER-07]: the normal of an arc comes before or after.
    if first.arc.is_some() {
        junction.set(clause, normal);
        junction.push(before);
    } else {
        junction.set(clause, before);
    }
    if acute {
        // B of [TRC-CORNER-08].
        junction.push(second.start_vector(radius) - second.first * radius);
    }
    if second.arc.is_some() {
        junction.push(second.start_vector(radius));
    }
    Ok(())
}
