//! What blocks program, in doubles: for words and drawings, never for a decision.

use radcomp_model::number::nearest_f64;
use radcomp_spec::block::Point;
use radcomp_spec::{Block, Centre, Direction, Movement};
use rug::Rational;

/// Follows a program from block to block.
#[derive(Clone, Debug, Default)]
pub struct Programmed {
    exact: Point<Rational>,
}

/// The move, or the direction, that one block programs.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgrammedMove {
    /// Where it starts.
    pub start: Point<f64>,
    /// Where it ends.
    pub end: Point<f64>,
    /// What lies between.
    pub shape: Shape,
}

/// The form of a move.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Straight, of a length that is not zero.
    Line,
    /// Circular.
    Arc {
        /// Centre.
        centre: Point<f64>,
        /// Sense.
        direction: Direction,
        /// Start and end are one point.
        full: bool,
    },
    /// A dummy block with this vector ([TRC-DUMMY-01]).
    Dummy(Point<f64>),
    /// G38 or G39 with this vector ([TRC-VEC-01]).
    Direction(Point<f64>),
}

impl Programmed {
    /// A program that starts at (0, 0).
    pub fn new() -> Self {
        Programmed::default()
    }

    /// What the next block programs; none if it does not move ([TRC-LOOK-01]).
    pub fn next(&mut self, block: &Block<Rational>) -> Option<ProgrammedMove> {
        let start = doubles(&self.exact);
        let (end, shape) = match &block.movement {
            Movement::None | Movement::CornerArc { vector: None } => return None,
            Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) } => {
                return Some(ProgrammedMove { start, end: start, shape: Shape::Direction(doubles(vector)) });
            }
            Movement::Dummy { vector } => {
                return Some(ProgrammedMove { start, end: start, shape: Shape::Dummy(doubles(vector)) });
            }
            Movement::Line { end } | Movement::HeldVector { end } if *end == self.exact => return None,
            Movement::Line { end } | Movement::HeldVector { end } => (end, Shape::Line),
            Movement::Arc { end, centre, direction } => {
                let centre = match centre {
                    Centre::FromStart(vector) => {
                        doubles(&[0, 1].map(|axis| Rational::from(&self.exact[axis] + &vector[axis])))
                    }
                    Centre::Radius(radius) => from_radius(start, doubles(end), nearest_f64(radius), *direction),
                };
                (end, Shape::Arc { centre, direction: *direction, full: *end == self.exact })
            }
        };
        self.exact.clone_from(end);
        Some(ProgrammedMove { start, end: doubles(end), shape })
    }

    /// Where the program stands.
    pub fn position(&self) -> &Point<Rational> {
        &self.exact
    }
}

fn doubles(point: &Point<Rational>) -> Point<f64> {
    [nearest_f64(&point[0]), nearest_f64(&point[1])]
}

/// [TRC-ARC-01]; a radius too small for its chord gives the middle of the chord.
fn from_radius(start: Point<f64>, end: Point<f64>, radius: f64, direction: Direction) -> Point<f64> {
    let chord = [end[0] - start[0], end[1] - start[1]];
    let length = chord[0].hypot(chord[1]);
    if length == 0.0 {
        return start;
    }
    let height = (radius * radius - length * length / 4.0).max(0.0).sqrt();
    let left = (radius >= 0.0) == (direction == Direction::Counterclockwise);
    let height = if left { height } else { -height };
    let middle = [start[0].midpoint(end[0]), start[1].midpoint(end[1])];
    [middle[0] - chord[1] / length * height, middle[1] + chord[0] / length * height]
}

impl ProgrammedMove {
    /// The direction of travel at its start, in degrees from the first axis.
    pub fn first_heading(&self) -> f64 {
        self.heading_at(self.start)
    }

    /// The direction of travel at its end, in degrees from the first axis.
    pub fn last_heading(&self) -> f64 {
        self.heading_at(self.end)
    }

    fn heading_at(&self, point: Point<f64>) -> f64 {
        let [a, b] = match &self.shape {
            Shape::Line => [self.end[0] - self.start[0], self.end[1] - self.start[1]],
            Shape::Dummy(vector) | Shape::Direction(vector) => *vector,
            Shape::Arc { centre, direction, .. } => {
                let ray = [point[0] - centre[0], point[1] - centre[1]];
                match direction {
                    Direction::Counterclockwise => [-ray[1], ray[0]],
                    Direction::Clockwise => [ray[1], -ray[0]],
                }
            }
        };
        b.atan2(a).to_degrees()
    }

    /// The distance from start to end in a straight line.
    pub fn distance(&self) -> f64 {
        (self.end[0] - self.start[0]).hypot(self.end[1] - self.start[1])
    }
}

/// The turn from one heading to another, in degrees from -180 to 180, positive counter-clockwise.
pub(super) fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    if turn > 180.0 { turn - 360.0 } else { turn }
}
