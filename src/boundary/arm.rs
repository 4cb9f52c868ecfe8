//! Lines and arcs that end or start at the origin in a given direction.

use radcomp_spec::Direction;
use rug::Rational;

use super::choice::Choice;
use super::figure::{Figure, What};
use super::point::Point;

/// One of the two elements of a corner at the origin.
#[derive(Clone, Debug)]
pub(super) enum Arm {
    Line { length: Rational },
    Arc { radius: Rational, sense: Direction, sweep: Point },
}

/// `δ`: +1 counter-clockwise, -1 clockwise.
pub(super) fn sign(sense: Direction) -> Rational {
    Rational::from(match sense {
        Direction::Counterclockwise => 1,
        Direction::Clockwise => -1,
    })
}

/// Turned by an angle in the sense of an arc.
pub(super) fn swept(ray: &Point, sweep: &Point, sense: Direction) -> Point {
    match sense {
        Direction::Counterclockwise => ray.turned(sweep),
        Direction::Clockwise => ray.turned(&sweep.mirrored()),
    }
}

/// Whether an arc from one ray, over so great an angle, passes another ray.
pub(super) fn covers(from: &Point, sweep: &Point, sense: Direction, ray: &Point) -> bool {
    let relative = ray.turned(&from.mirrored());
    let relative = if sense == Direction::Clockwise { relative.mirrored() } else { relative };
    let beyond_half = |angle: &Point| angle.b < 0 || (angle.b == 0 && angle.a < 0);
    match (beyond_half(&relative), beyond_half(sweep)) {
        (false, true) => true,
        (true, false) => false,
        _ => relative.cross(sweep) >= 0,
    }
}

impl Arm {
    pub(super) fn line(choice: &mut Choice) -> Arm {
        Arm::Line { length: choice.length() }
    }

    pub(super) fn arc(choice: &mut Choice) -> Arm {
        Arm::Arc { radius: choice.length(), sense: choice.sense(), sweep: choice.sweep() }
    }

    pub(super) fn any(choice: &mut Choice) -> Arm {
        if choice.coin() { Arm::line(choice) } else { Arm::arc(choice) }
    }

    pub(super) fn is_arc(&self) -> bool {
        matches!(self, Arm::Arc { .. })
    }

    /// Its length or radius.
    pub(super) fn size(&self) -> &Rational {
        match self {
            Arm::Line { length } => length,
            Arm::Arc { radius, .. } => radius,
        }
    }

    /// The centre, when the tangent at the origin is the unit vector `along`.
    fn centre(&self, along: &Point) -> Option<Point> {
        match self {
            Arm::Line { .. } => None,
            Arm::Arc { radius, sense, .. } => Some(along.perp().times(&(radius * sign(*sense)))),
        }
    }

    /// Where the element before the corner starts, if it reaches the origin along a unit vector.
    pub(super) fn start(&self, along: &Point) -> Point {
        match (self, self.centre(along)) {
            (Arm::Arc { sense, sweep, .. }, Some(centre)) => {
                centre.plus(&swept(&centre.opposite(), sweep, sense.reversed()))
            }
            _ => along.times(self.size()).opposite(),
        }
    }

    /// Adds the element before the corner: it ends at the origin.
    pub(super) fn arrive(&self, figure: Figure, along: &Point) -> Figure {
        self.add(figure, along, Point::origin())
    }

    /// Adds the element after the corner, from the origin along a unit vector.
    pub(super) fn leave(&self, figure: Figure, along: &Point) -> Figure {
        let end = match (self, self.centre(along)) {
            (Arm::Arc { sense, sweep, .. }, Some(centre)) => centre.plus(&swept(&centre.opposite(), sweep, *sense)),
            _ => along.times(self.size()),
        };
        self.add(figure, along, end)
    }

    fn add(&self, figure: Figure, along: &Point, end: Point) -> Figure {
        match (self, self.centre(along)) {
            (Arm::Arc { sense, .. }, Some(centre)) => figure.arc(end, centre, *sense),
            _ => figure.line(end),
        }
    }

    /// What to nudge, and to where, so that the tangent at the origin turns toward `gradient`: of the element before
    /// the corner (move 0) or the one after it (move `index`).
    pub(super) fn turning(&self, index: usize, gradient: &Point) -> (What, Point) {
        match self {
            Arm::Line { .. } if index == 0 => (What::Vertex(0), gradient.opposite()),
            Arm::Line { .. } => (What::Vertex(index + 1), gradient.clone()),
            Arm::Arc { sense, .. } => (What::Centre(index), gradient.perp().times(&sign(*sense))),
        }
    }
}

/// A tool radius that fits inside every arc of a corner.
pub(super) fn tool_for(arms: &[&Arm], choice: &mut Choice) -> Rational {
    let smallest = arms.iter().filter(|arm| arm.is_arc()).map(|arm| arm.size()).min();
    match smallest {
        Some(radius) => radius * choice.part(),
        None => choice.length() * choice.part(),
    }
}
