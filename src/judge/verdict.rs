//! Verdicts.

use radcomp_model::{Run, run};
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::budget::Budget;
use super::compare::{self, Divergence};
use super::fork::{self, Flip};
use super::witness::{self, Witness};
use crate::device::{Answer, Device, DeviceFault, ask};

/// What the judge says of one answer.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The exact outcome, to within δ.
    Exact,
    /// The exact outcome of an input within β of the program, to within δ.
    Admissible(Witness),
    /// An outcome that the band admits: these decisions went another way. No witness has been found.
    AdmissibleWithoutWitness(Vec<Flip>),
    /// No admitted outcome.
    Inadmissible(Box<Divergence>),
    /// No admitted outcome among those looked at; there were more than the bound.
    ForkLimit(Box<Divergence>),
    /// No answer.
    Fault(DeviceFault),
}

impl Verdict {
    /// Whether the device has failed on this program.
    pub fn is_red(&self) -> bool {
        !self.is_green() && !matches!(self, Verdict::Fault(DeviceFault::Unsupported(_)))
    }

    /// Whether the device has passed. What it does not support it has neither failed nor passed.
    pub fn is_green(&self) -> bool {
        matches!(self, Verdict::Exact | Verdict::Admissible(_) | Verdict::AdmissibleWithoutWitness(_))
    }

    /// The name used in reports.
    pub fn id(&self) -> &'static str {
        match self {
            Verdict::Exact => "exact",
            Verdict::Admissible(_) => "admissible",
            Verdict::AdmissibleWithoutWitness(_) => "admissible-without-witness",
            Verdict::Inadmissible(_) => "inadmissible",
            Verdict::ForkLimit(_) => "fork-limit",
            Verdict::Fault(fault) => fault.id(),
        }
    }
}

/// A verdict, and what it was measured against.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The verdict.
    pub verdict: Verdict,
    /// The exact outcome.
    pub exact: Run,
    /// The device's answer, if it gave one.
    pub answer: Option<Answer>,
}

/// Judges a device's answer to one program.
pub fn judge(device: &mut dyn Device, parameters: &Parameters, blocks: &[Block<Rational>], budget: &Budget) -> Judged {
    judge_answer(ask(device, parameters, blocks), parameters, blocks, budget)
}

/// Judges an answer to one program.
pub fn judge_answer(
    answer: Result<Answer, DeviceFault>,
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    budget: &Budget,
) -> Judged {
    let exact = run(parameters, blocks);
    match answer {
        Ok(answer) => {
            let verdict = measure(parameters, blocks, &exact, &answer, budget);
            Judged { verdict, exact, answer: Some(answer) }
        }
        Err(fault) => Judged { verdict: Verdict::Fault(fault), exact, answer: None },
    }
}

fn measure(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    exact: &Run,
    answer: &Answer,
    budget: &Budget,
) -> Verdict {
    let (beta, delta) = (budget.beta(blocks), budget.delta);
    let Some(divergence) = compare::divergence(exact, answer, delta) else { return Verdict::Exact };
    if let Some(witness) = witness::for_points(parameters, blocks, exact, answer, beta, delta) {
        return Verdict::Admissible(witness);
    }
    match fork::find(parameters, blocks, beta, |run| compare::divergence(run, answer, delta).is_none()) {
        Ok(flips) => match witness::for_flips(parameters, blocks, answer, &flips, beta, delta) {
            Some(witness) => Verdict::Admissible(witness),
            None => Verdict::AdmissibleWithoutWitness(flips),
        },
        Err(exhausted) if exhausted.limit_hit => Verdict::ForkLimit(Box::new(divergence)),
        Err(_) => Verdict::Inadmissible(Box::new(divergence)),
    }
}
