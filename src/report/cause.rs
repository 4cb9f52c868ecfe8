//! Failures for people: causes, and relations that the device broke.

use std::cmp::Ordering;

use radcomp_model::run;
use radcomp_spec::{Block, Clause, DecisionKind, Parameters};
use rug::Rational;
use serde::{Deserialize, Serialize};

use super::case::Case;
use super::number::Binary;
use super::word::Id;
use crate::explain::first_sentence;
use crate::metamorphic::Broken;

/// Failures that have their clause and their kind of difference in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cause {
    /// Clause and kind.
    pub cause: String,
    /// How many programs.
    pub programs: u64,
    /// The smallest failure, in words.
    pub smallest: String,
    /// The clause that makes the first element that differs, if one does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clause: Option<Id<Clause>>,
    /// The clause's first sentence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sentence: Option<String>,
    /// The decision of the smallest program, as far as the first element that differs, that comes nearest to going
    /// another way.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestRecord>,
    /// What its path does to the part, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub safety: Option<String>,
    /// Its program as G-code, if the profile can write it.
    pub program: Option<String>,
    /// The tool table of that program.
    pub tools: Option<String>,
    /// The smallest failure itself, if the device was asked again or the case is among those kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<Case>,
}

/// A decision and how near to its boundary it was.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NearestRecord {
    /// The block that was being read.
    pub block: usize,
    /// Which decision.
    pub decision: Id<DecisionKind>,
    /// Its margin, within one unit in the last place.
    pub margin_mm: Binary,
    /// The side that it was taken on.
    pub side: Id<Ordering>,
}

/// A relation between a program and its image that the device broke. For people, as causes are.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BrokenRecord {
    /// The program's name.
    pub name: String,
    /// The relation.
    pub relation: String,
    /// What differs, in words.
    pub difference: String,
}

impl Cause {
    /// Adds what a case tells: the clause, its sentence, the nearest decision.
    pub fn told_by(self, case: Case, parameters: &Parameters) -> Cause {
        let Some(divergence) = &case.divergence else { return Cause { case: Some(case), ..self } };
        let (clause, block) = (divergence.clause, divergence.block);
        let blocks: Vec<Block<Rational>> = case.program.iter().map(Block::from).collect();
        let sentence = Some(first_sentence(clause.0)).filter(|sentence| !sentence.is_empty());
        Cause { clause: Some(clause), sentence, nearest: nearest(parameters, &blocks, block), case: Some(case), ..self }
    }
}

/// The decision nearest to its boundary among those that are taken to make the element of a block: while it is read, and
/// while the next one is.
fn nearest(parameters: &Parameters, blocks: &[Block<Rational>], block: usize) -> Option<NearestRecord> {
    let run = run(parameters, blocks);
    let near = run.decisions.iter().filter(|(decision, _)| (block..=block + 1).contains(&decision.block));
    let shaping = near.filter(|(decision, _)| decision.kind.shapes_the_path());
    let records = shaping.map(|(decision, _)| NearestRecord {
        block: decision.block,
        decision: Id(decision.kind),
        margin_mm: Binary(decision.margin.to_f64()),
        side: Id(decision.exact),
    });
    records.min_by(|x, y| x.margin_mm.0.abs().total_cmp(&y.margin_mm.0.abs()))
}

impl BrokenRecord {
    /// The record of a relation that the generated program with this number breaks.
    pub fn new(number: u64, broken: &Broken) -> BrokenRecord {
        BrokenRecord {
            name: format!("#{number}"),
            relation: broken.relation.to_owned(),
            difference: broken.difference.clone(),
        }
    }
}
