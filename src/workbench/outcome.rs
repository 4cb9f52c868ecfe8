//! What the model makes of a program, as JSON.

use std::cmp::Ordering;
use std::time::Instant;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Run, Sink};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Advisory, Alarm, Segment, Step};
use serde_json::{Value, json};

use super::drawing::Drawing;
use super::study::{Patience, Study};
use super::{Asked, Trouble, overlay};
use crate::device::Answer;
use crate::explain::number;
use crate::gcode::Diagnostic;

/// Digits after the decimal point of what a warning tells.
const DIGITS: usize = 6;

/// The outcome of a program as one JSON object: `blocks` with their places; `path`, its elements, each with the index of
/// its `block`, its `clause`, its `shape` in doubles and the radius of the `tool` at its end; `programmed`, the contour;
/// `tools`, the places and radii of the tool; `marks`, the places of `warnings` and of the `alarm`. `alarm`, `refused` (the
/// reader's diagnostic), `safety` and `device` are null where there is nothing to say.
///
/// # Errors
///
/// A request that cannot be followed, and one beyond a limit. What is wrong with the program itself is no error: it is
/// told in the answer.
pub fn run(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let begun = Instant::now();
    let profile = asked.control()?;
    let study = Study::read(asked, &profile, patience)?;
    let (exact, drawing) = exact(&study, &profile, patience)?;
    patience.check(study.last_line())?;
    let stop = exact.alarm.map(|alarm| alarm.block);
    // Of a program that is cut off in the middle of a corner, nothing is said.
    let judged = asked.safety && study.refused.is_none();
    let safety = judged.then(|| overlay::safety(&study, &Answer::from(&exact).steps, stop));
    patience.check(study.last_line())?;
    let device = overlay::device(asked, &study, &profile, &exact);
    let block = |index: usize| {
        let mut record = study.place(index);
        record["text"] = json!(study.sources[index].text);
        record
    };
    let mut record = json!({
        "radcomp": env!("CARGO_PKG_VERSION"),
        "profile": profile.name,
        "plane": study.axes.plane.id(),
        "axes": study.axes.letters().map(String::from),
        "radius": drawing.radius(),
        "blocks": (0..study.blocks.len()).map(block).collect::<Vec<_>>(),
        "programmed": drawing.programmed(),
        "tools": drawing.tools(),
        "marks": drawing.marks(),
        "path": path(&exact, &drawing),
        "warnings": exact.advisories.iter().map(|advisory| warning(&study, advisory)).collect::<Vec<_>>(),
        "alarm": exact.alarm.map(|alarm| stopped_at(&study, &profile, alarm)),
        "refused": study.refused.as_ref().map(refusal),
        "safety": safety,
        "device": device,
    });
    record["milliseconds"] = json!(begun.elapsed().as_secs_f64() * 1e3);
    Ok(record.to_string())
}

/// Runs the blocks; those after an alarm are drawn, too.
fn exact(study: &Study, profile: &Profile, patience: &Patience) -> Result<(Run, Drawing), Trouble> {
    let mut listener = Listener { drawing: Drawing::new(study.axes), run: Run::default() };
    for (block, source) in study.blocks.iter().zip(&study.sources) {
        listener.drawing.read(block, source, study.axes);
    }
    let alarm = study.run(profile, patience, &mut listener)?;
    let Listener { mut drawing, mut run } = listener;
    if let Some(alarm) = alarm {
        drawing.alarm(alarm);
    }
    run.alarm = alarm;
    Ok((run, drawing))
}

/// Hears the model, and keeps what it answers.
struct Listener {
    drawing: Drawing,
    run: Run,
}

impl Sink for Listener {
    fn step(&mut self, step: Step<Real>) {
        self.drawing.step(step.clone());
        self.run.steps.push(step);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        self.drawing.advisory(advisory.clone());
        self.run.advisories.push(advisory);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}

fn path(exact: &Run, drawing: &Drawing) -> Vec<Value> {
    let mut shapes = drawing.path();
    let element = |step: &Step<Real>| {
        let mut record = json!({ "block": step.block, "clause": step.clause.id() });
        if !matches!(step.segment, Segment::Hold) {
            let (shape, radius) = shapes.next().unwrap_or_default();
            record["shape"] = shape;
            record["tool"] = json!(radius);
        }
        record
    };
    exact.steps.iter().map(element).collect()
}

fn warning(study: &Study, advisory: &Advisory<Real>) -> Value {
    let mut record = study.place(advisory.block);
    record["clause"] = json!(advisory.kind.clause().id());
    record["advisory"] = json!(advisory.kind.id());
    record["text"] = json!(advisory.kind.text());
    record["amount"] = number(&advisory.amount, DIGITS);
    record
}

fn stopped_at(study: &Study, profile: &Profile, alarm: Alarm) -> Value {
    let mut record = study.place(alarm.block);
    record["clause"] = json!(alarm.kind.clause().id());
    record["alarm"] = json!(alarm.kind.id());
    record["text"] = json!(alarm.kind.text());
    record["number"] = json!(profile.alarm_number(alarm.kind));
    record
}

fn refusal(diagnostic: &Diagnostic) -> Value {
    json!({
        "line": diagnostic.line,
        "column": diagnostic.column,
        "length": diagnostic.length,
        "title": diagnostic.kind.title(),
        "text": diagnostic.message,
        "help": diagnostic.help,
        "clause": diagnostic.clause.map(|clause| clause.id()),
    })
}
