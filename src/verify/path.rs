//! Paths with exact coordinates: the model's, and a device's, each of whose `f64` is a rational.

use radcomp_model::number::Real;
use radcomp_model::{Run, Vector};
use radcomp_spec::block::Point;
use radcomp_spec::{Alarm, Direction, Segment, Step};
use rug::Rational;

use crate::device::Answer;

/// A path of the tool's centre, from (0, 0).
pub(super) struct Path {
    /// Its moves.
    pub(super) moves: Vec<Move>,
    /// The alarm that ends it.
    pub(super) alarm: Option<Alarm>,
    origin: Vector,
}

/// One element of a path.
pub(super) struct Move {
    pub(super) block: usize,
    pub(super) rapid: bool,
    pub(super) shape: Shape,
    /// Where it ends.
    pub(super) to: Vector,
}

/// The shape of a move.
pub(super) enum Shape {
    Hold,
    Line,
    Arc { centre: Vector, direction: Direction, full: bool },
}

impl Path {
    /// The path of an outcome.
    pub(super) fn of_run(run: &Run) -> Path {
        // Every exact coordinate can be taken over.
        let path = Path::new(&run.steps, run.alarm, |[a, b]| Some(Vector::new(a.clone(), b.clone())));
        path.unwrap_or(Path { moves: Vec::new(), alarm: run.alarm, origin: Vector::zero() })
    }

    /// The path of an answer; none if a number in it is not finite.
    pub(super) fn of_answer(answer: &Answer) -> Option<Path> {
        let real = |value: f64| Rational::from_f64(value).map(Real::rational);
        Path::new(&answer.steps, answer.alarm, |[a, b]| Some(Vector::new(real(*a)?, real(*b)?)))
    }

    fn new<N>(steps: &[Step<N>], alarm: Option<Alarm>, vector: impl Fn(&Point<N>) -> Option<Vector>) -> Option<Path> {
        let mut moves = Vec::with_capacity(steps.len());
        let mut at = Vector::zero();
        for step in steps {
            let (to, shape) = match &step.segment {
                Segment::Hold => (at, Shape::Hold),
                Segment::Line { end } => (vector(end)?, Shape::Line),
                Segment::Arc { end, centre, direction, full } => {
                    (vector(end)?, Shape::Arc { centre: vector(centre)?, direction: *direction, full: *full })
                }
            };
            at = to.clone();
            moves.push(Move { block: step.block, rapid: step.rapid, shape, to });
        }
        Some(Path { moves, alarm, origin: Vector::zero() })
    }

    /// Where the tool stands after so many moves.
    pub(super) fn after(&self, moves: usize) -> &Vector {
        moves.checked_sub(1).and_then(|last| self.moves.get(last)).map_or(&self.origin, |last| &last.to)
    }
}

impl Move {
    /// Whether this is a straight move of the same block and rate as that one.
    pub(super) fn is_line_like(&self, other: &Move) -> bool {
        let lines = matches!((&self.shape, &other.shape), (Shape::Line, Shape::Line));
        lines && self.block == other.block && self.rapid == other.rapid
    }
}
