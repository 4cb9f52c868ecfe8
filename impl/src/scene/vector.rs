//! Vectors that the program gives, and elements between two offset values. [TRC-VEC-01] to [TRC-VEC-06],
//! [TRC-START-10], [TRC-START-11], [TRC-CANCEL-08], [TRC-MODE-11]

use core::cmp::Ordering;

use radcomp_spec::parameters::{EqualRadius, SideCodeVector};
use radcomp_spec::{AlarmKind, Direction, Side, clause};

use super::{Scene, State, places};
use crate::element::{Element, sigma};
use crate::engine::Sink;
use crate::geometry::{Geometry, Toward};
use crate::path::PathEnd;
use crate::plane::{Vector, cross, direction, dot, greater, magnitude, perp};
use crate::sign::sign;

/// The alarm of an arc whose value is not that of the junction before it: the tool must fit with either, and a full
/// circle has no such junction. [TRC-MODE-11]
#[cold]
pub(super) fn fault_between(arc: &Element, side: Side, before: f64, own: f64) -> Option<AlarmKind> {
    if !arc.tool_fits(side, greater(before, own), EqualRadius::Alarm) {
        return Some(AlarmKind::RadiusTooSmall);
    }
    let full = arc.arc.as_ref().is_some_and(|arc| arc.full);
    full.then_some(AlarmKind::OffsetChangedInMode)
}

/// Where an element ends when the vector behind it is `given` at right angles to a direction; an arc ends on its own
/// normal. [TRC-VEC-05]
pub(super) fn end_of(element: &Element, given: Vector, side: Side) -> Vector {
    match element.arc {
        Some(_) => element.end_vector(element.radius),
        None => at_right_angles(element.end, given, side, element.radius),
    }
}

/// `P + r·n(v)`, v being the direction of a vector that is not zero.
fn at_right_angles(point: Vector, given: Vector, side: Side, radius: f64) -> Vector {
    let (along, _) = direction(given);
    point + perp(along) * (sigma(side) * radius)
}

impl<S: Sink> Scene<'_, S> {
    /// Keeps the imaginary line of the start-up block read, or that it gives none. [TRC-START-11]
    pub(super) fn note_imaginary(&mut self) {
        let sense = match self.state.rules.side_code_vector {
            SideCodeVector::ImaginaryLine => 1.0,
            SideCodeVector::ImaginaryPoint => -1.0,
            SideCodeVector::Refused | SideCodeVector::RightAngles => 0.0,
        };
        self.state.imaginary = if self.given == Vector::zeros() { self.given } else { direction(self.given).0 * sense };
    }

    /// Makes the imaginary line of the cancel block read the element read. [TRC-CANCEL-08]
    #[cold]
    pub(super) fn set_imaginary(&mut self) {
        let State { elements, pending, .. } = &mut *self.state;
        let (first, next) = places(*pending);
        let through = elements[first].end;
        elements[next].set_imaginary(through, direction(self.given).0);
    }

    /// [TRC-VEC-02], [TRC-VEC-03]: the arc about the end of the last element that ended, with its value, from its normal.
    pub(super) fn emit_corner_arc(&mut self, block: usize, rapid: bool, toward: Toward, side: Side) {
        let State { elements, pending, tool, .. } = &mut *self.state;
        let (last, next) = places(*pending);
        let (last, next) = (&elements[last], &elements[next]);
        let (along, error, clause) = match toward {
            Toward::Vector => (direction(self.given).0, 1.0, clause::TRC_VEC_02),
            Toward::Element => (next.first, next.first_error, clause::TRC_VEC_03),
        };
        let normal = perp(along) * sigma(side);
        let (from, bound) = (last.end_normal(), last.last_error + error);
        let stays = sign(cross(from, normal), bound) == Ordering::Equal && dot(from, normal) > 0.0;
        if stays || last.radius == 0.0 {
            return self.hold(block, rapid, clause);
        }
        let direction = match side {
            Side::Left => Direction::Clockwise,
            Side::Right => Direction::Counterclockwise,
        };
        let to = last.end + normal * last.radius;
        PathEnd { tool, sink: self.sink, block, rapid }.corner_arc(to, last.end, direction, clause);
    }

    /// [TRC-VEC-05]
    pub(super) fn emit_new_vector(&mut self, side: Side, settled: bool) {
        let State { elements, pending, tool, carried, radius_in_force, .. } = &mut *self.state;
        let (last, _) = places(*pending);
        let radius = if settled { *radius_in_force } else { elements[last].radius };
        let to = at_right_angles(self.end, self.given, side, radius);
        let scale = greater(greater(magnitude(self.end), magnitude(*tool)), *carried) + radius;
        if sign(magnitude(to - *tool), scale) == Ordering::Equal {
            self.hold(self.block, self.rapid, clause::TRC_VEC_05);
        } else {
            *carried = 0.0;
            let mut path = PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid };
            path.own_move(None, to, false, clause::TRC_VEC_05);
        }
    }
}
