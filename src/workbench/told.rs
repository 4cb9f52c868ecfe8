//! Blocks explained, and the path in exact numbers: what takes long is told of what is looked at.

use std::cmp::Ordering;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Engine, Sink};
use radcomp_spec::Step;
use serde_json::Value;

use super::study::{Patience, Study, alarm_of};
use super::{Asked, Trouble};
use crate::explain::{Choice, Teller, event};

/// Digits after the decimal points of what is told, and of the path, as `radcomp explain` and `radcomp run` write them.
const TOLD_DIGITS: usize = 6;
const PATH_DIGITS: usize = 12;

/// The blocks in the lines that are asked, as a JSON array of what [`Teller::as_json`] writes.
///
/// # Errors
///
/// As [`run`](super::run).
pub fn blocks(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let study = Study::read(asked, &profile, patience)?;
    let mut teller = Teller::new(Vec::new(), Choice::Lines(asked.lines.clone()), TOLD_DIGITS, false).as_json();
    let mut engine = Engine::new(&profile.parameters);
    let mut stopped = Ok(());
    for (block, source) in study.blocks.iter().zip(&study.sources) {
        patience.check(source.line)?;
        teller.read(block, source.clone(), study.axes);
        stopped = engine.push(block, &mut teller);
        if stopped.is_err() || teller.told() == asked.lines.len() {
            break;
        }
    }
    if stopped.is_ok() && study.refused.is_none() {
        stopped = engine.finish(&mut teller);
    }
    teller.finish(alarm_of(stopped)?).map_err(Trouble::own)?;
    let told = String::from_utf8(teller.into_inner()).map_err(Trouble::own)?;
    Ok(format!("[{}]", told.trim_end().replace('\n', ",\n")))
}

/// The path as a JSON array of the elements that `radcomp run --format json` prints, each with the index of its `block`.
///
/// # Errors
///
/// As [`run`](super::run).
pub fn path(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let study = Study::read(asked, &profile, patience)?;
    let mut listener = Listener { study: &study, path: Vec::new() };
    study.run(&profile, patience, &mut listener)?;
    Ok(Value::Array(listener.path).to_string())
}

/// Hears the path.
struct Listener<'s> {
    study: &'s Study,
    path: Vec<Value>,
}

impl Sink for Listener<'_> {
    fn step(&mut self, step: Step<Real>) {
        let mut record = self.study.place(step.block);
        if let (Value::Object(record), Value::Object(more)) = (&mut record, event(&step, self.study.axes, PATH_DIGITS))
        {
            record.extend(more);
        }
        self.path.push(record);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}
