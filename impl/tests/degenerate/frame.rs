//! Frames: whole numbers of a unit along a turned axis, as decimals far from the origin.

use proptest::prelude::*;
use radcomp_spec::{AlarmKind, Block, Centre, Clause, Compensation, Direction, Movement, Parameters, Side, Step};

use crate::common::run;

/// A frame whose first axis has the direction of a Pythagorean triple; lengths are whole numbers of its hypotenuse,
/// coordinates whole numbers of thousandths of a millimetre.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    triple: (i64, i64, i64),
    scale: i64,
    origin: (i64, i64),
}

pub fn millimetres(thousandths: i64) -> f64 {
    // The quotient of two exact numbers is the decimal, rounded.
    thousandths as f64 / 1000.0
}

impl Frame {
    pub fn vector(&self, x: i64, y: i64) -> [f64; 2] {
        let (a, b, _) = self.triple;
        [millimetres((a * x - b * y) * self.scale), millimetres((b * x + a * y) * self.scale)]
    }

    pub fn point(&self, x: i64, y: i64) -> [f64; 2] {
        let (a, b, _) = self.triple;
        let at = ((a * x - b * y) * self.scale + self.origin.0, (b * x + a * y) * self.scale + self.origin.1);
        [millimetres(at.0), millimetres(at.1)]
    }

    /// Thousandths of a millimetre.
    pub fn length(&self, units: i64) -> i64 {
        units * self.triple.2 * self.scale
    }

    pub fn line(&self, x: i64, y: i64) -> Block<f64> {
        Block::moving(Movement::Line { end: self.point(x, y) })
    }

    pub fn arc(&self, end: (i64, i64), centre: (i64, i64), direction: Direction) -> Block<f64> {
        let centre = Centre::FromStart(self.vector(centre.0, centre.1));
        Block::moving(Movement::Arc { end: self.point(end.0, end.1), centre, direction })
    }

    /// A rapid move to (-40, 0), a start-up to (-30, 0) with the tool left and its radius, in thousandths.
    pub fn start(&self, radius: i64) -> Vec<Block<f64>> {
        let mut start_up = self.line(-30, 0);
        (start_up.compensation, start_up.radius) = (Some(Compensation::On(Side::Left)), Some(millimetres(radius)));
        vec![self.line(-40, 0), start_up]
    }

    /// The program that starts so, goes on to (0, 0), and then as told.
    pub fn run(
        &self,
        radius: i64,
        parameters: &Parameters,
        rest: &[Block<f64>],
    ) -> (Vec<Step<f64>>, Option<AlarmKind>) {
        let mut blocks = self.start(radius);
        blocks.push(self.line(0, 0));
        blocks.extend_from_slice(rest);
        let (steps, alarm) = run(parameters, &blocks);
        (steps, alarm.map(|alarm| alarm.kind))
    }
}

/// The same block with the tool right of it.
pub fn right(mut block: Block<f64>) -> Block<f64> {
    block.compensation = Some(Compensation::On(Side::Right));
    block
}

/// Frames of all kinds.
pub fn frame() -> impl Strategy<Value = Frame> {
    let triples = vec![(1, 0, 1), (3, 4, 5), (-5, 12, 13), (-15, -8, 17), (20, -21, 29), (119, 120, 169)];
    let far = prop::sample::select(vec![0_i64, 1_000, 1_000_000, 100_000_000]);
    (prop::sample::select(triples), 1_i64..200, far, -1_000_i64..1_000, -1_000_i64..1_000).prop_map(
        |(triple, scale, far, x, y)| Frame { triple, scale, origin: (far * x / 1000 + x, far * y / 1000 + y) },
    )
}

/// The clause of the end of the line to (0, 0), and where it ends.
pub fn corner(steps: &[Step<f64>]) -> (Clause, [f64; 2]) {
    let step = steps.iter().find(|step| step.block == 2 && step.main).expect("the line has been run");
    match step.segment {
        radcomp_spec::Segment::Line { end } => (step.clause, end),
        _ => panic!("a line"),
    }
}

/// The points are one, but for rounding.
pub fn near(a: [f64; 2], b: [f64; 2]) -> bool {
    let size = a[0].abs().max(a[1].abs()).max(1.0);
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) <= 1e-12 * size
}

/// G03.
pub const LEFT: Direction = Direction::Counterclockwise;
