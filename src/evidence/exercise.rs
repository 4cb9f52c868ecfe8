//! What the worked examples, the vectors and the boundary programs exercise of each clause, found by running them.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use radcomp_model::{Run, run};
use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Block, Clause, DecisionKind};
use rug::Rational;
use serde::Serialize;

use crate::boundary;
use crate::explain::Coordinate;
use crate::generate::Reach;
use crate::vectors;

/// What exercises a clause.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Exercise {
    /// Worked examples of the clause itself.
    pub examples: usize,
    /// Worked examples of other clauses whose exact outcome uses it.
    pub other_examples: usize,
    /// Vectors, by name, whose exact outcome uses it.
    pub vectors: Vec<String>,
    /// Its own examples or the vectors use it, or are refused by the program reader as it says.
    pub used: bool,
    /// Its decisions, with the closest margins.
    pub decisions: Vec<Closest>,
}

/// How near to a decision's boundary programs have come, in millimetres.
#[derive(Clone, Debug, Serialize)]
pub struct Closest {
    /// The decision.
    pub decision: &'static str,
    /// The negative margin next to zero.
    pub below: Option<Margin>,
    /// How many programs lie exactly on the boundary.
    pub exactly: u64,
    /// The positive margin next to zero.
    pub above: Option<Margin>,
}

/// A margin and where it was met.
#[derive(Clone, Debug, Serialize)]
pub struct Margin {
    /// The margin, rounded to a double.
    pub mm: f64,
    /// The margin in short decimals, for reading.
    pub shown: String,
    /// The example, vector or boundary program.
    pub program: String,
}

/// Boundary triples of each decision under each profile. One seed gives the same on every machine.
const TRIPLES: u64 = 2;
const SEED: u64 = 1;

/// The exercises by the clauses' ids.
pub(super) fn exercises() -> BTreeMap<&'static str, Exercise> {
    let mut all = Gathered::default();
    for vector in vectors::all().iter().flatten() {
        let Ok(profile) = vector.profile() else { continue };
        let of_clause = vector.name.split_once(" example ").map(|(id, _)| id);
        let used = match vector.read(&profile) {
            Ok(Ok(program)) => {
                let run = run(&profile.parameters, program.blocks.iter().map(|read| &read.block));
                all.margins(&run, &vector.name);
                clauses_of(&run)
            }
            // What the reader refuses shows the clause that it is an example of.
            _ => Vec::new(),
        };
        all.used(used, of_clause, &vector.name, vector.error.is_some());
    }
    for (name, _) in BUILTIN {
        let Some(profile) = Profile::builtin(name) else { continue };
        for triple in boundary::all(SEED, TRIPLES, Reach::of(&profile)) {
            for (place, blocks) in boundary::Triple::NAMES.iter().zip(&triple.programs) {
                let name = format!("boundary {} {place} ({}) under {name}", triple.kind.id(), triple.family);
                all.margins(&exact(&profile, blocks), &name);
            }
        }
    }
    all.exercises
}

fn exact(profile: &Profile, blocks: &[Block<Rational>]) -> Run {
    run(&profile.parameters, blocks)
}

/// The clauses that an outcome uses, each once.
fn clauses_of(run: &Run) -> Vec<Clause> {
    let steps = run.steps.iter().map(|step| step.clause);
    let decisions = run.decisions.iter().map(|(decision, _)| decision.clause());
    let advisories = run.advisories.iter().map(|advisory| advisory.kind.clause());
    let alarm = run.alarm.map(|alarm| alarm.kind.clause());
    let mut used: Vec<Clause> = steps.chain(decisions).chain(advisories).chain(alarm).collect();
    used.sort_unstable();
    used.dedup();
    used
}

#[derive(Default)]
struct Gathered {
    exercises: BTreeMap<&'static str, Exercise>,
}

impl Gathered {
    /// Counts a vector, or a worked example of a clause, that uses these clauses.
    fn used(&mut self, used: Vec<Clause>, of_clause: Option<&str>, name: &str, refused: bool) {
        for clause in used {
            let exercise = self.exercises.entry(clause.id()).or_default();
            match of_clause {
                Some(own) if own == clause.id() => exercise.used = true,
                Some(_) => exercise.other_examples += 1,
                None => {
                    exercise.vectors.push(name.to_owned());
                    exercise.used = true;
                }
            }
        }
        let known =
            |id: &str| radcomp_spec::clause::ALL.iter().map(|(clause, _)| clause.id()).find(|known| *known == id);
        if let Some(own) = of_clause.and_then(known) {
            let exercise = self.exercises.entry(own).or_default();
            exercise.examples += 1;
            exercise.used |= refused;
        }
    }

    fn margins(&mut self, run: &Run, program: &str) {
        for (decision, _) in &run.decisions {
            let exercise = self.exercises.entry(decision.clause().id()).or_default();
            let closest = closest(&mut exercise.decisions, decision.kind);
            let mm = decision.margin.to_f64();
            let margin = || Margin { mm, shown: short(mm, &decision.margin.short(12)), program: program.to_owned() };
            match decision.exact {
                Ordering::Equal => closest.exactly += 1,
                Ordering::Less if closest.below.as_ref().is_none_or(|known| known.mm < mm) => {
                    closest.below = Some(margin());
                }
                Ordering::Greater if closest.above.as_ref().is_none_or(|known| mm < known.mm) => {
                    closest.above = Some(margin());
                }
                _ => {}
            }
        }
    }
}

fn closest(decisions: &mut Vec<Closest>, kind: DecisionKind) -> &mut Closest {
    let place = decisions.iter().position(|closest| closest.decision == kind.id()).unwrap_or_else(|| {
        decisions.push(Closest { decision: kind.id(), below: None, exactly: 0, above: None });
        decisions.len() - 1
    });
    &mut decisions[place]
}

/// A margin for reading: decimals where they are few, else a power of ten.
fn short(mm: f64, decimal: &str) -> String {
    if decimal.len() <= 8 { decimal.to_owned() } else { format!("{mm:.2e}") }
}
