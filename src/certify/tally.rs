//! Counts of a campaign.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

use radcomp_model::Run;
use radcomp_spec::clause::{self, Clause};
use radcomp_spec::{Block, DecisionKind};
use rug::Rational;
use serde::Serialize;

use crate::device::DeviceFault;
use crate::judge::{Judged, Verdict};
use crate::report::{Bucket, Buckets, Reasons};

/// What a campaign has counted. Tallies of parts add up to the tally of the whole, in any order.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Tally {
    /// Programs judged.
    pub programs: u64,
    /// Programs by what came of them.
    pub counts: Buckets,
    /// Blocks read by the model.
    pub blocks: u64,
    /// Junctions of two compensated elements.
    pub corners: u64,
    /// Programs by verdict.
    pub verdicts: BTreeMap<&'static str, u64>,
    /// Counts by clause.
    pub clauses: BTreeMap<&'static str, ClauseTally>,
    /// Programs that were checked against their images as well.
    pub moved: u64,
    /// Relations between a program and its images that the device broke.
    pub broken: u64,
    /// Decisions by kind: negative, zero, positive margins.
    pub decisions: BTreeMap<&'static str, [u64; 3]>,
    /// Programs that take a decision of this kind on this side: negative, zero, positive margins.
    pub sides: BTreeMap<&'static str, [Buckets; 3]>,
    /// What the device does not support, in its words.
    pub reasons: Reasons,
    /// The greatest share of a program's band β that a witness took.
    pub greatest_share: f64,
}

/// Counts for one clause.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ClauseTally {
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

impl Tally {
    /// Counts one judged program.
    pub fn add(&mut self, blocks: &[Block<Rational>], judged: &Judged, beta: f64) {
        self.add_waived(blocks, judged, beta, false);
    }

    /// Counts one judged program, which, if it is red, may be waived.
    pub fn add_waived(&mut self, blocks: &[Block<Rational>], judged: &Judged, beta: f64, waived: bool) {
        let bucket = match (judged.verdict.is_green(), judged.verdict.is_red()) {
            (true, _) => Bucket::Pass,
            (false, true) if waived => Bucket::ExpectedFailure,
            (false, true) => Bucket::Fail,
            (false, false) => Bucket::Unsupported,
        };
        self.programs += 1;
        self.counts.count(bucket);
        self.blocks += blocks.len() as u64;
        *self.verdicts.entry(judged.verdict.id()).or_default() += 1;
        match &judged.verdict {
            Verdict::Admissible(witness) => self.greatest_share = self.greatest_share.max(witness.beta / beta),
            Verdict::Fault(DeviceFault::Unsupported(reason)) => self.reasons.add(reason),
            _ => {}
        }
        for clause in self.add_run(&judged.exact) {
            let tally = self.clauses.entry(clause.id()).or_default();
            tally.programs += 1;
            tally.passed += u64::from(bucket == Bucket::Pass);
            tally.unsupported += u64::from(bucket == Bucket::Unsupported);
        }
        if let Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) = &judged.verdict {
            let tally = self.clauses.entry(divergence.clause.id()).or_default();
            *if waived { &mut tally.expected_failures } else { &mut tally.failed } += 1;
        }
        let sides: BTreeSet<_> =
            judged.exact.decisions.iter().map(|(decision, _)| (decision.kind.id(), slot(decision.exact))).collect();
        for (kind, slot) in sides {
            self.sides.entry(kind).or_default()[slot].count(bucket);
        }
    }

    fn add_run(&mut self, run: &Run) -> BTreeSet<Clause> {
        let mut used = BTreeSet::new();
        for step in &run.steps {
            self.clauses.entry(step.clause.id()).or_default().elements += 1;
            self.corners += u64::from(step.main && is_junction(step.clause));
            used.insert(step.clause);
        }
        for (decision, _) in &run.decisions {
            self.clauses.entry(decision.clause().id()).or_default().decisions += 1;
            self.decisions.entry(decision.kind.id()).or_default()[slot(decision.exact)] += 1;
            used.insert(decision.clause());
        }
        if let Some(alarm) = run.alarm {
            self.clauses.entry(alarm.kind.clause().id()).or_default().alarms += 1;
            used.insert(alarm.kind.clause());
        }
        used
    }

    /// Adds the counts of another part.
    pub fn merge(&mut self, other: Tally) {
        self.programs += other.programs;
        self.counts.merge(other.counts);
        self.blocks += other.blocks;
        self.corners += other.corners;
        self.moved += other.moved;
        self.broken += other.broken;
        self.greatest_share = self.greatest_share.max(other.greatest_share);
        self.reasons.merge(other.reasons);
        for (verdict, count) in other.verdicts {
            *self.verdicts.entry(verdict).or_default() += count;
        }
        for (id, part) in other.clauses {
            let whole = self.clauses.entry(id).or_default();
            whole.programs += part.programs;
            whole.elements += part.elements;
            whole.alarms += part.alarms;
            whole.decisions += part.decisions;
            whole.passed += part.passed;
            whole.failed += part.failed;
            whole.expected_failures += part.expected_failures;
            whole.unsupported += part.unsupported;
        }
        for (kind, part) in other.sides {
            let whole = self.sides.entry(kind).or_default();
            (0..3).for_each(|slot| whole[slot].merge(part[slot]));
        }
        for (kind, part) in other.decisions {
            let whole = self.decisions.entry(kind).or_default();
            (0..3).for_each(|slot| whole[slot] += part[slot]);
        }
    }

    /// Programs that the device failed, those that are waived apart, and relations that it broke.
    pub fn red(&self) -> u64 {
        self.counts.fail + self.broken
    }

    /// The smallest share of the band β under which no verdict would be red: that of the farthest witness. The whole of it
    /// if some answer has no witness; none if a verdict is red as it is.
    pub fn needed_share(&self) -> Option<f64> {
        let bare = self.verdicts.get("admissible-without-witness").is_some_and(|count| *count > 0);
        (self.red() == 0).then_some(if bare { 1.0 } else { self.greatest_share })
    }

    /// Programs that the device says it does not support: neither failed nor passed.
    pub fn unsupported(&self) -> u64 {
        self.counts.unsupported
    }

    /// Kinds of decisions that were never taken on one of their sides, with the side.
    pub fn one_sided(&self) -> Vec<(DecisionKind, &'static str)> {
        let counts = |kind: &DecisionKind| self.decisions.get(kind.id()).copied().unwrap_or_default();
        let mut missing = Vec::new();
        for kind in DecisionKind::ALL {
            let [negative, zero, positive] = counts(kind);
            if negative + zero == 0 {
                missing.push((*kind, "not positive"));
            }
            if positive == 0 {
                missing.push((*kind, "positive"));
            }
        }
        missing
    }
}

/// The place of a side among the counts of a decision.
fn slot(side: Ordering) -> usize {
    match side {
        Ordering::Less => 0,
        Ordering::Equal => 1,
        Ordering::Greater => 2,
    }
}

/// Clauses that end an element at a junction with another one.
fn is_junction(clause: Clause) -> bool {
    [
        clause::TRC_CORNER_02,
        clause::TRC_CORNER_03,
        clause::TRC_CORNER_04,
        clause::TRC_CORNER_06,
        clause::TRC_CORNER_07,
        clause::TRC_CORNER_08,
        clause::TRC_CORNER_09,
        clause::TRC_CORNER_10,
        clause::TRC_SIDE_02,
        clause::TRC_SIDE_03,
    ]
    .contains(&clause)
}
