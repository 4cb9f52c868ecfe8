//! Where a block ends and another starts when those between them are left out: the common point of their offset curves.
//! [TRC-INT-05]
//!
//! Points are relative to the programmed end of the first one here, from which the nearer of two is looked for.

use core::cmp::Ordering;

use crate::element::Element;
use crate::interference::Row;
use crate::interference::compare::Compared;
use crate::plane::{Vector, cross, direction, dot, greater, is_finite, length, magnitude, perp};
use crate::sign::sign;

impl Row {
    /// The point at which the first block and what follows `blocks` blocks behind it meet, if those can be left out;
    /// `next` is the element behind the last block.
    pub(super) fn meeting(&self, blocks: usize, next: Option<&Element>) -> Option<Vector> {
        let first = self.block(0);
        let (second, point) = if blocks + 1 < self.count {
            let second = self.block(blocks + 1);
            (&second.element, second.is_point())
        } else {
            let second = next?;
            (second, second.is_point(second.radius))
        };
        let full = |element: &Element| element.arc.as_ref().is_some_and(|arc| arc.full);
        if first.is_point() || point || full(&first.element) || full(second) {
            return None;
        }
        let meeting = common(&first.element, second)?;
        let back = Compared::element(&first.element, false).interfere(self.before.last(), meeting, self.inclusive);
        (!back).then_some(meeting)
    }
}

/// An offset curve.
#[derive(Clone, Copy)]
enum Curve {
    /// A whole line through a point, in a direction (unit).
    Line(Vector, Vector),
    /// A whole circle, by centre and radius.
    Circle(Vector, f64),
}

/// The common point of the offset curves of two elements on one side, the nearer one to the end of the first; none if
/// there is none, if two are equally near, or if the path turns by more than 90° from one element to the other.
fn common(first: &Element, second: &Element) -> Option<Vector> {
    let errors = first.last_error + second.first_error;
    if sign(dot(first.last, second.first), errors) == Ordering::Less {
        return None;
    }
    let (origin, radius) = (first.end, first.radius);
    let one = match &first.arc {
        None => Curve::Line(first.end_normal() * radius, first.last),
        Some(arc) => {
            let own = arc.end_radius;
            Curve::Circle(-arc.end_ray * own, own - first.side * arc.sense * radius)
        }
    };
    let away = second.start - origin;
    let other = match &second.arc {
        None => Curve::Line(away + second.start_normal() * radius, second.first),
        Some(arc) => {
            let own = arc.start_radius;
            Curve::Circle(away - arc.start_ray * own, own - second.side * arc.sense * radius)
        }
    };
    let scale = greater(first.scale, second.scale) + radius;
    let point = match (one, other) {
        (Curve::Line(from, along), Curve::Line(through, direction)) => {
            let sine = cross(along, direction);
            if sign(sine, errors) == Ordering::Equal {
                return None;
            }
            from + along * (cross(through - from, direction) / sine)
        }
        (Curve::Line(through, along), Curve::Circle(centre, own))
        | (Curve::Circle(centre, own), Curve::Line(through, along)) => {
            let way = centre - through;
            let foot = through + along * dot(way, along);
            let error = scale + length(way) * errors;
            nearer(foot, along, own, cross(along, way).abs(), error)?
        }
        (Curve::Circle(centre, own), Curve::Circle(away, other)) => circles(centre, own, away, other, scale)?,
    };
    let point = origin + point;
    is_finite(point).then_some(point)
}

/// The common point of two circles.
fn circles(centre: Vector, radius: f64, other: Vector, other_radius: f64, scale: f64) -> Option<Vector> {
    if sign(magnitude(other - centre), scale) == Ordering::Equal {
        return None;
    }
    let (toward, apart) = direction(other - centre);
    let (sum, difference) = (radius + other_radius, radius - other_radius);
    let gap = greater(apart - sum, difference.abs() - apart);
    let along = 0.5 * (apart + difference * (sum / apart));
    let foot = centre + toward * along;
    match sign(gap, scale) {
        Ordering::Greater => None,
        Ordering::Equal => Some(foot),
        Ordering::Less => nearer(foot, perp(toward), radius, along.abs(), scale),
    }
}

/// The points of a circle of this radius on a line at this distance from its centre lie on both sides of `foot`, along the
/// line: the one that is nearer to the origin.
fn nearer(foot: Vector, along: Vector, radius: f64, distance: f64, error: f64) -> Option<Vector> {
    let half = match sign(radius - distance, error) {
        Ordering::Less => return None,
        Ordering::Equal => return Some(foot),
        Ordering::Greater => libm::sqrt((radius - distance) * (radius + distance)),
    };
    match sign(dot(foot, along), error) {
        Ordering::Less => Some(foot + along * half),
        Ordering::Equal => None,
        Ordering::Greater => Some(foot - along * half),
    }
}
