//! The contact point of a change of side. [TRC-SIDE-02], [TRC-SIDE-05]
//!
//! Points are relative to P here: the numbers stay small where the decision is close.

use core::cmp::Ordering;

use radcomp_spec::clause;

use crate::arc_form::Arc;
use crate::element::Element;
use crate::junction::{Junction, Turn};
use crate::meet::{Common, Commons, commons, concentric};
use crate::plane::{Vector, cross, dot, length};
use crate::sign::sign;

/// Forms the junction at the contact point, if one counts; answers whether one does. With `within` it counts only near
/// both offset elements.
pub(crate) fn contact(first: &Element, second: &Element, radius: f64, within: bool, junction: &mut Junction) -> bool {
    let turn = Turn::between(first, second);
    let parallel = turn.is_straight();
    if parallel && (first.arc.is_none() && second.arc.is_none() || concentric(first, second)) {
        return false;
    }
    let clause = if within { clause::TRC_SIDE_02 } else { clause::TRC_SIDE_05 };
    if radius == 0.0 || turn.is_reversal() {
        // The end of both normals is the one common point there, or, without a radius, the nearest to P.
        junction.set(clause, first.end_vector(radius));
        return true;
    }
    let counts =
        |common: &Common| !within || within_first(first, radius, common) && within_second(second, radius, common);
    let common = match commons(first, second, radius, turn) {
        Commons::None => None,
        Commons::One(common) => Some(common).filter(counts),
        // The first is the nearer to P, unless the path goes straight on: then they are equally near.
        Commons::Two(one, other) => match (counts(&one), counts(&other)) {
            (true, true) if parallel => None,
            (true, _) => Some(one),
            (false, true) => Some(other),
            (false, false) => None,
        },
    };
    if let Some(common) = &common {
        junction.set(clause, first.end + common.vector);
        junction.leave_normals();
    }
    common.is_some()
}

/// The point lies on the first element's offset, extended by the radius.
fn within_first(element: &Element, radius: f64, common: &Common) -> bool {
    let beyond = common.along_first;
    match &element.arc {
        None => within_line(element, beyond, -beyond - element.length, radius, common),
        Some(arc) => {
            let here = length(Vector::new(beyond, common.rise_first));
            let there = length(common.vector + (element.end - element.start) - element.start_normal() * radius);
            let ray = common.vector + arc.end_ray * arc.end_radius;
            within_arc(element, ray, here, there, radius, common)
        }
    }
}

/// The point lies on the second element's offset, extended by the radius.
fn within_second(element: &Element, radius: f64, common: &Common) -> bool {
    let before = -common.along_second;
    match &element.arc {
        None => within_line(element, before, -before - element.length, radius, common),
        Some(arc) => {
            let here = length(Vector::new(before, common.rise_second));
            let there = length(common.vector - (element.end - element.start) - element.end_normal() * radius);
            let ray = common.vector + arc.start_ray * arc.start_radius;
            within_arc(element, ray, here, there, radius, common)
        }
    }
}

/// The point lies outside an offset line by at most the radius: by `here` at P, by `there` at the other end, which
/// the coordinates' rounding reaches.
fn within_line(element: &Element, here: f64, there: f64, radius: f64, common: &Common) -> bool {
    sign(radius - here, common.error) != Ordering::Less
        && sign(radius - there, common.error + element.scale) != Ordering::Less
}

/// `ray` points from the centre to the point; its distances `here` and `there` from the ends of the offset arc count
/// where it does not lie on the arc itself. Near an end either answer is right, so that the comparison of angles needs
/// no band.
fn within_arc(element: &Element, ray: Vector, here: f64, there: f64, radius: f64, common: &Common) -> bool {
    let Some(arc) = &element.arc else { return false };
    sign(radius - here, common.error) != Ordering::Less
        || sign(radius - there, common.error + element.scale) != Ordering::Less
        || is_whole_turn(element, arc)
        || turned_no_further(arc.start_ray, ray, arc.end_ray, arc.sense)
}

/// [TRC-ARC-01] an arc whose start and end lie on one ray sweeps 360°.
fn is_whole_turn(element: &Element, arc: &Arc) -> bool {
    arc.full
        || sign(cross(arc.start_ray, arc.end_ray), element.first_error + element.last_error) == Ordering::Equal
            && dot(arc.start_ray, arc.end_ray) > 0.0
}

/// Whether the turn from `from` to `to` in the sense is at most the turn to `limit`, all within one turn, by the
/// quadrants' signs instead of angles.
fn turned_no_further(from: Vector, to: Vector, limit: Vector, sense: f64) -> bool {
    let (x, y) = (dot(from, to), sense * cross(from, to));
    let (limit_x, limit_y) = (dot(from, limit), sense * cross(from, limit));
    let (past_half, limit_past_half) = (y < 0.0, limit_y < 0.0);
    if past_half == limit_past_half { x * limit_y - y * limit_x >= 0.0 } else { limit_past_half }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_by_half_planes() {
        let at = |degrees: f64| Vector::new(degrees.to_radians().cos(), degrees.to_radians().sin());
        for limit in [30.0, 120.0, 200.0, 300.0_f64] {
            for to in [10.0, 40.0, 100.0, 140.0, 190.0, 220.0, 280.0, 350.0_f64] {
                for start in [0.0, 77.0, 211.0_f64] {
                    let forward = turned_no_further(at(start), at(start + to), at(start + limit), 1.0);
                    let backward = turned_no_further(at(start), at(start - to), at(start - limit), -1.0);
                    assert_eq!((forward, backward), (to <= limit, to <= limit), "{start} {to} {limit}");
                }
            }
        }
    }
}
