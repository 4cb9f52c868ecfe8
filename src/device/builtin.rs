//! The device `builtin`: radcomp-impl in this process.

use radcomp_model::number::nearest_f64;
use radcomp_spec::{Block, Centre, Movement, Parameters, Step};
use rug::Rational;

use super::{Answer, Device, DeviceFault};

/// radcomp-impl, driven in process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Builtin;

impl Device for Builtin {
    fn name(&self) -> &str {
        "builtin"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        Ok(compensate(parameters, blocks))
    }
}

fn compensate(parameters: &Parameters, blocks: &[Block<Rational>]) -> Answer {
    let mut answer = Collect(Answer { steps: Vec::with_capacity(2 * blocks.len()), alarm: None });
    let mut engine = radcomp_impl::Engine::new(parameters);
    let result = blocks
        .iter()
        .try_for_each(|block| engine.push(&round(block), &mut answer))
        .and_then(|()| engine.finish(&mut answer));
    answer.0.alarm = result.err();
    answer.0
}

struct Collect(Answer);

impl radcomp_impl::Sink for Collect {
    fn step(&mut self, step: Step<f64>) {
        self.0.steps.push(step);
    }
}

/// The block with every number rounded to the nearest `f64`.
pub fn round(block: &Block<Rational>) -> Block<f64> {
    let point = |[a, b]: &[Rational; 2]| [nearest_f64(a), nearest_f64(b)];
    Block {
        movement: match &block.movement {
            Movement::None => Movement::None,
            Movement::Line { end } => Movement::Line { end: point(end) },
            Movement::Dummy { vector } => Movement::Dummy { vector: point(vector) },
            Movement::HeldVector { end } => Movement::HeldVector { end: point(end) },
            Movement::NewVector { vector } => Movement::NewVector { vector: point(vector) },
            Movement::CornerArc { vector } => Movement::CornerArc { vector: vector.as_ref().map(point) },
            Movement::Arc { end, centre, direction } => Movement::Arc {
                end: point(end),
                centre: match centre {
                    Centre::FromStart(vector) => Centre::FromStart(point(vector)),
                    Centre::Radius(radius) => Centre::Radius(nearest_f64(radius)),
                },
                direction: *direction,
            },
        },
        rapid: block.rapid,
        compensation: block.compensation,
        vector: block.vector.as_ref().map(point),
        radius: block.radius.as_ref().map(nearest_f64),
        corner: block.corner,
        approach: block.approach,
        stops_look_ahead: block.stops_look_ahead,
        not_in_mode: block.not_in_mode,
    }
}
