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
    /// Index of the path step that begins it.
    pub step: usize,
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

/// How exactly two paths are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tolerance {
    /// How far a point may lie off, in millimetres.
    pub(crate) delta: f64,
    /// Differences up to here, in millimetres, are the rounding of the device.
    pub(crate) grain: f64,
}

impl Tolerance {
    /// The grain is a few bands wide: each of a device's numbers may be rounded.
    pub(crate) fn new(delta: f64, beta: f64) -> Self {
        Tolerance { delta, grain: (16.0 * beta).min(delta) }
    }

    /// How far a device's point may lie off: δ, and a unit in the last place of its larger coordinate, for what it is
    /// compared with is rounded as well. A part of a metre makes 2⁻⁴² mm of that.
    pub(crate) fn at(&self, [a, b]: [f64; 2]) -> f64 {
        self.delta + f64::EPSILON * a.abs().max(b.abs())
    }
}

/// How much of a turn an arc makes whose ends lie near each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// Hardly any of it.
    Short,
    /// Nearly all of it.
    Long,
    /// The ends tell it, or lie so near to each other that the rounding decides.
    Either,
}

impl Extent {
    /// Whether two arcs with the same ends may be one.
    pub(crate) fn agrees(self, other: Extent) -> bool {
        self == other || self == Extent::Either || other == Extent::Either
    }
}

impl Stroke {
    /// How much of a turn an arc makes, if its ends lie within `near` of each other and it is larger than that. Ends
    /// within `grain` of one ray from the centre may be rounded past each other.
    pub(crate) fn extent(&self, near: f64, grain: f64) -> Extent {
        let chord = distance(self.from, self.to);
        let Shape::Arc { centre, direction, full: false } = self.shape else { return Extent::Either };
        if chord > near || 2.0 * distance(self.from, centre) <= near {
            return Extent::Either;
        }
        let ray = [self.from[0] - centre[0], self.from[1] - centre[1]];
        // The cross product with the chord keeps its sign where that of the two rays would cancel.
        let onward = ray[0] * (self.to[1] - self.from[1]) - ray[1] * (self.to[0] - self.from[0]);
        // Ends that lie on one ray, at two radii, or hardly beside it.
        if onward.abs() <= grain * distance(self.from, centre) {
            return Extent::Either;
        }
        match (direction, onward >= 0.0) {
            (Direction::Counterclockwise, true) | (Direction::Clockwise, false) => Extent::Short,
            _ => Extent::Long,
        }
    }
}

/// The strokes of a path that starts at (0, 0): moves that stay within `delta` of where the last stroke ended are left
/// out, and straight moves of one block (of any blocks, without `blocks`) that continue each other within `delta` are
/// one.
pub(crate) fn strokes(steps: &[Step<f64>], tolerance: Tolerance, blocks: bool) -> Vec<Stroke> {
    let delta = tolerance.delta;
    let mut strokes: Vec<Stroke> = Vec::with_capacity(steps.len());
    let mut at = [0.0, 0.0];
    // Where the last stroke ended: many short moves are no short move.
    let mut left = at;
    for (step_index, step) in steps.iter().enumerate() {
        let (to, shape) = match step.segment {
            Segment::Hold => (at, Shape::Hold),
            Segment::Line { end } => (end, Shape::Line),
            Segment::Arc { end, centre, direction, full } => (end, Shape::Arc { centre, direction, full }),
        };
        let mut stroke =
            Stroke { block: step.block, clause: step.clause, rapid: step.rapid, from: at, to, shape, step: step_index };
        at = to;
        let is_short = match shape {
            Shape::Hold | Shape::Arc { full: true, .. } => false,
            Shape::Line => distance(left, to) <= delta,
            Shape::Arc { .. } => {
                distance(left, to) <= delta
                    && distance(stroke.from, to) <= delta
                    && stroke.extent(delta, tolerance.grain) != Extent::Long
            }
        };
        if is_short {
            continue;
        }
        if shape == Shape::Line {
            stroke.from = left;
        }
        if shape != Shape::Hold {
            left = to;
        }
        match strokes.last_mut() {
            Some(last) if shape == Shape::Line && continues(last, &stroke, delta, blocks) => last.to = to,
            _ => strokes.push(stroke),
        }
    }
    strokes
}

/// Whether a straight stroke goes on along the one before, in the same block.
pub(crate) fn continues(last: &Stroke, next: &Stroke, delta: f64, blocks: bool) -> bool {
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
