//! The counts of a campaign.

use std::collections::BTreeMap;

use radcomp_spec::{DecisionKind, clause};
use serde::{Deserialize, Serialize};

use super::buckets::Buckets;
use super::reasons::Reasons;
use crate::certify::{ClauseTally, Tally};
use crate::judge::VERDICTS;

/// What a campaign has counted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TallyRecord {
    /// Programs judged.
    pub programs: u64,
    /// Blocks read by the model.
    pub blocks: u64,
    /// Junctions of two compensated elements.
    pub corners: u64,
    /// Programs by verdict.
    pub verdicts: BTreeMap<String, u64>,
    /// Counts by clause.
    pub clauses: BTreeMap<String, ClauseTallyRecord>,
    /// Programs that were checked against their images as well.
    pub moved: u64,
    /// Relations between a program and its images that the device broke.
    pub broken: u64,
    /// Decisions by kind: negative, zero, positive margins.
    pub decisions: BTreeMap<String, [u64; 3]>,
    /// Programs that take a decision of this kind on this side: negative, zero, positive margins.
    pub sides: BTreeMap<String, [Buckets; 3]>,
    /// What the device does not support, in its words, by programs; left out if there is nothing.
    #[serde(default, skip_serializing_if = "Reasons::is_empty")]
    pub unsupported: Reasons,
}

/// Counts for one clause.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClauseTallyRecord {
    /// Programs whose exact outcome uses the clause.
    pub programs: u64,
    /// Path elements that it made.
    pub elements: u64,
    /// Alarms that it raised.
    pub alarms: u64,
    /// Decisions taken by its sentence.
    pub decisions: u64,
    /// Programs judged exact or admissible.
    pub passed: u64,
    /// Programs whose first divergence lies at this clause.
    pub failed: u64,
    /// Programs whose first divergence lies at this clause, waived.
    pub expected_failures: u64,
    /// Programs that the device does not support.
    pub unsupported: u64,
}

impl From<&Tally> for TallyRecord {
    fn from(tally: &Tally) -> Self {
        TallyRecord {
            programs: tally.programs,
            blocks: tally.blocks,
            corners: tally.corners,
            verdicts: tally.verdicts.iter().map(|(id, count)| ((*id).to_owned(), *count)).collect(),
            clauses: tally
                .clauses
                .iter()
                .map(|(id, part)| {
                    let record = ClauseTallyRecord {
                        programs: part.programs,
                        elements: part.elements,
                        alarms: part.alarms,
                        decisions: part.decisions,
                        passed: part.passed,
                        failed: part.failed,
                        expected_failures: part.expected_failures,
                        unsupported: part.unsupported,
                    };
                    ((*id).to_owned(), record)
                })
                .collect(),
            moved: tally.moved,
            broken: tally.broken,
            decisions: tally.decisions.iter().map(|(id, counts)| ((*id).to_owned(), *counts)).collect(),
            sides: tally.sides.iter().map(|(id, counts)| ((*id).to_owned(), *counts)).collect(),
            unsupported: tally.reasons.clone(),
        }
    }
}

impl TallyRecord {
    /// The tally that this is the record of; none if it names a clause, a decision or a verdict that there is not.
    pub fn tally(&self, counts: Buckets, greatest_share: f64) -> Option<Tally> {
        let clause = |(id, part): (&String, &ClauseTallyRecord)| {
            let part = ClauseTally {
                programs: part.programs,
                elements: part.elements,
                alarms: part.alarms,
                decisions: part.decisions,
                passed: part.passed,
                failed: part.failed,
                expected_failures: part.expected_failures,
                unsupported: part.unsupported,
            };
            Some((clause::ALL.iter().map(|(clause, _)| clause.id()).find(|known| known == id)?, part))
        };
        let kind = |id: &String| DecisionKind::ALL.iter().map(|kind| kind.id()).find(|known| known == id);
        let verdict = |id: &String| VERDICTS.into_iter().find(|known| known == id);
        let decisions = self.decisions.iter().map(|(id, counts)| Some((kind(id)?, *counts)));
        let sides = self.sides.iter().map(|(id, counts)| Some((kind(id)?, *counts)));
        Some(Tally {
            programs: self.programs,
            counts,
            blocks: self.blocks,
            corners: self.corners,
            verdicts: self.verdicts.iter().map(|(id, count)| Some((verdict(id)?, *count))).collect::<Option<_>>()?,
            clauses: self.clauses.iter().map(clause).collect::<Option<_>>()?,
            moved: self.moved,
            broken: self.broken,
            decisions: decisions.collect::<Option<_>>()?,
            sides: sides.collect::<Option<_>>()?,
            reasons: self.unsupported.clone(),
            greatest_share,
        })
    }
}
