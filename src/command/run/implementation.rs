//! The f64 implementation as the engine of a run. It gives no advisories.

use radcomp_impl::{Engine, Sink};
use radcomp_model::number::nearest_f64;
use radcomp_spec::block::Point;
use radcomp_spec::{Block, Centre, Movement, Step};
use rug::Rational;

use super::{Ending, Outlet};
use crate::command::failure::{Failure, Verdict};
use crate::command::program::{Blocks, Control};

/// Runs the blocks, their numbers rounded to doubles.
pub fn run(control: &Control, blocks: Blocks<'_>, mut outlet: Outlet<'_, f64>) -> Result<Verdict, Failure> {
    let mut engine = Engine::new(&control.profile.parameters);
    for block in blocks {
        let block = match block {
            Ok(block) => block,
            Err(diagnostic) => return outlet.end(control, Ending::Refused(Box::new(diagnostic))),
        };
        let rounded = rounded(&block.read.block);
        outlet.ledger.add(block);
        let stopped = engine.push(&rounded, &mut outlet);
        outlet.printed()?;
        if let Err(alarm) = stopped {
            return outlet.end(control, Ending::Alarm(alarm));
        }
    }
    match engine.finish(&mut outlet) {
        Ok(()) => outlet.end(control, Ending::Complete),
        Err(alarm) => outlet.end(control, Ending::Alarm(alarm)),
    }
}

impl Sink for Outlet<'_, f64> {
    fn step(&mut self, step: Step<f64>) {
        Outlet::step(self, &step);
    }
}

/// The block with every number rounded to the nearest double.
fn rounded(block: &Block<Rational>) -> Block<f64> {
    let point = |[a, b]: &Point<Rational>| [nearest_f64(a), nearest_f64(b)];
    let movement = match &block.movement {
        Movement::None => Movement::None,
        Movement::Line { end } => Movement::Line { end: point(end) },
        Movement::Dummy { vector } => Movement::Dummy { vector: point(vector) },
        Movement::Arc { end, centre, direction } => {
            let centre = match centre {
                Centre::FromStart(vector) => Centre::FromStart(point(vector)),
                Centre::Radius(radius) => Centre::Radius(nearest_f64(radius)),
            };
            Movement::Arc { end: point(end), centre, direction: *direction }
        }
    };
    Block {
        movement,
        rapid: block.rapid,
        compensation: block.compensation,
        radius: block.radius.as_ref().map(nearest_f64),
        corner: block.corner,
    }
}
