//! Verdicts.

use radcomp_model::{Run, run};
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::budget::Budget;
use super::compare::Divergence;
use super::fork::{self, Flip, Reception};
use super::stroke::Tolerance;
use super::witness::{Search, Ties, Witness};
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
    /// No admitted outcome among those looked at; there were more than the bound, or a branch inside the band has no
    /// outcome at the program itself and none was found at its neighbours.
    ForkLimit(Box<Divergence>),
    /// No answer.
    Fault(DeviceFault),
}

/// The ids of all verdicts.
pub const VERDICTS: [&str; 10] = [
    "exact",
    "admissible",
    "admissible-without-witness",
    "inadmissible",
    "fork-limit",
    "crash",
    "timeout",
    "no-answer",
    "garbled",
    "unsupported",
];

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
    let beta = budget.beta(blocks);
    let search =
        Search { parameters, blocks, answer, beta, tolerance: Tolerance::new(budget.delta, beta), ties: Ties::All };
    let Some(divergence) = search.divergence(exact) else { return Verdict::Exact };
    if let Some(witness) = search.for_points(exact) {
        return Verdict::Admissible(witness);
    }
    let receive = |run: &Run| match search.divergence(run) {
        None => Reception::Accepted,
        Some(divergence) => Reception::Refused(divergence.parting),
    };
    match fork::find(parameters, blocks, beta, receive) {
        Ok(flips) => match search.for_flips(&flips) {
            Some(witness) => Verdict::Admissible(witness),
            None => Verdict::AdmissibleWithoutWitness(flips),
        },
        Err(exhausted)
            if exhausted.dead_end
                && let Some(witness) = search.beside_the_program(&divergence) =>
        {
            Verdict::Admissible(witness)
        }
        Err(exhausted) if exhausted.limit_hit || exhausted.dead_end => Verdict::ForkLimit(Box::new(divergence)),
        Err(_) => Verdict::Inadmissible(Box::new(divergence)),
    }
}
