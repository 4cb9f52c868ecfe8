//! The model as the engine of a run.

use std::cmp::Ordering;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Engine, Sink};
use radcomp_spec::{Advisory, Step};

use super::{Ending, Outlet};
use crate::command::alarm;
use crate::command::failure::{Failure, Verdict};
use crate::command::program::{Blocks, Control};

/// Runs the blocks exactly.
pub fn run(control: &Control, blocks: Blocks<'_>, mut outlet: Outlet<'_, Real>) -> Result<Verdict, Failure> {
    let mut engine = Engine::new(&control.profile.parameters);
    for block in blocks {
        let block = match block {
            Ok(block) => block,
            Err(diagnostic) => return outlet.end(control, Ending::Refused(Box::new(diagnostic))),
        };
        outlet.ledger.add(block.clone());
        let stopped = engine.push(&block.read.block, &mut outlet);
        outlet.printed()?;
        if let Some(raised) = alarm::of(stopped)? {
            return outlet.end(control, Ending::Alarm(raised));
        }
    }
    match alarm::of(engine.finish(&mut outlet))? {
        Some(raised) => outlet.end(control, Ending::Alarm(raised)),
        None => outlet.end(control, Ending::Complete),
    }
}

impl Sink for Outlet<'_, Real> {
    fn step(&mut self, step: Step<Real>) {
        Outlet::step(self, &step);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        Outlet::advisory(self, &advisory);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}
