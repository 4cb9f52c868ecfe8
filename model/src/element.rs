//! Compensated elements: a line, an arc, or the line that a dummy block stands for.

use radcomp_spec::{Direction, Side};

use crate::geometry::Vector;
use crate::number::Real;

/// A programmed element of the contour.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    pub(crate) start: Vector,
    pub(crate) end: Vector,
    pub(crate) shape: Shape,
}

/// Its shape.
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    /// Straight.
    Line { direction: Vector, length: Real },
    /// Circular; each end has its own radius ([TRC-ARC-04]).
    Arc {
        centre: Vector,
        sense: Direction,
        start_radius: Real,
        end_radius: Real,
        full: bool,
        /// What stands for its offset curve, if it is an entry move.
        entry: Option<Box<EntryArc>>,
    },
}

/// The tool's own arc of an entry move: about a moved centre, from where the tool stands to the normal at the end of
/// the programmed arc ([TRC-START-09]).
#[derive(Clone, Debug)]
pub(crate) struct EntryArc {
    pub(crate) start: Vector,
    pub(crate) centre: Vector,
    pub(crate) radius: Real,
    pub(crate) end: Vector,
}

/// One end of an element, as a junction sees it.
#[derive(Clone, Debug)]
pub(crate) struct Arm {
    /// The point of the junction.
    pub(crate) point: Vector,
    /// Tangent in the direction of travel, as long as the arm: the line's length or the arc's radius.
    pub(crate) tangent: Vector,
    /// Length of the tangent.
    pub(crate) length: Real,
    /// The circle, if the element is an arc.
    pub(crate) circle: Option<Circle>,
}

/// The circle of an arc at one of its ends.
#[derive(Clone, Debug)]
pub(crate) struct Circle {
    pub(crate) centre: Vector,
    pub(crate) radius: Real,
    pub(crate) sense: Direction,
    /// The offset circle's radius, where it is no offset of this circle but that of an [`EntryArc`].
    entry_radius: Option<Real>,
}

impl Element {
    /// A line between two different points.
    pub(crate) fn line(start: Vector, end: Vector) -> Self {
        let direction = end.minus(&start);
        let length = direction.length();
        Element { start, end, shape: Shape::Line { direction, length } }
    }

    /// Whether the element is an arc.
    pub(crate) fn is_arc(&self) -> bool {
        matches!(self.shape, Shape::Arc { .. })
    }

    /// The end of the element, looking along the direction of travel.
    pub(crate) fn last_arm(&self) -> Arm {
        self.arm(&self.end, |_, end| end)
    }

    /// The start of the element, looking along the direction of travel.
    pub(crate) fn first_arm(&self) -> Arm {
        self.arm(&self.start, |start, _| start)
    }

    fn arm<'a>(&'a self, point: &Vector, which: impl Fn(&'a Real, &'a Real) -> &'a Real) -> Arm {
        match &self.shape {
            Shape::Line { direction, length } => {
                Arm { point: point.clone(), tangent: direction.clone(), length: length.clone(), circle: None }
            }
            Shape::Arc { centre, sense, start_radius, end_radius, entry, .. } => {
                let radius = which(start_radius, end_radius).clone();
                let ray = point.minus(centre);
                let tangent = match sense {
                    Direction::Counterclockwise => ray.perp(),
                    Direction::Clockwise => ray.perp().opposite(),
                };
                let entry = entry.as_deref();
                let circle = Circle {
                    centre: entry.map_or(centre, |entry| &entry.centre).clone(),
                    radius: radius.clone(),
                    sense: *sense,
                    entry_radius: entry.map(|entry| entry.radius.clone()),
                };
                Arm { point: point.clone(), tangent, length: radius, circle: Some(circle) }
            }
        }
    }
}

impl Arm {
    /// An end of an imaginary line through a point, along a vector; none if that is zero.
    pub(crate) fn imaginary(point: &Vector, along: &Vector) -> Option<Self> {
        if along.is_zero() {
            return None;
        }
        Some(Arm { point: point.clone(), tangent: along.clone(), length: along.length(), circle: None })
    }

    /// `r / length`: what turns the tangent into a vector as long as the tool radius.
    fn radius_per_length(&self, radius: &Real) -> Real {
        // An arm is as long as a line that moves or an arc whose centre is neither of its ends.
        radius.checked_div(&self.length).unwrap_or_else(Real::zero)
    }

    /// The vector at right angles, `P + r·n` ([TRC-PLANE-02]).
    pub(crate) fn normal(&self, side: Side, radius: &Real) -> Vector {
        self.point.along(&self.tangent.toward(side), &self.radius_per_length(radius))
    }

    /// `r·u`: the tangent as long as the tool radius.
    pub(crate) fn advance(&self, radius: &Real) -> Vector {
        self.tangent.times(&self.radius_per_length(radius))
    }

    /// The unit tangent.
    pub(crate) fn unit(&self) -> Vector {
        self.advance(&Real::one())
    }
}

impl Circle {
    /// The tool runs inside an arc when it stands on the side of its centre ([TRC-PLANE-04]).
    pub(crate) fn tool_inside(&self, side: Side) -> bool {
        tool_inside(self.sense, side)
    }

    /// Radius of the offset circle, `R - σ·δ·r` ([TRC-PLANE-04]), or that of an entry move.
    pub(crate) fn offset_radius(&self, side: Side, radius: &Real) -> Real {
        if let Some(entry) = &self.entry_radius {
            return entry.clone();
        }
        if self.tool_inside(side) { &self.radius - radius } else { &self.radius + radius }
    }
}

/// `σ·δ = +1`: left of a counter-clockwise arc, or right of a clockwise one.
pub(crate) fn tool_inside(sense: Direction, side: Side) -> bool {
    matches!((sense, side), (Direction::Counterclockwise, Side::Left) | (Direction::Clockwise, Side::Right))
}
