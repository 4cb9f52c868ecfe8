//! The f64 implementation as the engine of a run. It gives no advisories.

use radcomp::device::round;
use radcomp_impl::{Engine, Sink};
use radcomp_spec::Step;

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
        let rounded = round(&block.read.block);
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
