//! The programs of a campaign by name, for devices that cannot be driven.

use radcomp_model::run;
use radcomp_spec::Block;
use radcomp_spec::profile::Profile;
use rug::Rational;

use super::campaign::{TRIPLE_ONE_IN, boundary_programs, vector_programs};
use super::tally::Tally;
use crate::boundary;
use crate::generate::{self, Reach};
use crate::judge::{Judged, Verdict};

/// Every program that a campaign with this seed and so many generated programs judges, each with its name: vectors,
/// boundary triples, generated programs. One seed gives the same programs on every machine.
pub fn programs(profile: &Profile, seed: u64, count: u64) -> impl Iterator<Item = (String, Vec<Block<Rational>>)> {
    let reach = Reach::of(profile);
    let boundaries = boundary::all(seed, count / TRIPLE_ONE_IN, reach).flat_map(boundary_programs);
    let generated = (0..count).map(move |number| (format!("#{number}"), generate::program(seed, number, reach)));
    // Several examples of one clause may share a name, and triples of one family do.
    let named = vector_programs(profile).into_iter().chain(boundaries).enumerate();
    named.map(|(index, (name, blocks))| (format!("{index}: {name}"), blocks)).chain(generated)
}

/// How many vectors and programs on a decision's boundary a campaign judges beside the generated ones.
pub fn named_programs(profile: &Profile, seed: u64, count: u64) -> u64 {
    let triples = boundary::all(seed, count / TRIPLE_ONE_IN, Reach::of(profile));
    vector_programs(profile).len() as u64 + triples.map(|triple| triple.programs.len() as u64).sum::<u64>()
}

/// What a campaign with this seed and so many generated programs counts whatever the device: the model's part of a tally,
/// every program counted as exact.
pub fn recount(profile: &Profile, seed: u64, count: u64) -> Tally {
    let mut tally = Tally::default();
    for (_, blocks) in programs(profile, seed, count) {
        let exact = run(&profile.parameters, &blocks);
        tally.add(&blocks, &Judged { verdict: Verdict::Exact, exact, answer: None }, 1.0);
    }
    tally
}
