//! Boundary synthesis: the triples lie where they say, and the builtin device answers them admissibly.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use radcomp::boundary::{self, Triple};
use radcomp::device::Builtin;
use radcomp::gcode::print_blocks;
use radcomp::generate::Reach;
use radcomp::judge::{Budget, Grade, judge};
use radcomp_model::{Decision, Run, run};
use radcomp_spec::DecisionKind;
use radcomp_spec::profile::{BUILTIN, Profile};

const SEED: u64 = 1;
const PER_KIND: u64 = match option_env!("BOUNDARY") {
    Some(_) => 2000,
    None => 100,
};
const BUDGET: Budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };

fn mill() -> Profile {
    Profile::builtin("seed-mill").expect("built in")
}

/// The decisions of a kind, each with its block and its place among those of that block.
fn decisions(run: &Run, kind: DecisionKind) -> Vec<((usize, usize), &Decision)> {
    let mut seen = BTreeMap::new();
    let of_kind = run.decisions.iter().map(|(decision, _)| decision).filter(|decision| decision.kind == kind);
    of_kind
        .map(|decision| {
            let place: &mut usize = seen.entry(decision.block).or_default();
            *place += 1;
            ((decision.block, *place), decision)
        })
        .collect()
}

/// Why a triple does not lie as it says; nothing if it does.
fn misplaced(triple: &Triple, profile: &Profile) -> Option<String> {
    let runs = triple.programs.each_ref().map(|blocks| run(&profile.parameters, blocks));
    let [below, on, above] = runs.each_ref().map(|run| decisions(run, triple.kind));
    let zeros = on.iter().filter(|(_, decision)| decision.margin.is_zero()).map(|(place, _)| *place);
    let mut seen = Vec::new();
    for place in zeros {
        let sign = |decisions: &[((usize, usize), &Decision)]| {
            decisions.iter().find(|(other, _)| *other == place).map(|(_, decision)| decision.margin.sign())
        };
        let signs = (sign(&below), sign(&above));
        let wanted = if triple.two_sided { Ordering::Less } else { Ordering::Greater };
        if signs == (Some(wanted), Some(Ordering::Greater)) {
            return None;
        }
        seen.push(signs);
    }
    Some(format!("{} ({}): {seen:?}", triple.kind.id(), triple.family))
}

#[test]
fn every_triple_lies_on_its_decision() {
    let profile = &Profile::builtin(std::env::var("PROF").as_deref().unwrap_or("seed-mill")).unwrap();
    let mut families: BTreeMap<(&str, &str), u64> = BTreeMap::new();
    let mut wrong: BTreeMap<String, (u64, String)> = BTreeMap::new();
    for kind in DecisionKind::ALL {
        let mut count = 0;
        for number in 0..PER_KIND {
            let Some(triple) = boundary::triples(*kind, SEED, number, Reach::of(profile)) else { continue };
            count += 1;
            *families.entry((kind.id(), triple.family)).or_default() += 1;
            let listing = print_blocks(&triple.programs[1], profile).map(|listing| listing.program);
            if let Some(why) = misplaced(&triple, profile) {
                wrong.entry(why).or_insert_with(|| (0, format!("{number}\n{}", listing.unwrap_or_default()))).0 += 1;
            }
        }
        assert!(count >= PER_KIND, "{count} triples for {}", kind.id());
    }
    for ((kind, family), count) in &families {
        println!("{kind}: {family}: {count}");
    }
    let list: Vec<_> = wrong.iter().map(|(why, (count, first))| format!("{count} {why} first #{first}")).collect();
    assert!(wrong.is_empty(), "{}", list.join("\n"));
}

#[test]
fn the_builtin_device_answers_every_triple_admissibly() {
    let mut verdicts: BTreeMap<&str, u64> = BTreeMap::new();
    let mut red = Vec::new();
    for (name, _) in BUILTIN {
        let profile = Profile::builtin(name).expect("built in");
        for triple in boundary::all(SEED, PER_KIND, Reach::of(&profile)) {
            for (place, blocks) in Triple::NAMES.iter().zip(&triple.programs) {
                let verdict = judge(&mut Builtin, &profile.parameters, blocks, &BUDGET).verdict;
                *verdicts.entry(verdict.id()).or_default() += 1;
                if verdict.is_red() {
                    let listing = print_blocks(blocks, &profile).map(|listing| listing.program);
                    red.push(format!(
                        "{name} {} {place} ({}): {verdict:?}\n{listing:?}",
                        triple.kind.id(),
                        triple.family
                    ));
                }
            }
        }
    }
    println!("{verdicts:?}");
    assert!(red.is_empty(), "{} red\n{}", red.len(), red[..red.len().min(20)].join("\n"));
}
