//! The table of dialects (`spec/DIALECTS.md`) against the vectors: what a source says of a control must show. Each value
//! that has a source (tag S) and that another built-in profile has differently is exercised by a vector's program which
//! the profile answers otherwise as soon as it has the other profile's value.

use std::collections::BTreeSet;

use radcomp::device::Answer;
use radcomp::vectors::{self, Vector};
use radcomp_model::run;
use radcomp_spec::profile::{BUILTIN, PARAMETERS, Profile};

/// What comes of a vector's program under a profile: its path and alarm, or the reader's refusal.
fn answer(vector: &Vector, profile: &Profile) -> Result<Answer, String> {
    let program = vector.read(profile)?.map_err(|refusal| refusal.to_string())?;
    let blocks: Vec<_> = program.blocks.into_iter().map(|each| each.block).collect();
    Ok(Answer::from(&run(&profile.parameters, &blocks)))
}

/// A value as a profile's file has it.
fn written(parameter: &str, value: &str) -> String {
    let number = parameter == "non-moving-allowed" && value.parse::<u8>().is_ok();
    if number { value.to_owned() } else { format!("{value:?}") }
}

/// The first vector whose program tells the profile from one with another value.
fn told_by<'v>(profile: &Profile, changed: &Profile, vectors: &'v [Vector]) -> Option<&'v Vector> {
    vectors.iter().find(|vector| answer(vector, profile) != answer(vector, changed))
}

#[test]
fn every_sourced_value_is_exercised_by_a_vector_that_another_profile_answers_differently() {
    let vectors: Vec<Vector> = vectors::all().iter().filter_map(|vector| vector.clone().ok()).collect();
    let profiles: Vec<Profile> = BUILTIN.iter().map(|(name, _)| Profile::builtin(name).expect("built in")).collect();
    let (mut exercised, mut silent, mut alike) = (0, BTreeSet::new(), 0);
    for profile in &profiles {
        for entry in profile.provenance.iter().filter(|entry| entry.source.contains("S:")) {
            let Some(parameter) = PARAMETERS.iter().find(|parameter| parameter.key == entry.parameter) else {
                continue;
            };
            let others: BTreeSet<&str> = profiles
                .iter()
                .filter_map(|other| other.provenance_of(entry.parameter))
                .map(|other| other.value.as_str())
                .filter(|value| *value != entry.value)
                .collect();
            if others.is_empty() {
                alike += 1;
                continue;
            }
            for value in others {
                let change = [(parameter.name(), written(parameter.name(), value))];
                let changed = Profile::changed(&profile.name, "changed", change).expect("a profile");
                match told_by(profile, &changed, &vectors) {
                    Some(_) => exercised += 1,
                    None => {
                        let _ = silent.insert(format!(
                            "{}: {} = {} or {value}",
                            profile.name,
                            parameter.name(),
                            entry.value
                        ));
                    }
                }
            }
        }
    }
    println!("{exercised} pairs of values are told apart; {alike} sourced values are the same in every profile");
    assert!(silent.is_empty(), "no vector tells apart:\n{}", silent.into_iter().collect::<Vec<_>>().join("\n"));
    assert!(exercised > 100, "{exercised}");
}
