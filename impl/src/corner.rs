//! Outer corners: by intersection, squared off, by an arc, and the exact reversal. [TRC-CORNER-06] to [TRC-CORNER-10]

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, Direction, OuterCorner, clause};

use crate::element::Element;
use crate::junction::{Junction, Turn};
use crate::plane::is_finite;
use crate::sign::sign;

/// Forms an outer corner.
///
/// # Errors
/// [TRC-MODE-07], where a turn of which rounding leaves nothing puts the corner too far away.
#[inline(always)]
pub(crate) fn outer(
    first: &Element,
    second: &mut Element,
    radius: f64,
    turn: Turn,
    rule: OuterCorner,
) -> Result<Junction, AlarmKind> {
    match rule {
        OuterCorner::Arc => Ok(round(first, second, radius)),
        OuterCorner::Intersection => by_intersection(first, second, radius, turn),
    }
}

/// [TRC-CORNER-10]
fn round(first: &Element, second: &mut Element, radius: f64) -> Junction {
    second.lead.set(clause::TRC_CORNER_10, second.start_vector(radius));
    second.lead.round = Some(if first.side > 0.0 { Direction::Clockwise } else { Direction::Counterclockwise });
    second.lead.centre = first.end;
    Junction { first: first.end_vector(radius), clause: clause::TRC_CORNER_10, on_normals: true }
}

#[inline(always)]
fn by_intersection(first: &Element, second: &mut Element, radius: f64, turn: Turn) -> Result<Junction, AlarmKind> {
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
    if !is_finite(before) {
        return Err(AlarmKind::OutOfRange);
    }
    let first_vector = if first.arc.is_some() { normal } else { before };
    if acute || with_arc {
        let after = second.start_vector(radius);
        let lead = &mut second.lead;
        lead.start(clause);
        // [TRC-CORNER-07]
        if first.arc.is_some() {
            lead.push(before);
        }
        if acute {
            // B of [TRC-CORNER-08].
            lead.push(after - second.first * radius);
        }
        if second.arc.is_some() {
            lead.push(after);
        }
    }
    Ok(Junction { first: first_vector, clause, on_normals: true })
}
