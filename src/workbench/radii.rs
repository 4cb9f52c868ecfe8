//! With which radii a program ends in an alarm.

use std::cmp::Ordering;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Sink};
use radcomp_spec::{Advisory, Step};
use serde_json::{Value, json};

use super::study::{Patience, Study};
use super::{Asked, MOST_BLOCKS, Trouble};

/// How the program ends with each of some radii: a JSON array of `radius`, `alarm` (null, or its name) and `line`.
///
/// # Errors
///
/// As [`run`](super::run); also a program whose blocks, times the radii, are more than [`MOST_BLOCKS`].
pub(super) fn radii(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let mut answers = Vec::new();
    for radius in &asked.radii {
        let study = Study::read(&Asked { radius: radius.clone(), ..asked.clone() }, &profile, patience)?;
        if study.blocks.len() * asked.radii.len() > MOST_BLOCKS {
            return Err(Trouble::too_large(format!(
                "{} radii are tried with programs of at most {} blocks",
                asked.radii.len(),
                MOST_BLOCKS / asked.radii.len()
            )));
        }
        let alarm = study.run(&profile, patience, &mut Deaf)?;
        answers.push(json!({
            "radius": radius,
            "alarm": alarm.map(|alarm| alarm.kind.id()),
            "line": alarm.and_then(|alarm| study.sources.get(alarm.block)).map(|source| source.line),
        }));
    }
    Ok(Value::Array(answers).to_string())
}

/// Hears the model and keeps nothing.
struct Deaf;

impl Sink for Deaf {
    fn step(&mut self, _: Step<Real>) {}

    fn advisory(&mut self, _: Advisory<Real>) {}

    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}
