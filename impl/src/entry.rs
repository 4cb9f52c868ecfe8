//! The entry move: a start-up block that counts as compensated from its end on. [TRC-START-07], [TRC-START-09]

use core::cmp::Ordering;

use radcomp_spec::parameters::EqualRadius;
use radcomp_spec::{AlarmKind, Side};

use crate::arc_form::Arc;
use crate::element::{Element, sigma};
use crate::plane::{Vector, direction, dot, greater, is_finite, length, magnitude, perp};
use crate::sign::sign;

/// Makes an element that the program moves on an entry move. A line is measured from its programmed start, an arc from
/// `tool`, where the tool's centre stands; lengths in millimetres.
///
/// # Errors
/// [TRC-START-07], [TRC-START-09], [TRC-ARC-05]; [TRC-MODE-07] where rounding leaves the moved centre out of range.
pub(crate) fn enter(
    element: &mut Element,
    tool: Vector,
    radius: f64,
    side: Side,
    equal: EqualRadius,
) -> Result<(), AlarmKind> {
    let from = if element.arc.is_some() { tool } else { element.start };
    let scale = greater(greater(element.scale, magnitude(from)), radius);
    let from_end = from - element.end;
    if sign(length(from_end) - radius, scale) != Ordering::Greater {
        return Err(AlarmKind::EntryTooShort);
    }
    if !element.tool_fits(side, radius, equal) {
        return Err(AlarmKind::RadiusTooSmall);
    }
    element.side = sigma(side);
    match element.arc {
        // With the vector at the centre no circle leads to it. [TRC-ARC-08]
        Some(_) if element.is_point(radius) => Err(AlarmKind::NoEntryArc),
        None => Ok(()),
        Some(arc) => enter_on_arc(element, arc, from_end, element.side * arc.sense * radius, scale),
    }
}

/// `from_end` leads from the end E to the start S, and `offset` is σ·δ·r.
///
/// With e the unit vector from the programmed centre to E, `V = E - σδr·e`, and the moved centre is `B = V - ρ·e` with
/// `ρ = |S - V|² / (2·p)` and `p = -dot(S - V, e)`. The element becomes the arc about B whose offset is the circle
/// through S and V: its radius, `ρ + σδr`, is negative for a circle about B that is smaller than the tool.
fn enter_on_arc(element: &mut Element, arc: Arc, from_end: Vector, offset: f64, scale: f64) -> Result<(), AlarmKind> {
    let outward = arc.end_ray;
    let from_vector = from_end + outward * offset;
    let advance = -(dot(from_end, outward) + offset);
    if sign(advance, scale + length(from_end) * element.last_error) != Ordering::Greater {
        return Err(AlarmKind::NoEntryArc);
    }
    let chord = length(from_vector);
    let size = 0.5 * chord * (chord / advance);
    let mut own = size + offset;
    if sign(own, scale) == Ordering::Equal {
        own = 0.0;
    }
    let centre = element.end - outward * own;
    let (start_ray, _) = direction(from_vector + outward * size);
    if !is_finite(centre) || !is_finite(start_ray) {
        return Err(AlarmKind::OutOfRange);
    }
    element.start = element.end + from_end + start_ray * offset;
    element.first = perp(start_ray) * arc.sense;
    element.scale = scale + size;
    element.first_error = element.last_error + scale / size;
    element.arc = Some(Arc { centre, start_ray, start_radius: own, end_radius: own, full: false, ..arc });
    Ok(())
}
