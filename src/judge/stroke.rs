//! Paths as strokes: what is left of path steps when splits of straight lines and moves of no length are forgotten.

use radcomp_spec::{Clause, Direction, Segment, Step};

/// One element of a path, with its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Index of the block that it belongs to.
    pub block: usize,
    /// The clause that made it.
    pub clause: Clause,
    /// At rapid traverse.
    pub rapid: bool,
    /// Start point.
    pub from: [f64; 2],
    /// End point.
    pub to: [f64; 2],
    /// Its shape.
    pub shape: Shape,
}

/// The shape of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// Circular.
    Arc {
        /// Centre.
        centre: [f64; 2],
        /// Sense.
        direction: Direction,
        /// A whole turn.
        full: bool,
    },
    /// A block without movement is executed here.
    Hold,
}

/// Distance of two points.
pub(crate) fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1])
}

/// The strokes of a path that starts at (0, 0): moves no longer than `delta` are left out, and straight moves of one
/// block (of any blocks, without `blocks`) that continue each other within `delta` are one.
pub(crate) fn strokes(steps: &[Step<f64>], delta: f64, blocks: bool) -> Vec<Stroke> {
    let mut strokes: Vec<Stroke> = Vec::with_capacity(steps.len());
    let mut at = [0.0, 0.0];
    for step in steps {
        let (to, shape) = match step.segment {
            Segment::Hold => (at, Shape::Hold),
            Segment::Line { end } => (end, Shape::Line),
            Segment::Arc { end, centre, direction, full } => (end, Shape::Arc { centre, direction, full }),
        };
        let stroke = Stroke { block: step.block, clause: step.clause, rapid: step.rapid, from: at, to, shape };
        at = to;
        match shape {
            Shape::Hold | Shape::Arc { full: true, .. } => strokes.push(stroke),
            _ if distance(stroke.from, to) <= delta => {}
            Shape::Line => match strokes.last_mut() {
                Some(last) if continues(last, &stroke, delta, blocks) => last.to = to,
                _ => strokes.push(stroke),
            },
            Shape::Arc { .. } => strokes.push(stroke),
        }
    }
    strokes
}

/// Whether a straight stroke goes on along the one before, in the same block.
fn continues(last: &Stroke, next: &Stroke, delta: f64, blocks: bool) -> bool {
    if last.shape != Shape::Line || (blocks && last.block != next.block) || last.rapid != next.rapid {
        return false;
    }
    let whole = [next.to[0] - last.from[0], next.to[1] - last.from[1]];
    let part = [last.to[0] - last.from[0], last.to[1] - last.from[1]];
    let length = whole[0].hypot(whole[1]);
    if length <= delta {
        return false;
    }
    let along = (part[0] * whole[0] + part[1] * whole[1]) / length;
    let off = (part[1] * whole[0] - part[0] * whole[1]).abs() / length;
    off <= delta / 4.0 && along >= 0.0 && along <= length
}
