//! A whole program at once.

use core::cmp::Ordering;

use radcomp_spec::{Advisory, Alarm, Block, Parameters, Step};
use rug::Rational;

use crate::decision::{Decision, Sink, Stop};
use crate::engine::Engine;
use crate::number::Real;

/// The exact outcome of a program, with every decision that led to it.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// The path of the tool's centre.
    pub steps: Vec<Step<Real>>,
    /// Warnings.
    pub advisories: Vec<Advisory<Real>>,
    /// Decisions in the order in which they were taken, each with the branch that was followed.
    pub decisions: Vec<(Decision, Ordering)>,
    /// The alarm that ended the path.
    pub alarm: Option<Alarm>,
    /// The decisions were answered in a way that no geometry satisfies; never with exact answers.
    pub contradiction: bool,
}

/// Runs a program exactly.
pub fn run<'a>(parameters: &Parameters, blocks: impl IntoIterator<Item = &'a Block<Rational>>) -> Run {
    run_with(parameters, blocks, |decision| decision.exact)
}

/// Runs a program with another answer to some decisions.
pub fn run_with<'a>(
    parameters: &Parameters,
    blocks: impl IntoIterator<Item = &'a Block<Rational>>,
    answer: impl FnMut(&Decision) -> Ordering,
) -> Run {
    follow(Engine::new(parameters), blocks, answer)
}

/// Runs a program exactly, remembering which numbers of the outcome come from the program: [`Real::reach`] then tells what
/// a change of the program makes of them. Slower than [`run`].
pub fn run_on_inputs<'a>(parameters: &Parameters, blocks: impl IntoIterator<Item = &'a Block<Rational>>) -> Run {
    follow(Engine::on_inputs(parameters), blocks, |decision| decision.exact)
}

fn follow<'a>(
    mut engine: Engine,
    blocks: impl IntoIterator<Item = &'a Block<Rational>>,
    answer: impl FnMut(&Decision) -> Ordering,
) -> Run {
    let mut recorder = Recorder { run: Run::default(), answer };
    let stopped = blocks
        .into_iter()
        .try_for_each(|block| engine.push(block, &mut recorder))
        .and_then(|()| engine.finish(&mut recorder));
    let mut run = recorder.run;
    match stopped {
        Ok(()) => {}
        Err(Stop::Alarm(alarm)) => run.alarm = Some(alarm),
        Err(Stop::Contradiction) => run.contradiction = true,
    }
    run
}

struct Recorder<F> {
    run: Run,
    answer: F,
}

impl<F: FnMut(&Decision) -> Ordering> Sink for Recorder<F> {
    fn step(&mut self, step: Step<Real>) {
        self.run.steps.push(step);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        self.run.advisories.push(advisory);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        let answer = (self.answer)(&decision);
        self.run.decisions.push((decision, answer));
        answer
    }
}
