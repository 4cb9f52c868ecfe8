//! Judging answers that were written down.

use radcomp_spec::Block;
use rug::Rational;

use super::campaign::{Campaign, Outcome};
use super::ledger::Ledger;
use super::plan::Place;
use super::smallest;
use crate::device::{Answer, DeviceFault};
use crate::judge::judge_answer;

/// A campaign over answers that come one by one. No program can be asked again, so none is moved or minimised.
#[derive(Debug)]
pub struct Recorded<'c> {
    campaign: &'c Campaign,
    ledger: Ledger,
    judged: u64,
}

impl<'c> Recorded<'c> {
    /// A campaign at its start.
    pub fn new(campaign: &'c Campaign) -> Self {
        Recorded { campaign, ledger: Ledger::default(), judged: 0 }
    }

    /// Judges the answer to the program of this name.
    pub fn judge(&mut self, name: &str, blocks: &[Block<Rational>], answer: Result<Answer, DeviceFault>) {
        let Campaign { profile, budget, .. } = self.campaign;
        let judged = judge_answer(answer, &profile.parameters, blocks, budget);
        self.ledger.note(self.campaign, Place(0, self.judged), name, blocks, &judged);
        self.judged += 1;
    }

    /// What came of it.
    pub fn outcome(self) -> Outcome {
        smallest::told(self.ledger, self.campaign.programs, self.campaign)
    }
}
