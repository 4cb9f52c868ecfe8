//! The junction with an imaginary line, which the program gives before the contour or behind it. [TRC-START-11],
//! [TRC-CANCEL-08]
//!
//! Inner and outer corners are not told apart: the vector is the common point of the two offset curves that is P itself
//! when the radius is 0, the one of [TRC-CORNER-04] at an inner corner and of [TRC-CORNER-14] at an outer one.

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, Clause, clause};

use crate::element::Element;
use crate::inner;
use crate::junction::{Junction, Turn, in_range};
use crate::meet;
use crate::plane::Vector;

/// Forms the junction behind a start-up block with an imaginary line in the direction `along` (unit) through its end.
///
/// # Errors
/// [TRC-MODE-07], where rounding leaves the common point out of range.
#[inline(never)]
pub(crate) fn start_up(
    first: &Element,
    second: &Element,
    along: Vector,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let radius = first.radius;
    let mut line = *first;
    line.set_imaginary(first.end, along);
    line.side = second.side;
    if !meet_line(&line, second, radius, clause::TRC_START_11, junction)? {
        junction.set(clause::TRC_START_02, second.start_vector(radius));
    }
    Ok(())
}

/// Forms the junction before a cancel block with an imaginary line, which is the second element.
///
/// # Errors
/// As [`start_up`].
#[inline(never)]
pub(crate) fn cancel(first: &Element, line: &Element, junction: &mut Junction) -> Result<(), AlarmKind> {
    let radius = first.radius;
    if !meet_line(first, line, radius, clause::TRC_CANCEL_08, junction)? {
        junction.set(clause::TRC_CANCEL_01, first.end_vector(radius));
    }
    Ok(())
}

/// Forms the junction of two elements on one side, one of them the imaginary line, unless they are parallel at P or have
/// no common point; answers whether there is one.
fn meet_line(
    first: &Element,
    second: &Element,
    radius: f64,
    clause: Clause,
    junction: &mut Junction,
) -> Result<bool, AlarmKind> {
    let turn = Turn::between(first, second);
    match turn.toward_tool(first.side) {
        Ordering::Equal => return Ok(false),
        Ordering::Greater => match inner::corner(first, second, radius, turn, junction) {
            Err(AlarmKind::NoIntersection) => return Ok(false),
            formed => formed?,
        },
        Ordering::Less if first.arc.is_none() && second.arc.is_none() => {
            junction.set(clause, first.end_vector(radius) + first.last * (radius * turn.half_tangent()));
        }
        // Without a radius P is the common point, and on the normal of an arc.
        Ordering::Less if radius == 0.0 => junction.set(clause, first.end),
        Ordering::Less => {
            let Some(vector) = meet::around(first, second, radius, turn) else { return Ok(false) };
            junction.set(clause, first.end + vector);
            junction.leave_normals();
        }
    }
    junction.clause = clause;
    in_range(junction.first)?;
    Ok(true)
}
