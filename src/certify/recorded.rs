//! Judging answers that were written down.

use std::collections::BTreeMap;

use radcomp_spec::Block;
use rug::Rational;

use super::campaign::{self, Campaign, Outcome};
use super::failure::Failure;
use crate::device::{Answer, DeviceFault};
use crate::judge::judge_answer;

/// A campaign over answers that come one by one. No program can be asked again, so none is moved or minimised.
#[derive(Debug)]
pub struct Recorded<'c> {
    campaign: &'c Campaign,
    outcome: Outcome,
    groups: BTreeMap<String, (u64, Failure)>,
}

impl<'c> Recorded<'c> {
    /// A campaign at its start.
    pub fn new(campaign: &'c Campaign) -> Self {
        Recorded { campaign, outcome: Outcome::default(), groups: BTreeMap::new() }
    }

    /// Judges the answer to the program of this name.
    pub fn judge(&mut self, name: &str, blocks: Vec<Block<Rational>>, answer: Result<Answer, DeviceFault>) {
        let Campaign { profile, budget, .. } = self.campaign;
        let judged = judge_answer(answer, &profile.parameters, &blocks, budget);
        let Outcome { tally, cases, expected, .. } = &mut self.outcome;
        let waiver = campaign::count(self.campaign, name, &blocks, &judged, tally, cases);
        if let Some(waiver) = waiver {
            *expected.entry(waiver).or_default() += 1;
        } else if judged.verdict.is_red() {
            let failure = Failure::new(name.to_owned(), judged.verdict, blocks);
            campaign::note(failure, &mut self.outcome, &mut self.groups);
        }
    }

    /// What came of it.
    pub fn outcome(mut self) -> Outcome {
        let mut groups: Vec<_> =
            self.groups.into_iter().map(|(name, (count, failure))| (name, count, failure)).collect();
        groups.sort_by(|x, y| y.1.cmp(&x.1).then_with(|| x.0.cmp(&y.0)));
        self.outcome.groups = groups;
        self.outcome
    }
}
