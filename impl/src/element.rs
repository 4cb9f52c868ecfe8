//! An element of the contour: a line, an arc, or the straight move that a dummy block stands for.

use core::cmp::Ordering;

use radcomp_spec::Side;

use crate::arc_form::Arc;
use crate::plane::{Vector, direction, magnitude, perp};
use crate::sign::sign;

/// A compensated element, with all that its two junctions ask of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element {
    /// Programmed end.
    pub end: Vector,
    /// Programmed start.
    pub start: Vector,
    /// Unit tangent at the start.
    pub first: Vector,
    /// Unit tangent at the end.
    pub last: Vector,
    /// σ: +1 when the tool runs left, -1 when it runs right. [TRC-PLANE-02]
    pub side: f64,
    /// Length of a line.
    pub length: f64,
    /// Error of the tangent at the start, in units of rounding.
    pub first_error: f64,
    /// Error of the tangent at the end.
    pub last_error: f64,
    /// Bounds every coordinate of the element.
    pub scale: f64,
    /// Centre, radii and sense of an arc.
    pub arc: Option<Arc>,
    /// Index of its block.
    pub block: usize,
    /// Its block moves at rapid rate.
    pub rapid: bool,
}

/// σ of a side. [TRC-PLANE-02]
#[inline(always)]
pub(crate) fn sigma(side: Side) -> f64 {
    match side {
        Side::Left => 1.0,
        Side::Right => -1.0,
    }
}

impl Element {
    /// The line from `start` to another point.
    #[inline(always)]
    pub fn line(start: Vector, end: Vector, side: Side, block: usize, rapid: bool) -> Element {
        let (along, length) = direction(end - start);
        let scale = magnitude(start).max(magnitude(end));
        let error = 1.0 + scale / length;
        Element {
            start,
            end,
            first: along,
            last: along,
            side: sigma(side),
            length,
            first_error: error,
            last_error: error,
            scale,
            arc: None,
            block,
            rapid,
        }
    }

    /// A dummy block at `start`, whose vector is not zero: a straight move along it. [TRC-DUMMY-02]
    pub fn dummy(start: Vector, vector: Vector, side: Side, block: usize) -> Element {
        let (along, length) = direction(vector);
        Element {
            start,
            end: start + vector,
            first: along,
            last: along,
            side: sigma(side),
            length,
            // The vector is an input, not a difference of coordinates.
            first_error: 1.0,
            last_error: 1.0,
            scale: magnitude(start).max(length),
            arc: None,
            block,
            rapid: false,
        }
    }

    /// The arc from `start` to `end`.
    #[inline]
    pub fn arc(start: Vector, end: Vector, arc: Arc, side: Side, block: usize, rapid: bool) -> Element {
        Element {
            start,
            end,
            first: perp(arc.start_ray) * arc.sense,
            last: perp(arc.end_ray) * arc.sense,
            side: sigma(side),
            length: 0.0,
            first_error: arc.start_error,
            last_error: arc.end_error,
            scale: arc.scale,
            arc: Some(arc),
            block,
            rapid,
        }
    }

    /// `n(u)` at the start. [TRC-PLANE-02]
    #[inline(always)]
    pub fn start_normal(&self) -> Vector {
        perp(self.first) * self.side
    }

    /// `n(u)` at the end.
    #[inline(always)]
    pub fn end_normal(&self) -> Vector {
        perp(self.last) * self.side
    }

    /// The vector at right angles to the element at its start, `P + r·n`.
    #[inline(always)]
    pub fn start_vector(&self, radius: f64) -> Vector {
        self.start + self.start_normal() * radius
    }

    /// The vector at right angles to the element at its end.
    #[inline(always)]
    pub fn end_vector(&self, radius: f64) -> Vector {
        self.end + self.end_normal() * radius
    }

    /// σ·δ divided by the radius at the end, 0 for a line: positive when the tool runs inside. [TRC-PLANE-04]
    #[inline(always)]
    pub fn end_curvature(&self) -> f64 {
        self.arc.as_ref().map_or(0.0, |arc| self.side * arc.sense / arc.end_radius)
    }

    /// The same at the start.
    #[inline(always)]
    pub fn start_curvature(&self) -> f64 {
        self.arc.as_ref().map_or(0.0, |arc| self.side * arc.sense / arc.start_radius)
    }
}

/// Whether a tool of this radius runs on the arc's outside, or fits inside. [TRC-ARC-05]
pub(crate) fn tool_fits(arc: &Arc, side: Side, radius: f64) -> bool {
    let smaller = arc.start_radius.min(arc.end_radius);
    sigma(side) * arc.sense < 0.0 || sign(smaller - radius, arc.scale.max(radius)) == Ordering::Greater
}
