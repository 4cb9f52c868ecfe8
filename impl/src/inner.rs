//! Inner corners: the intersection of the two offset curves. [TRC-CORNER-03] to [TRC-CORNER-05]
//!
//! Let the vector be `P + z`, `w = |z|² - r²`, and κ = σδ/R for an arc, 0 for a line. That z lies on an offset curve
//! with normal n at P is `z·n = r + w·κ/2`, for lines and arcs alike. Two such equations give z as a linear function
//! of w, and |z|² = r² + w a quadratic one whose smaller root, in a form that does not cancel, is
//!
//! ```text
//! w = 2·r²·(1 - d) / (b + √Δ),   b = 1 + d - r·(κ1 + κ2),
//! Δ = (1 + d)·G,                 G = 1 + d - 2·r·(κ1 + κ2) + 2·r²·κ1·κ2
//! ```
//!
//! It is the root at which the path turns to the tool's side: it is P itself for r = 0, and the turn on it vanishes
//! only with Δ. The curves have no common point when G < 0.

use core::cmp::Ordering;

use radcomp_spec::{AlarmKind, clause};

use crate::element::Element;
use crate::junction::{Junction, Turn, in_range};
use crate::plane::{Vector, greater};
use crate::sign::sign;

/// Forms an inner corner that is not tangent.
///
/// # Errors
/// [TRC-CORNER-05]; [TRC-MODE-07] where rounding leaves the intersection out of range.
#[inline(always)]
pub(crate) fn corner(
    first: &Element,
    second: &Element,
    radius: f64,
    turn: Turn,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    if first.arc.is_none() && second.arc.is_none() {
        junction.set(clause::TRC_CORNER_03, first.end_vector(radius) - first.last * (radius * turn.half_tangent()));
    } else if radius == 0.0 {
        // Without a radius P is the intersection, and on the normal of an arc.
        junction.set(clause::TRC_CORNER_04, first.end);
    } else {
        let z = with_arc(first, second, radius, turn)?;
        junction.set(clause::TRC_CORNER_04, first.end + z);
        junction.leave_normals();
    }
    in_range(junction.first)
}

/// The vector of an inner corner with an arc, relative to P.
#[inline(always)]
fn with_arc(first: &Element, second: &Element, radius: f64, turn: Turn) -> Result<Vector, AlarmKind> {
    let sine = turn.cross.abs();
    let (one_plus, one_less) = turn.one_and_cosine();
    let (curvature1, curvature2) = (first.end_curvature(), second.start_curvature());
    if curvature1.is_infinite() {
        // The circle of an entry move about P itself, which touches the other curve at its normal. [TRC-START-09]
        return Ok(second.start_normal() * radius);
    }
    let (k1, k2) = (radius * curvature1, radius * curvature2);
    let b = one_plus - (k1 + k2);
    let meets = one_plus - 2.0 * (k1 + k2) + 2.0 * k1 * k2;
    // Bounds the terms of G, and what the coordinates' rounding makes of them through radii and tangents.
    let terms = 2.0 * (k1.abs() + k2.abs()) + 2.0 * k1.abs() * k2.abs();
    let coordinates = greater(first.scale, second.scale) * greater(curvature1.abs(), curvature2.abs());
    let root = match sign(meets, one_plus + terms + (sine + terms) * coordinates) {
        Ordering::Less => return Err(AlarmKind::NoIntersection),
        // The curves touch.
        Ordering::Equal => 0.0,
        Ordering::Greater => libm::sqrt(meets),
    };
    // w/2r, and z by its parts along the normal and against the tangent of the first element.
    let share = 1.0 / (b + libm::sqrt(one_plus) * root);
    let along_normal = radius * (1.0 + share * one_less * k1);
    // tan(φ/2)·(1 + (κ2 - d·κ1)·r/(b + √Δ)), without the difference that near a reversal leaves nothing of its terms.
    let back = radius * share * (libm::sqrt(one_less) * root + sine * (1.0 - k1));
    Ok(first.end_normal() * along_normal - first.last * back)
}
