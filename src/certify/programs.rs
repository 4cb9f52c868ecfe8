//! The programs of a campaign by name, for devices that cannot be driven.

use radcomp_model::run;
use radcomp_spec::Block;
use radcomp_spec::profile::Profile;
use rug::Rational;

use super::plan::Plan;
use super::tally::Tally;
use crate::judge::{Grade, Judged, Verdict};

/// Every program that a campaign with this seed and so many generated programs judges, in their order, each with its name:
/// vectors, then boundary triples among the generated programs. One seed gives the same programs on every machine.
pub fn programs(
    profile: &Profile,
    seed: u64,
    count: u64,
    grade: Grade,
) -> impl Iterator<Item = (String, Vec<Block<Rational>>)> {
    let plan = Plan::new(profile, seed, count, grade);
    let planned = (0..plan.units()).flat_map(move |unit| plan.unit(unit));
    // Several examples of one clause may share a name, and triples of one family do.
    let mut named = 0..;
    planned.map(move |planned| match planned.number {
        Some(_) => (planned.name, planned.blocks),
        None => (format!("{}: {}", named.next().unwrap_or(0), planned.name), planned.blocks),
    })
}

/// How many vectors and programs on a decision's boundary a campaign judges beside the generated ones.
pub fn named_programs(profile: &Profile, seed: u64, count: u64, grade: Grade) -> u64 {
    Plan::new(profile, seed, count, grade).named()
}

/// What a campaign with this seed and so many generated programs counts whatever the device: the model's part of a tally,
/// every program counted as exact.
pub fn recount(profile: &Profile, seed: u64, count: u64, grade: Grade) -> Tally {
    let mut tally = Tally::default();
    for (_, blocks) in programs(profile, seed, count, grade) {
        let exact = run(&profile.parameters, &blocks);
        tally.add(&blocks, &Judged { verdict: Verdict::Exact, exact, answer: None }, 1.0);
    }
    tally
}
