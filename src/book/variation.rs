//! The same program under the choices of other controls.

use radcomp_model::Run;
use radcomp_spec::profile::{BUILTIN, Profile};
use serde::Serialize;

use super::exhibit::{drawn, outcome};
use crate::gcode::Program;
use crate::vectors::Vector;

/// Controls under which a program takes one other path.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Variation {
    /// Their profiles.
    pub(super) profiles: Vec<String>,
    /// The values of the clause's parameters there: name, and its values with commas between.
    pub(super) values: Vec<[String; 2]>,
    /// The figure.
    figure: String,
    /// The alarm that ends it: line and id.
    alarm: Option<[String; 2]>,
}

/// What the program does under the compensation of each built-in profile that gives one of these parameters another
/// value, and the profiles whose path is the same all the same.
///
/// How the program is read stays the example's own: only what the compensation asks of the profile is another's.
pub(super) fn variations(
    vector: &Vector,
    own: &Profile,
    program: &Program,
    exact: &Run,
    parameters: &[&str],
) -> (Vec<Variation>, Vec<String>) {
    let mut groups: Vec<(Run, Variation)> = Vec::new();
    let mut same = Vec::new();
    for (name, _) in BUILTIN {
        let Some(other) = Profile::builtin(name) else { continue };
        if parameters.iter().all(|parameter| value(&other, parameter) == value(own, parameter)) {
            continue;
        }
        let mixed = Profile { parameters: other.parameters, ..own.clone() };
        let run = outcome(program, &mixed);
        if is_same(&run, exact) {
            same.push((*name).to_owned());
        } else if let Some((_, group)) = groups.iter_mut().find(|(known, _)| is_same(known, &run)) {
            group.profiles.push((*name).to_owned());
            for ([_, known], [_, value]) in group.values.iter_mut().zip(values(&other, parameters)) {
                if !known.split(", ").any(|known| known == value) {
                    *known = format!("{known}, {value}");
                }
            }
        } else {
            let line = |block: usize| program.blocks.get(block).map_or(0, |read| read.line).to_string();
            let label = format!("the same program under the compensation of {name}");
            let variation = Variation {
                profiles: vec![(*name).to_owned()],
                values: values(&other, parameters),
                figure: drawn(program, &mixed, vector, &label),
                alarm: run.alarm.map(|alarm| [line(alarm.block), alarm.kind.id().to_owned()]),
            };
            groups.push((run, variation));
        }
    }
    (groups.into_iter().map(|(_, variation)| variation).collect(), same)
}

/// The same path, step by step and block by block, and the same alarm; the clauses may differ.
fn is_same(one: &Run, other: &Run) -> bool {
    one.alarm == other.alarm
        && one.steps.len() == other.steps.len()
        && one.steps.iter().zip(&other.steps).all(|(a, b)| a.block == b.block && a.segment == b.segment)
}

fn values(profile: &Profile, parameters: &[&str]) -> Vec<[String; 2]> {
    parameters.iter().map(|name| [(*name).to_owned(), value(profile, name).to_owned()]).collect()
}

/// The value of a parameter of the compensation.
fn value<'p>(profile: &'p Profile, name: &str) -> &'p str {
    profile.provenance_of(&format!("compensation.{name}")).map_or("", |entry| &entry.value)
}
