//! Ledgers as they are written: into checkpoints, and into the reports of shards.

use std::collections::BTreeMap;

use radcomp_spec::Block;
use serde::{Deserialize, Serialize};

use super::failure::{Failure, Told};
use super::ledger::{Group, Ledger};
use super::plan::Place;
use crate::report::{Binary, BrokenRecord, Buckets, Case, Cases, TallyRecord};

/// What the programs of a part of a campaign gave, with the places that put it in order with that of other parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LedgerRecord {
    pub(super) tally: TallyRecord,
    pub(super) counts: Buckets,
    greatest_share: Binary,
    failures: Vec<Told>,
    broken: Vec<(u64, BrokenRecord)>,
    cases: Cases,
    /// Programs that a waiver covers, by its place.
    expected: BTreeMap<usize, u64>,
    groups: BTreeMap<String, GroupRecord>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct GroupRecord {
    programs: u64,
    shortest: FailureRecord,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    smaller: Option<FailureRecord>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct FailureRecord {
    place: Place,
    group: String,
    told: String,
    case: Case,
}

impl From<&Ledger> for LedgerRecord {
    fn from(ledger: &Ledger) -> Self {
        let Ledger { tally, failures, broken, cases, expected, groups } = ledger;
        let group = |group: &Group| GroupRecord {
            programs: group.programs,
            shortest: FailureRecord::from(&group.shortest),
            smaller: group.smaller.as_ref().map(FailureRecord::from),
        };
        LedgerRecord {
            tally: TallyRecord::from(tally),
            counts: tally.counts,
            greatest_share: Binary(tally.greatest_share),
            failures: failures.clone(),
            broken: broken.clone(),
            cases: cases.clone(),
            expected: expected.clone(),
            groups: groups.iter().map(|(name, part)| (name.clone(), group(part))).collect(),
        }
    }
}

impl LedgerRecord {
    /// The ledger; none if it names a clause, a decision or a verdict that there is not.
    pub(super) fn ledger(self) -> Option<Ledger> {
        let group = |group: GroupRecord| Group {
            programs: group.programs,
            shortest: Failure::from(group.shortest),
            smaller: group.smaller.map(Failure::from),
        };
        Some(Ledger {
            tally: self.tally.tally(self.counts, self.greatest_share.0)?,
            failures: self.failures,
            broken: self.broken,
            cases: self.cases,
            expected: self.expected,
            groups: self.groups.into_iter().map(|(name, part)| (name, group(part))).collect(),
        })
    }
}

impl From<&Failure> for FailureRecord {
    fn from(failure: &Failure) -> Self {
        let Failure { place, group, told, case, blocks: _, safety: _ } = failure;
        FailureRecord { place: *place, group: group.clone(), told: told.clone(), case: Case::clone(case) }
    }
}

impl From<FailureRecord> for Failure {
    fn from(record: FailureRecord) -> Self {
        let FailureRecord { place, group, told, case } = record;
        let blocks = case.program.iter().map(Block::from).collect();
        Failure { place, group, told, blocks, safety: None, case: Box::new(case) }
    }
}
