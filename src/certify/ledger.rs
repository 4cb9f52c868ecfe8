//! What the programs judged so far gave, before causes are made small. Ledgers of parts add up to that of the whole, in any
//! order.

use std::collections::BTreeMap;

use radcomp_spec::Block;
use rug::Rational;

use super::campaign::Campaign;
use super::failure::{Failure, Told};
use super::plan::Place;
use super::tally::Tally;
use crate::judge::Judged;
use crate::report::{self, BrokenRecord, Cases};

/// How many failed programs are kept.
pub(super) const MOST_FAILURES: usize = 200;

/// The counts of a part of a campaign, and as much of its failures as is kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Ledger {
    pub(super) tally: Tally,
    /// Failed programs in their order.
    pub(super) failures: Vec<Told>,
    /// Relations that the device broke, by the number of the generated program.
    pub(super) broken: Vec<(u64, BrokenRecord)>,
    pub(super) cases: Cases,
    /// Programs that a waiver covers, by its place.
    pub(super) expected: BTreeMap<usize, u64>,
    /// Failures of one cause, by its name.
    pub(super) groups: BTreeMap<String, Group>,
}

/// Failures of one cause.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Group {
    pub(super) programs: u64,
    /// The one with the fewest blocks; of those, the first.
    pub(super) shortest: Failure,
    /// A smaller program made of it, if that was looked for.
    pub(super) smaller: Option<Failure>,
}

impl Ledger {
    /// Counts a judged program and keeps what is to be kept of it.
    pub(super) fn note(
        &mut self,
        campaign: &Campaign,
        place: Place,
        name: &str,
        blocks: &[Block<Rational>],
        judged: &Judged,
    ) {
        let beta = campaign.budget.beta(blocks);
        let waiver = campaign.waivers.covering(name, judged);
        self.tally.add_waived(blocks, judged, beta, waiver.is_some());
        let Some(case) = report::case(name, blocks, judged, &campaign.budget, beta) else { return };
        if let Some(waiver) = waiver {
            *self.expected.entry(waiver).or_default() += 1;
        } else if judged.verdict.is_red() {
            self.note_failure(Failure::new(place, &judged.verdict, blocks.to_vec(), case.clone()));
        }
        self.cases.add_at(place, report::Case { waiver, ..case });
    }

    fn note_failure(&mut self, failure: Failure) {
        if self.failures.len() < MOST_FAILURES {
            self.failures.push(failure.told());
        }
        self.add_group(failure.group.clone(), Group { programs: 1, shortest: failure, smaller: None });
    }

    fn add_group(&mut self, name: String, group: Group) {
        let Some(whole) = self.groups.get_mut(&name) else {
            self.groups.insert(name, group);
            return;
        };
        whole.programs += group.programs;
        if group.shortest.rank() < whole.shortest.rank() {
            (whole.shortest, whole.smaller) = (group.shortest, group.smaller);
        }
    }

    /// Adds the ledger of another part.
    pub(super) fn merge(&mut self, other: Ledger) {
        self.tally.merge(other.tally);
        self.cases.merge(other.cases);
        for (waiver, programs) in other.expected {
            *self.expected.entry(waiver).or_default() += programs;
        }
        self.failures.extend(other.failures);
        self.failures.sort_by_key(|told| told.place);
        self.failures.truncate(MOST_FAILURES);
        self.broken.extend(other.broken);
        self.broken.sort_by_key(|(number, _)| *number);
        self.broken.truncate(MOST_FAILURES);
        other.groups.into_iter().for_each(|(name, group)| self.add_group(name, group));
    }
}
