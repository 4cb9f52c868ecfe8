//! Verdicts.

use std::panic::{AssertUnwindSafe, catch_unwind};

use radcomp_model::{Run, run};
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::budget::Budget;
use super::compare::{self, Divergence};
use super::fork::{self, Flip};
use super::witness;
use crate::device::{Answer, Device, DeviceFault};

/// What the judge says of one answer.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The exact outcome, to within δ.
    Exact,
    /// The exact outcome of this input, each number of which lies within β of the program's: the witness.
    Witnessed(Vec<Block<Rational>>),
    /// An outcome that the band admits: these decisions went another way. No witness has been constructed.
    Admissible(Vec<Flip>),
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
        !matches!(self, Verdict::Exact | Verdict::Witnessed(_) | Verdict::Admissible(_))
    }

    /// The name used in reports.
    pub fn id(&self) -> &'static str {
        match self {
            Verdict::Exact => "exact",
            Verdict::Witnessed(_) => "admissible",
            Verdict::Admissible(_) => "admissible-without-witness",
            Verdict::Inadmissible(_) => "inadmissible",
            Verdict::ForkLimit(_) => "fork-limit",
            Verdict::Fault(DeviceFault::Crash(_)) => "crash",
        }
    }
}

/// A verdict and the exact outcome that it was measured against.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The verdict.
    pub verdict: Verdict,
    /// The exact outcome.
    pub exact: Run,
}

/// Judges a device's answer to one program.
pub fn judge(device: &mut dyn Device, parameters: &Parameters, blocks: &[Block<Rational>], budget: &Budget) -> Judged {
    let exact = run(parameters, blocks);
    let answer = match ask(device, parameters, blocks) {
        Ok(answer) => answer,
        Err(fault) => return Judged { verdict: Verdict::Fault(fault), exact },
    };
    let Some(divergence) = compare::divergence(&exact, &answer, budget.delta) else {
        return Judged { verdict: Verdict::Exact, exact };
    };
    let beta = budget.beta(blocks);
    if let Some(input) = witness::construct(parameters, blocks, &exact, &answer, beta, budget.delta) {
        return Judged { verdict: Verdict::Witnessed(input), exact };
    }
    let verdict =
        match fork::find(parameters, blocks, beta, |run| compare::divergence(run, &answer, budget.delta).is_none()) {
            Ok(flips) => Verdict::Admissible(flips),
            Err(exhausted) if exhausted.limit_hit => Verdict::ForkLimit(Box::new(divergence)),
            Err(_) => Verdict::Inadmissible(Box::new(divergence)),
        };
    Judged { verdict, exact }
}

/// The device's answer; a panic of a device in this process costs this one answer.
fn ask(device: &mut dyn Device, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
    catch_unwind(AssertUnwindSafe(|| device.answer(parameters, blocks))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(DeviceFault::Crash(text.unwrap_or_else(|| "panic".to_owned())))
    })
}
