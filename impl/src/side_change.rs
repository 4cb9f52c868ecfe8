//! The contact point of a change of side. [TRC-SIDE-02]
//!
//! Points are relative to P here: the numbers stay small where the decision is close.

use core::cmp::Ordering;

use radcomp_spec::clause;

use crate::arc_form::Arc;
use crate::element::Element;
use crate::junction::{Junction, Turn};
use crate::plane::{Vector, cross, dot, length, magnitude, perp};
use crate::sign::sign;

/// The offset curve of an element.
enum Curve {
    /// Through the point, in the direction.
    Line(Vector, Vector),
    /// Centre and radius.
    Circle(Vector, f64),
}

/// Up to two common points of two curves.
enum Common {
    None,
    One(Vector),
    Two(Vector, Vector),
}

/// Forms the junction at the contact point, if one counts; answers whether one does.
pub(crate) fn contact(first: &Element, second: &Element, radius: f64, junction: &mut Junction) -> bool {
    let turn = Turn::between(first, second);
    let lines = first.arc.is_none() && second.arc.is_none();
    let parallel = turn.is_straight();
    if parallel && (lines || concentric(first, second)) {
        return false;
    }
    let scale = scale(first, second, radius);
    if radius == 0.0 || (parallel && turn.dot < 0.0) {
        // The end of both normals is the one common point there, or, without a radius, the nearest to P.
        junction.set(clause::TRC_SIDE_02, first.end_vector(radius));
        return true;
    }
    let counts = |z: &Vector| within_first(first, radius, *z, scale) && within_second(second, radius, *z, scale);
    let common = if lines { lines_meet(first, radius, turn) } else { curves_meet(first, second, radius, scale) };
    let vector = match common {
        Common::None => None,
        Common::One(point) => Some(point).filter(counts),
        Common::Two(one, other) => match (counts(&one), counts(&other)) {
            (false, false) => None,
            (true, false) => Some(one),
            (false, true) => Some(other),
            (true, true) => match sign(length(one) - length(other), scale) {
                Ordering::Less => Some(one),
                Ordering::Greater => Some(other),
                Ordering::Equal => None,
            },
        },
    };
    if let Some(vector) = vector {
        junction.set(clause::TRC_SIDE_02, first.end + vector);
        junction.on_normals = false;
    }
    vector.is_some()
}

/// Bounds every coordinate and radius that takes part.
fn scale(first: &Element, second: &Element, radius: f64) -> f64 {
    first.scale.max(second.scale) + radius
}

/// The two arcs have one centre; P being on both, so are their offsets' circles about it.
fn concentric(first: &Element, second: &Element) -> bool {
    match (&first.arc, &second.arc) {
        (Some(one), Some(two)) => {
            let apart = one.end_ray * one.end_radius - two.start_ray * two.start_radius;
            sign(magnitude(apart), first.scale.max(second.scale)) == Ordering::Equal
        }
        _ => false,
    }
}

/// The point where two offset lines meet that are not parallel: as far along the one from its normal as along the
/// other, `σ1·r·(1 + d)/c`.
fn lines_meet(first: &Element, radius: f64, turn: Turn) -> Common {
    let cotangent = if turn.dot >= 0.0 { (1.0 + turn.dot) / turn.cross } else { turn.cross / (1.0 - turn.dot) };
    Common::One(first.end_normal() * radius + first.last * (first.side * radius * cotangent))
}

fn curves_meet(first: &Element, second: &Element, radius: f64, scale: f64) -> Common {
    match (first_curve(first, radius), second_curve(second, radius)) {
        (Curve::Line(point, along), Curve::Circle(centre, size))
        | (Curve::Circle(centre, size), Curve::Line(point, along)) => line_circle(point, along, centre, size, scale),
        (Curve::Circle(one, size), Curve::Circle(two, other)) => circles(one, size, two, other, scale),
        (Curve::Line(..), Curve::Line(..)) => Common::None,
    }
}

fn first_curve(element: &Element, radius: f64) -> Curve {
    match &element.arc {
        None => Curve::Line(element.end_normal() * radius, element.last),
        Some(arc) => Curve::Circle(arc.end_ray * -arc.end_radius, arc.end_radius - element.side * arc.sense * radius),
    }
}

fn second_curve(element: &Element, radius: f64) -> Curve {
    match &element.arc {
        None => Curve::Line(element.start_normal() * radius, element.first),
        Some(arc) => {
            Curve::Circle(arc.start_ray * -arc.start_radius, arc.start_radius - element.side * arc.sense * radius)
        }
    }
}

fn line_circle(point: Vector, along: Vector, centre: Vector, size: f64, scale: f64) -> Common {
    let to_centre = centre - point;
    let foot = point + along * dot(to_centre, along);
    let height = cross(along, to_centre).abs();
    match sign(size - height, scale) {
        Ordering::Less => Common::None,
        Ordering::Equal => Common::One(foot),
        Ordering::Greater => {
            let half = along * libm::sqrt((size - height) * (size + height));
            Common::Two(foot - half, foot + half)
        }
    }
}

fn circles(one: Vector, size: f64, two: Vector, other: f64, scale: f64) -> Common {
    let apart = length(two - one);
    if sign(apart, scale) == Ordering::Equal {
        return Common::None;
    }
    let toward = (two - one) / apart;
    let overlap = (size + other - apart).min(apart - (size - other).abs());
    let along = 0.5 * ((size - other) * (size + other) / apart + apart);
    let foot = one + toward * along;
    match sign(overlap, scale) {
        Ordering::Less => Common::None,
        Ordering::Equal => Common::One(foot),
        Ordering::Greater => {
            let square = (size - along) * (size + along);
            let half = perp(toward) * libm::sqrt(if square > 0.0 { square } else { 0.0 });
            Common::Two(foot + half, foot - half)
        }
    }
}

/// The point lies on the first element's offset, extended by the radius.
fn within_first(element: &Element, radius: f64, z: Vector, scale: f64) -> bool {
    match &element.arc {
        None => {
            let beyond = dot(z - element.end_normal() * radius, element.last);
            within_line(beyond, -beyond - element.length, radius, scale)
        }
        Some(arc) => {
            let at_end = z - element.end_normal() * radius;
            let at_start = z + (element.end - element.start) - element.start_normal() * radius;
            let ray = z + arc.end_ray * arc.end_radius;
            within_arc(element, ray, at_start, at_end, radius, scale)
        }
    }
}

/// The point lies on the second element's offset, extended by the radius.
fn within_second(element: &Element, radius: f64, z: Vector, scale: f64) -> bool {
    match &element.arc {
        None => {
            let along = dot(z - element.start_normal() * radius, element.first);
            within_line(along - element.length, -along, radius, scale)
        }
        Some(arc) => {
            let at_start = z - element.start_normal() * radius;
            let at_end = z - (element.end - element.start) - element.end_normal() * radius;
            let ray = z + arc.start_ray * arc.start_radius;
            within_arc(element, ray, at_start, at_end, radius, scale)
        }
    }
}

/// `beyond` the end, or `before` the start, of an offset line by at most the radius.
fn within_line(beyond: f64, before: f64, radius: f64, scale: f64) -> bool {
    let outside = if beyond > before { beyond } else { before };
    sign(radius - outside, scale) != Ordering::Less
}

/// `ray` points from the centre to the point; the point's distances from the ends of the offset arc count where it
/// does not lie on the arc itself. Near an end either answer is right, so that the comparison of angles needs no band.
fn within_arc(element: &Element, ray: Vector, at_start: Vector, at_end: Vector, radius: f64, scale: f64) -> bool {
    let Some(arc) = &element.arc else { return false };
    let (start, end) = (length(at_start), length(at_end));
    let nearest = if start < end { start } else { end };
    sign(radius - nearest, scale) != Ordering::Less
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
