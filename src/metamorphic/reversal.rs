//! A contour run backwards on the other side of the tool: the same path of the tool's centre, backwards.

use radcomp_spec::{Block, Centre, Compensation, Movement, Segment, Side, Step};
use rug::Rational;

type Point = [Rational; 2];

/// One contour, from a point in cancel mode to a point in cancel mode, run both ways. Either program first moves to the
/// point where its contour starts.
#[derive(Clone, Debug, PartialEq)]
pub struct Reversal {
    /// As programmed.
    pub forward: Vec<Block<Rational>>,
    /// Backwards.
    pub backward: Vec<Block<Rational>>,
}

impl Reversal {
    /// The first contour of a program that consists of moves alone, all on one side: where blocks without movement, dummy
    /// blocks or further codes stand, the rules look ahead in the direction of travel.
    pub fn of(blocks: &[Block<Rational>]) -> Option<Reversal> {
        let first = blocks.iter().position(|block| matches!(block.compensation, Some(Compensation::On(_))))?;
        let length = blocks[first..].iter().position(|block| block.compensation == Some(Compensation::Off))? + 1;
        let contour = &blocks[first..first + length];
        let Some(Compensation::On(side)) = contour[0].compensation else { return None };
        let plain =
            |block: &Block<Rational>| block.compensation.is_none() && block.radius.is_none() && block.corner.is_none();
        let with_vector = contour.iter().any(|block| block.vector.is_some());
        if !contour[1..length - 1].iter().all(plain) || contour[length - 1].radius.is_some() || with_vector {
            return None;
        }
        let radius = blocks[..=first].iter().rev().find_map(|block| block.radius.clone())?;
        let start = blocks[..first].iter().rev().find_map(end).unwrap_or_default();
        let mut points = vec![start];
        for block in contour {
            points.push(end(block)?);
        }
        Some(Reversal {
            forward: assembled(&points[0], contour.to_vec(), side, &radius),
            backward: assembled(&points[length], backwards(contour, &points)?, side.other(), &radius),
        })
    }
}

fn end(block: &Block<Rational>) -> Option<Point> {
    match &block.movement {
        Movement::Line { end } | Movement::Arc { end, .. } => Some(end.clone()),
        Movement::None
        | Movement::Dummy { .. }
        | Movement::HeldVector { .. }
        | Movement::NewVector { .. }
        | Movement::CornerArc { .. } => None,
    }
}

/// The moves the other way, without codes.
fn backwards(contour: &[Block<Rational>], points: &[Point]) -> Option<Vec<Block<Rational>>> {
    let reversed = contour.iter().zip(points.windows(2)).rev().map(|(block, ends)| {
        let [start, end] = ends else { return None };
        let movement = match &block.movement {
            Movement::Line { .. } => Movement::Line { end: start.clone() },
            Movement::Arc { centre, direction, .. } => Movement::Arc {
                end: start.clone(),
                centre: match centre {
                    Centre::FromStart(vector) => {
                        Centre::FromStart([0, 1].map(|axis| Rational::from(&start[axis] + &vector[axis]) - &end[axis]))
                    }
                    Centre::Radius(radius) => Centre::Radius(radius.clone()),
                },
                direction: direction.reversed(),
            },
            Movement::None
            | Movement::Dummy { .. }
            | Movement::HeldVector { .. }
            | Movement::NewVector { .. }
            | Movement::CornerArc { .. } => return None,
        };
        Some(Block { rapid: block.rapid, ..Block::moving(movement) })
    });
    reversed.collect()
}

/// A move to where the contour starts, and the contour with its codes.
fn assembled(start: &Point, mut contour: Vec<Block<Rational>>, side: Side, radius: &Rational) -> Vec<Block<Rational>> {
    let last = contour.len() - 1;
    for (index, block) in contour.iter_mut().enumerate() {
        block.compensation = match index {
            0 => Some(Compensation::On(side)),
            _ if index == last => Some(Compensation::Off),
            _ => None,
        };
        block.radius = (index == 0).then(|| radius.clone());
    }
    contour.insert(0, Block::moving(Movement::Line { end: start.clone() }));
    contour
}

/// A path without its first move, the other way; all of it belongs to one block.
pub(super) fn reversed(steps: &[Step<f64>]) -> Vec<Step<f64>> {
    let mut at = [0.0, 0.0];
    let mut turned = Vec::with_capacity(steps.len());
    for step in steps {
        let from = at;
        let segment = match &step.segment {
            Segment::Hold => Segment::Hold,
            Segment::Line { end } => {
                at = *end;
                Segment::Line { end: from }
            }
            Segment::Arc { end, centre, direction, full } => {
                at = *end;
                Segment::Arc { end: from, centre: *centre, direction: direction.reversed(), full: *full }
            }
        };
        turned.push(Step { segment, block: 0, ..step.clone() });
    }
    // The first move leads to where the contour starts, which is where the path backwards ends.
    turned.drain(..turned.len().min(1));
    turned.push(Step { segment: Segment::Line { end: at }, ..approach(steps, at) });
    turned.reverse();
    turned
}

/// A move of block 0 to a point.
fn approach(steps: &[Step<f64>], end: [f64; 2]) -> Step<f64> {
    let clause = steps.first().map_or(radcomp_spec::clause::TRC_MODE_01, |step| step.clause);
    Step { block: 0, clause, rapid: false, main: true, segment: Segment::Line { end } }
}
