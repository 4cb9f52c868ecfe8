//! The programs of a campaign in their order, in units that can be judged apart.
//!
//! A campaign is a sequence: the vectors, then rounds of generated programs with a boundary triple of every decision in
//! each; in grade `binary64` also the programs just outside of the band beside it. A campaign of more rounds goes on where one of fewer ends, so that one that runs until its time is up judges the
//! programs that a campaign of a given number does.

use std::ops::Range;

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, DecisionKind};
use rug::Rational;
use serde::{Deserialize, Serialize};

use crate::boundary::{self, Triple};
use crate::generate::{self, Reach};
use crate::judge::Grade;
use crate::vectors;

/// Generated programs of a unit.
const SLICE: u64 = 50;
/// Units of a round.
const SLICES: u64 = 8;
/// Generated programs of a round; a round that is not complete has no boundary triples.
pub const ROUND: u64 = SLICE * SLICES;
/// Vectors of a unit.
const VECTORS: usize = 50;

/// The place of a program in its campaign: the unit, and its place there. Places are ordered as the programs are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Place(pub u64, pub u64);

/// A program of a unit.
#[derive(Clone, Debug)]
pub(super) struct Planned {
    /// A vector's name, a boundary's, or `#` and the number of a generated program.
    pub(super) name: String,
    /// The number of a generated program.
    pub(super) number: Option<u64>,
    pub(super) blocks: Vec<Block<Rational>>,
}

/// The programs of a campaign.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    vectors: Vec<(String, Vec<Block<Rational>>)>,
    reach: Reach,
    seed: u64,
    programs: u64,
    grade: Grade,
}

impl Plan {
    /// The plan of a campaign with this seed and so many generated programs.
    pub(super) fn new(profile: &Profile, seed: u64, programs: u64, grade: Grade) -> Plan {
        Plan { vectors: vector_programs(profile), reach: Reach::of(profile), seed, programs, grade }
    }

    /// How many units it has.
    pub(super) fn units(&self) -> u64 {
        self.vector_units() + self.programs.div_ceil(SLICE)
    }

    /// How many units it has that hold the vectors and so many generated programs, in whole rounds.
    pub(super) fn units_of_rounds(&self, programs: u64) -> u64 {
        self.vector_units() + programs.div_ceil(ROUND) * SLICES
    }

    /// The generated programs of the first so many units.
    pub(super) fn generated(&self, units: u64) -> u64 {
        (units.saturating_sub(self.vector_units()) * SLICE).min(self.programs)
    }

    /// How many vectors and boundary programs it has.
    pub(super) fn named(&self) -> u64 {
        let triples = (0..self.programs.div_ceil(SLICE)).flat_map(|slice| self.triples(slice));
        self.vectors.len() as u64 + triples.map(|triple| boundary_programs(triple).len() as u64).sum::<u64>()
    }

    /// The units of one round more.
    pub(super) const fn round() -> u64 {
        SLICES
    }

    /// The programs of a unit.
    pub(super) fn unit(&self, unit: u64) -> Vec<Planned> {
        let Some(slice) = unit.checked_sub(self.vector_units()) else {
            let vectors = self.vectors.chunks(VECTORS).nth(unit as usize).unwrap_or_default();
            let planned = |(name, blocks): &(String, Vec<_>)| Planned {
                name: name.clone(),
                number: None,
                blocks: blocks.clone(),
            };
            return vectors.iter().map(planned).collect();
        };
        let from = slice * SLICE;
        let numbers = from..from.saturating_add(SLICE).min(self.programs);
        let named = self.triples(slice).flat_map(boundary_programs);
        let named = named.map(|(name, blocks)| Planned { name, number: None, blocks });
        named.chain(self.generated_programs(numbers)).collect()
    }

    /// The boundary triples of a slice: each slice of a round has some of the decisions.
    fn triples(&self, slice: u64) -> impl Iterator<Item = Triple> {
        let (round, part) = (slice / SLICES, slice % SLICES);
        let is_whole = (round + 1).saturating_mul(ROUND) <= self.programs;
        let kinds = DecisionKind::ALL.iter().zip(0..).filter(move |(_, index)| is_whole && index % SLICES == part);
        // Half a least increment is all of what lies beside it in grade `resolution`, and a control may not take as many
        // decimals.
        let drawn = if self.grade == Grade::Binary64 { boundary::with_beside } else { boundary::triples };
        kinds.filter_map(move |(kind, _)| drawn(*kind, self.seed, round, self.reach))
    }

    fn generated_programs(&self, numbers: Range<u64>) -> impl Iterator<Item = Planned> {
        numbers.map(|number| Planned {
            name: format!("#{number}"),
            number: Some(number),
            blocks: generate::program(self.seed, number, self.reach),
        })
    }

    fn vector_units(&self) -> u64 {
        self.vectors.len().div_ceil(VECTORS) as u64
    }
}

/// The vectors that were written for this profile without changing its parameters.
fn vector_programs(profile: &Profile) -> Vec<(String, Vec<Block<Rational>>)> {
    let mut named = Vec::new();
    for vector in vectors::all().iter().flatten() {
        let Ok(own) = vector.profile() else { continue };
        // A vector whose parameters are another profile's is none of this campaign's.
        if own.parameters != profile.parameters || own.machine != profile.machine {
            continue;
        }
        let Ok(Ok(program)) = vector.read(&own) else { continue };
        named.push((vector.name.clone(), program.blocks.into_iter().map(|read| read.block).collect()));
    }
    named
}

/// The programs of a triple, with their names.
fn boundary_programs(triple: Triple) -> Vec<(String, Vec<Block<Rational>>)> {
    let name = |place| format!("boundary {} {place} ({})", triple.kind.id(), triple.family);
    let names = Triple::NAMES.iter().chain(&Triple::BESIDE).map(name);
    names.zip(triple.programs.into_iter().chain(triple.beside.into_iter().flatten())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names of a campaign's programs, in their order.
    fn names(programs: u64) -> Vec<String> {
        let plan = Plan::new(&Profile::builtin("seed-mill").unwrap(), 3, programs, Grade::Binary64);
        (0..plan.units()).flat_map(|unit| plan.unit(unit)).map(|planned| planned.name).collect()
    }

    #[test]
    fn a_longer_campaign_goes_on_where_a_shorter_one_ends() {
        let (short, long) = (names(2 * ROUND), names(3 * ROUND));
        assert_eq!(short, long[..short.len()]);
        assert!(long.len() > short.len() + ROUND as usize);
    }

    #[test]
    fn every_program_has_one_place() {
        let names = names(ROUND + 130);
        for number in 0..ROUND + 130 {
            assert_eq!(names.iter().filter(|name| **name == format!("#{number}")).count(), 1, "{number}");
        }
        let of_a_triple = names.iter().filter(|name| name.starts_with("boundary turn ")).count();
        assert_eq!(of_a_triple, 5);
    }
}
