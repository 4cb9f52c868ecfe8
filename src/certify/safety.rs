//! What a failed answer does to the part, whatever the rules say.

use std::fmt;

use radcomp_model::Run;
use radcomp_spec::{Block, Step};
use rug::Rational;

use crate::device::Answer;
use crate::judge::Budget;
use crate::safety::{Contour, Finding, SafetyVerdict, check};

/// The safety verdicts on the device's path and on the exact one.
#[derive(Clone, Debug)]
pub struct Safety {
    /// Of the device's path.
    pub device: SafetyVerdict,
    /// Of the exact path: some programs gouge by the rules.
    pub exact: SafetyVerdict,
}

impl Safety {
    /// Judges both paths, to within the budget's δ, as far as both programs run: up to the first alarm.
    pub fn of(blocks: &[Block<Rational>], exact: &Run, answer: &Answer, budget: &Budget) -> Safety {
        let stop = [exact.alarm, answer.alarm].into_iter().flatten().map(|alarm| alarm.block).min();
        let whole = Contour::of(blocks);
        let contour = match stop {
            Some(block) => whole.before(block),
            None => whole,
        };
        let before = |block: usize| stop.is_none_or(|stop| block < stop);
        let judged = |steps: Vec<Step<f64>>| {
            let steps: Vec<_> = steps.into_iter().filter(|step| before(step.block)).collect();
            check(&contour, &steps, budget.delta)
        };
        Safety { device: judged(answer.steps.clone()), exact: judged(Answer::from(exact).steps) }
    }
}

impl fmt::Display for Safety {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.device.path {
            Finding::Safe { .. } => match self.device.uncut {
                Some(uncut) if self.exact.uncut.is_none() => {
                    write!(f, "different but safe; leaves {:.6} mm of N{} uncut", uncut.length, uncut.contour_block + 1)
                }
                _ => f.write_str("different but safe"),
            },
            Finding::Gouges(gouge) => {
                write!(f, "gouges by {:.6} mm at N{}", gouge.depth.0, gouge.contour_block + 1)?;
                match &self.exact.path {
                    Finding::Gouges(by_rule) => write!(f, "; the exact path by {:.6} mm", by_rule.depth.0),
                    Finding::Safe { .. } => f.write_str("; the exact path does not"),
                    Finding::Undecided(_) | Finding::OutOfRange { .. } => Ok(()),
                }
            }
            Finding::Undecided(gouge) => {
                let (low, high) = gouge.depth;
                write!(f, "may gouge: between {low:.3e} and {high:.3e} mm deep at N{}", gouge.contour_block + 1)
            }
            Finding::OutOfRange { block } => write!(f, "no path to judge: a number out of range at N{}", block + 1),
        }
    }
}
