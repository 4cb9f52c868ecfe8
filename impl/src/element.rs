//! An element of the contour: a line, an arc, or the straight move that a dummy block stands for.

use core::cmp::Ordering;

use radcomp_spec::Side;
use radcomp_spec::parameters::EqualRadius;

use crate::arc_form::Arc;
use crate::plane::{Vector, direction, greater, lesser, magnitude, perp};
use crate::sign::sign;

/// A compensated element, with all that its two junctions ask of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element {
    /// Unit tangent at the start.
    pub first: Vector,
    /// Programmed end.
    pub end: Vector,
    /// Unit tangent at the end.
    pub last: Vector,
    /// Programmed start.
    pub start: Vector,
    /// σ: +1 when the tool runs left, -1 when it runs right. [TRC-PLANE-02]
    pub side: f64,
    /// The tool radius, that of the element's block: every vector of the junction at its end has it. [TRC-MODE-11]
    pub radius: f64,
    /// Length of a line.
    pub length: f64,
    /// Error of the tangent at the start, and of the ray there, in units of rounding.
    pub first_error: f64,
    /// Error of the tangent at the end, and of the ray there.
    pub last_error: f64,
    /// Bounds every coordinate of the element, those of a centre and its radii among them.
    pub scale: f64,
    /// Centre, rays, radii and sense of an arc.
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
    /// An element that no block has named yet.
    pub fn unused() -> Element {
        let zero = Vector::new(0.0, 0.0);
        Element {
            end: zero,
            start: zero,
            first: zero,
            last: zero,
            side: 1.0,
            radius: 0.0,
            length: 0.0,
            first_error: 1.0,
            last_error: 1.0,
            scale: 0.0,
            arc: None,
            block: 0,
            rapid: false,
        }
    }

    /// Makes this the line to another point. Elements are made in place: a copy costs as much as their geometry.
    #[inline(always)]
    pub fn set_line(&mut self, start: Vector, end: Vector) {
        let (along, length) = direction(end - start);
        let scale = greater(magnitude(start), magnitude(end));
        self.set_straight(start, end, along, length, scale, 1.0 + scale / length);
    }

    /// Makes this a dummy block at `start`, whose vector is not zero: a straight move along it. [TRC-DUMMY-02]
    pub fn set_dummy(&mut self, start: Vector, vector: Vector) {
        let (along, length) = direction(vector);
        // The vector is an input, not a difference of coordinates.
        self.set_straight(start, start + vector, along, length, greater(magnitude(start), length), 1.0);
    }

    /// Makes this an imaginary line through a point, in a direction (unit). [TRC-START-11], [TRC-CANCEL-08]
    pub fn set_imaginary(&mut self, through: Vector, along: Vector) {
        self.set_straight(through, through, along, 0.0, magnitude(through), 1.0);
    }

    /// Makes this a block without movement at a point. [TRC-START-08]
    pub fn set_still(&mut self, at: Vector) {
        self.set_straight(at, at, Vector::new(1.0, 0.0), 0.0, magnitude(at), 1.0);
    }

    #[inline(always)]
    fn set_straight(&mut self, start: Vector, end: Vector, along: Vector, length: f64, scale: f64, error: f64) {
        (self.start, self.end) = (start, end);
        (self.first, self.last) = (along, along);
        (self.length, self.scale) = (length, scale);
        (self.first_error, self.last_error) = (error, error);
        self.arc = None;
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

    /// Whether a tool of this radius on this side runs on the outside of the arc, or fits inside: [TRC-ARC-05], or
    /// [TRC-ARC-08] as the parameter says.
    #[inline(always)]
    pub fn tool_fits(&self, side: Side, radius: f64, equal: EqualRadius) -> bool {
        self.arc.as_ref().is_none_or(|arc| {
            let smaller = lesser(arc.start_radius, arc.end_radius);
            let inside = sigma(side) * arc.sense > 0.0;
            !inside
                || sign(smaller - radius, greater(self.scale, radius)) == Ordering::Greater
                || equal == EqualRadius::DegeneratePoint && self.has_radius(radius)
        })
    }

    /// It is an arc with the tool inside, whose offset is a point. [TRC-ARC-08]
    pub fn is_point(&self, radius: f64) -> bool {
        self.arc.as_ref().is_some_and(|arc| self.side * arc.sense > 0.0) && self.has_radius(radius)
    }

    /// Both radii of the arc are this one.
    fn has_radius(&self, radius: f64) -> bool {
        let scale = greater(self.scale, radius);
        self.arc.as_ref().is_some_and(|arc| {
            [arc.start_radius, arc.end_radius].iter().all(|own| sign(own - radius, scale) == Ordering::Equal)
        })
    }
}
