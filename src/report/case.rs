//! Programs whose answer was not exact.

use std::cmp::Ordering;

use radcomp_spec::{Block, Clause, DecisionKind};
use rug::Rational;
use serde::{Deserialize, Serialize};

use super::answer::{AlarmRecord, AnswerRecord};
use super::block::BlockRecord;
use super::number::Binary;
use super::word::Id;
use crate::certify::Place;
use crate::judge::{Budget, Difference, Divergence, Flip, Judged, Verdict};

/// The most cases of failed programs in one report.
pub const MOST_RED_CASES: usize = 200;
/// The most cases of admissible answers in one report.
pub const MOST_CASES: usize = 1000;

/// One program, what the device answered, and what the judge says of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The program's name: a vector's, or `#` and the number of a generated program.
    pub name: String,
    /// The verdict's id.
    pub verdict: String,
    /// The band that the program was judged with.
    pub beta_mm: Binary,
    /// How far a point may lie from where its branch puts it.
    pub delta_mm: Binary,
    /// The program.
    pub program: Vec<BlockRecord>,
    /// The input whose exact outcome is the answer; verdict `admissible`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<Vec<BlockRecord>>,
    /// The largest change of one number that makes the program the witness.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub change_mm: Option<Binary>,
    /// The decisions that the device took another way; empty if only points moved.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub flips: Vec<FlipRecord>,
    /// What the device answered, if it did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub answer: Option<AnswerRecord>,
    /// Why the device gave no answer.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fault: Option<String>,
    /// Where the answer first differs from the exact outcome; red verdicts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub divergence: Option<DivergenceRecord>,
    /// The waiver that makes it an expected failure: its place in the list of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub waiver: Option<usize>,
}

/// A decision that the device took another way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlipRecord {
    /// The block that was being read.
    pub block: usize,
    /// Which decision.
    pub decision: Id<DecisionKind>,
    /// Its margin, within one unit in the last place.
    pub margin_mm: Binary,
    /// The exact answer.
    pub exact: Id<Ordering>,
    /// The branch that was taken.
    pub taken: Id<Ordering>,
}

/// Where an answer first differs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DivergenceRecord {
    /// The block.
    pub block: usize,
    /// The clause that makes the expected element.
    pub clause: Id<Clause>,
    /// What differs: `not-finite`, `missing`, `surplus`, `kind`, `block`, `end`, `centre`, `place` or `alarm`.
    pub difference: String,
    /// By how much, if it is a distance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub off_mm: Option<Binary>,
    /// Where the expected element ends, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected_end: Option<[Binary; 2]>,
    /// Where the device's element ends, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub observed_end: Option<[Binary; 2]>,
    /// The alarm of the exact outcome, if the alarms differ and it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected_alarm: Option<AlarmRecord>,
    /// The device's alarm, if the alarms differ and it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub observed_alarm: Option<AlarmRecord>,
}

/// The case of a judged program; none if the answer is exact. `beta` is the band that `budget` gives the program.
pub fn case(name: &str, blocks: &[Block<Rational>], judged: &Judged, budget: &Budget, beta: f64) -> Option<Case> {
    let records = |blocks: &[Block<Rational>]| blocks.iter().map(BlockRecord::from).collect::<Vec<_>>();
    let mut case = Case {
        name: name.to_owned(),
        verdict: judged.verdict.id().to_owned(),
        beta_mm: Binary(beta),
        delta_mm: Binary(budget.delta),
        program: Vec::new(),
        witness: None,
        change_mm: None,
        flips: Vec::new(),
        answer: None,
        fault: None,
        divergence: None,
        waiver: None,
    };
    match &judged.verdict {
        Verdict::Exact => return None,
        Verdict::Admissible(witness) => {
            case.witness = Some(records(&witness.input));
            case.change_mm = Some(Binary(witness.beta));
            case.flips = witness.flips.iter().map(FlipRecord::from).collect();
        }
        Verdict::AdmissibleWithoutWitness(flips) => case.flips = flips.iter().map(FlipRecord::from).collect(),
        Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => {
            case.divergence = Some(DivergenceRecord::from(&**divergence));
        }
        Verdict::Fault(fault) => case.fault = Some(fault.text().to_owned()),
    }
    case.program = records(blocks);
    case.answer = judged.answer.as_ref().map(AnswerRecord::from);
    Some(case)
}

/// The cases of a campaign: the first [`MOST_RED_CASES`] failed ones and the first [`MOST_CASES`] others, each with the
/// place of its program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cases {
    kept: Vec<(Place, Case)>,
    left_out: u64,
}

impl Cases {
    /// Adds a case that comes after the others.
    pub fn add(&mut self, case: Case) {
        let Place(unit, index) = self.kept.last().map_or(Place::default(), |(place, _)| *place);
        self.add_at(Place(unit, index + 1), case);
    }

    /// Adds the case of the program at a place after those of the others, or counts it if there are enough of its kind.
    pub fn add_at(&mut self, place: Place, case: Case) {
        let of_its_kind = self.kept.iter().filter(|(_, kept)| is_red(kept) == is_red(&case)).count();
        if of_its_kind < most(&case) {
            self.kept.push((place, case));
        } else {
            self.left_out += 1;
        }
    }

    /// Adds the cases of another part.
    pub fn merge(&mut self, other: Cases) {
        self.left_out += other.left_out;
        self.kept.extend(other.kept);
        self.kept.sort_by_key(|(place, _)| *place);
        let (mut red, mut others, before) = (0, 0, self.kept.len());
        self.kept.retain(|(_, case)| {
            let count = if is_red(case) { &mut red } else { &mut others };
            *count += 1;
            *count <= most(case)
        });
        self.left_out += (before - self.kept.len()) as u64;
    }

    /// The cases kept, and how many were not.
    pub fn into_parts(self) -> (Vec<Case>, u64) {
        (self.kept.into_iter().map(|(_, case)| case).collect(), self.left_out)
    }
}

impl Extend<Case> for Cases {
    fn extend<I: IntoIterator<Item = Case>>(&mut self, cases: I) {
        cases.into_iter().for_each(|case| self.add(case));
    }
}

fn is_red(case: &Case) -> bool {
    !case.verdict.starts_with("admissible")
}

fn most(case: &Case) -> usize {
    if is_red(case) { MOST_RED_CASES } else { MOST_CASES }
}

impl From<&Flip> for FlipRecord {
    fn from(flip: &Flip) -> Self {
        FlipRecord {
            block: flip.block,
            decision: Id(flip.kind),
            margin_mm: Binary(flip.margin),
            exact: Id(flip.exact),
            taken: Id(flip.taken),
        }
    }
}

impl From<&Divergence> for DivergenceRecord {
    fn from(divergence: &Divergence) -> Self {
        let (id, off) = match divergence.difference {
            Difference::NotFinite => ("not-finite", None),
            Difference::Missing => ("missing", None),
            Difference::Surplus => ("surplus", None),
            Difference::Kind => ("kind", None),
            Difference::Block => ("block", None),
            Difference::End(off) => ("end", Some(off)),
            Difference::Centre(off) => ("centre", Some(off)),
            Difference::Place(off) => ("place", Some(off)),
            Difference::Alarm(..) => ("alarm", None),
        };
        let (expected_alarm, observed_alarm) = match divergence.difference {
            Difference::Alarm(expected, observed) => (expected, observed),
            _ => (None, None),
        };
        DivergenceRecord {
            block: divergence.block,
            clause: Id(divergence.clause),
            difference: id.to_owned(),
            off_mm: off.map(Binary),
            expected_end: divergence.expected.map(|stroke| stroke.to.map(Binary)),
            observed_end: divergence.observed.map(|stroke| stroke.to.map(Binary)),
            expected_alarm: expected_alarm.map(AlarmRecord::from),
            observed_alarm: observed_alarm.map(AlarmRecord::from),
        }
    }
}
