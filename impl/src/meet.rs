//! Where two offset curves meet whose normals at P may point anywhere: at an outer corner with an extended arc
//! ([TRC-CORNER-14]), and at a change of side ([TRC-SIDE-02]).
//!
//! As in [`crate::inner`], let the vector be `P + z`, `w = |z|² - r²`, κ = σδ/R for an arc and 0 for a line, and k = rκ;
//! then `z·n = r + w·κ/2` on either curve. With D = dot(n1, n2),
//!
//! ```text
//! w/2r = r·(1 - D) / (b ± √Δ),   b = 1 + D - (k1 + k2),
//! Δ = (1 + D)·G,                 G = 1 + D - 2·(k1 + k2) + 2·k1·k2
//! z·u1 = s1·r·√(1 - D)·(√(1 + D)·(1 - k1) ± √G) / (b ± √Δ)
//! ```
//!
//! and z·u2 likewise with k2 and s2, where s1 and s2 are the signs of dot(n2, u1) and dot(n1, u2). The product of the two
//! denominators is `Q = (k1 + k2)² - 2·(1 + D)·k1·k2`, so that neither is a difference. A tool that fits has k < 1, and
//! where G ≥ 0 then b ≥ 0 and Q ≥ 0: the upper sign gives the point nearer to P, which is P itself for r = 0. At P the
//! path turns to one side of the tool, and the turn on the common point vanishes only with Δ: at an outer corner the
//! upper sign gives the point at which it turns away from the tool.

use core::cmp::Ordering;

use crate::element::Element;
use crate::junction::Turn;
use crate::plane::{Vector, dot, greater, length, magnitude};
use crate::sign::sign;

/// A common point of two offset curves, relative to P.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Common {
    /// z.
    pub vector: Vector,
    /// Its part along the first element, z·u1.
    pub along_first: f64,
    /// What its part along the first normal exceeds the radius by, z·n1 - r.
    pub rise_first: f64,
    /// z·u2.
    pub along_second: f64,
    /// z·n2 - r.
    pub rise_second: f64,
    /// Bounds its error, in units of rounding: by what it is made of, which is the size of the tool and the error of
    /// angles and curvatures, not the coordinates.
    pub error: f64,
}

/// Up to two common points, the nearer one first.
pub(crate) enum Commons {
    None,
    One(Common),
    Two(Common, Common),
}

/// The common point of the offset curves at an outer corner at which the path turns away from the tool; the radius is
/// not 0.
pub(crate) fn around(first: &Element, second: &Element, radius: f64, turn: Turn) -> Option<Vector> {
    match commons(first, second, radius, turn) {
        Commons::None => None,
        Commons::One(common) | Commons::Two(common, _) => Some(common.vector),
    }
}

/// The common points of the offset curves of two elements on different sides, or on the same one at an outer corner,
/// for a tool that fits, of a radius that is not 0; parallel lines and circles about one centre are not asked of.
pub(crate) fn commons(first: &Element, second: &Element, radius: f64, turn: Turn) -> Commons {
    let curvatures = [first.end_curvature(), second.start_curvature()];
    if curvatures[0].is_infinite() {
        return Commons::One(at_normal(first, second, radius));
    }
    let [k1, k2] = curvatures.map(|curvature| radius * curvature);
    let (more, less) = turn.one_and_cosine();
    let same = first.side == second.side;
    // 1 + D and 1 - D.
    let (plus, minus) = if same { (more, less) } else { (less, more) };
    let sum = k1 + k2;
    let meets = plus - 2.0 * sum + 2.0 * k1 * k2;
    let terms = 2.0 * (k1.abs() + k2.abs()) + 2.0 * k1.abs() * k2.abs();
    let coordinates = greater(first.scale, second.scale) * greater(curvatures[0].abs(), curvatures[1].abs());
    let root = match sign(meets, plus + terms + (turn.cross.abs() + terms) * coordinates) {
        Ordering::Less => return Commons::None,
        // The curves touch.
        Ordering::Equal => 0.0,
        Ordering::Greater => libm::sqrt(meets),
    };
    let (root_plus, root_minus) = (libm::sqrt(plus), libm::sqrt(minus));
    let nearer = plus - sum + root_plus * root;
    let both = sum * sum - 2.0 * plus * k1 * k2;
    // At an outer corner the turn is to the side away from the tool, an exact reversal among them.
    let toward = if same { -1.0 } else { first.side * 1.0_f64.copysign(turn.cross) };
    let amplified = if root > 0.0 { 1.0 + 1.0 / root } else { 1.0 };
    let angles = turn.error + (k1.abs() + k2.abs()) * (1.0 + coordinates);
    let point = |root: f64, denominator: f64| {
        let share = radius * minus / denominator;
        let part = |k: f64| radius * root_minus * (root_plus * (1.0 - k) + root) / denominator;
        let along_first = if same { -toward } else { toward } * part(k1);
        let vector = first.end_normal() * (radius + share * k1) + first.last * along_first;
        let error = (radius + length_of(vector)) * angles * amplified;
        let (rise_first, rise_second) = (share * k1, share * k2);
        Common { vector, along_first, rise_first, along_second: toward * part(k2), rise_second, error }
    };
    let one = point(root, nearer);
    let other = point(-root, both / nearer);
    // The other one lies farther than numbers reach where `both` vanishes, as of two lines.
    if root == 0.0 || !length_of(other.vector).is_finite() {
        return Commons::One(one);
    }
    Commons::Two(one, other)
}

/// The two arcs have one centre; P being on both, so are their offsets' circles about it.
pub(crate) fn concentric(first: &Element, second: &Element) -> bool {
    match (&first.arc, &second.arc) {
        (Some(one), Some(two)) => {
            let apart = one.end_ray * one.end_radius - two.start_ray * two.start_radius;
            sign(magnitude(apart), greater(first.scale, second.scale)) == Ordering::Equal
        }
        _ => false,
    }
}

/// The circle of an entry move about P itself touches the other curve at its normal. [TRC-START-09]
fn at_normal(first: &Element, second: &Element, radius: f64) -> Common {
    let vector = second.start_normal() * radius;
    let error = radius * (first.last_error + second.first_error);
    let (along_first, rise_first) = (dot(vector, first.last), dot(vector, first.end_normal()) - radius);
    Common { vector, along_first, rise_first, along_second: 0.0, rise_second: 0.0, error }
}

/// The length, or what is not finite.
fn length_of(vector: Vector) -> f64 {
    if (vector.x + vector.y).is_finite() { length(vector) } else { f64::INFINITY }
}
