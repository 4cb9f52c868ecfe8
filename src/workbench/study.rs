//! A program read, run by the model, and told as JSON.

use std::cmp::Ordering;
use std::sync::Arc;
use std::sync::atomic::{self, AtomicBool};
use std::time::{Duration, Instant};

use radcomp_model::number::Real;
use radcomp_model::{Decision, Engine, Run, Sink, Stop};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Advisory, Alarm, Block, Segment, Step};
use rug::Rational;
use serde_json::{Value, json};

use super::drawing::Drawing;
use super::{Asked, MOST_BLOCKS, Trouble, overlay};
use crate::device::wire;
use crate::explain::{Axes, Choice, Source, Teller, event, number};
use crate::gcode::{Diagnostic, Reader};
use crate::judge::rounded;

/// Digits after the decimal points of what is told, and of the path, as `radcomp explain` and `radcomp run` write them.
const TOLD_DIGITS: usize = 6;
const PATH_DIGITS: usize = 12;

/// How long a computation may go on.
#[derive(Clone, Debug)]
pub struct Patience {
    until: Instant,
    time: Duration,
    abandoned: Arc<AtomicBool>,
}

impl Patience {
    /// So long from now on, and as long as nobody sets `abandoned`.
    pub fn new(time: Duration, abandoned: Arc<AtomicBool>) -> Self {
        Patience { until: Instant::now() + time, time, abandoned }
    }

    fn check(&self, line: u32) -> Result<(), Trouble> {
        if self.abandoned.load(atomic::Ordering::Relaxed) {
            return Err(Trouble::too_long("nobody waits for the answer"));
        }
        if Instant::now() > self.until {
            let seconds = self.time.as_secs();
            return Err(Trouble::too_long(format!(
                "stopped in line {line}: the workbench computes for {seconds} s at most; `radcomp run` has no limit"
            )));
        }
        Ok(())
    }
}

/// A program as it is run.
#[derive(Debug)]
pub(super) struct Study {
    /// Its blocks.
    pub(super) blocks: Vec<Block<Rational>>,
    /// Their places.
    pub(super) sources: Vec<Source>,
    /// The axes of the last block's plane.
    pub(super) axes: Axes,
    /// The line that stopped the reader.
    refused: Option<Diagnostic>,
}

/// The outcome of a program as one JSON object.
///
/// `blocks` is what [`Teller::as_json`] writes; `path` are the elements that `radcomp run --format json` prints, each with
/// the index of its `block`, its `shape` in doubles and the radius of the `tool` at its end; `programmed` is the contour, `tools` are the places and radii of the
/// tool, `marks` the places of `warnings` and of the `alarm`; `alarm`, `refused` (the reader's diagnostic), `safety` and
/// `device` are null where there is nothing to say.
///
/// # Errors
///
/// A request that cannot be followed, and one beyond a limit. What is wrong with the program itself is no error: it is
/// told in the answer.
pub fn run(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let begun = Instant::now();
    let profile = asked.control()?;
    let study = read(asked, &profile, patience)?;
    let told = tell(&study, &profile, patience)?;
    let exact = &told.run;
    patience.check(last_line(&study))?;
    let stop = exact.alarm.map(|alarm| alarm.block);
    let safety = asked.safety.then(|| overlay::safety(&study, &rounded(exact), stop));
    patience.check(last_line(&study))?;
    let device = overlay::device(asked, &study, &profile, exact);
    let mut record = json!({
        "radcomp": env!("CARGO_PKG_VERSION"),
        "profile": profile.name,
        "plane": study.axes.plane.id(),
        "axes": study.axes.letters().map(String::from),
        "radius": told.drawing.radius(),
        "programmed": told.drawing.programmed(),
        "tools": told.drawing.tools(),
        "marks": told.drawing.marks(),
        "path": path(&study, &told),
        "warnings": exact.advisories.iter().map(|advisory| warning(&study, advisory)).collect::<Vec<_>>(),
        "alarm": exact.alarm.map(|alarm| stopped_at(&study, &profile, alarm)),
        "refused": study.refused.as_ref().map(refusal),
        "safety": safety,
        "device": device,
    });
    record["milliseconds"] = json!(begun.elapsed().as_secs_f64() * 1e3);
    // The blocks are JSON already, one a line.
    let blocks = told.blocks.trim_end().replace('\n', ",\n");
    let record = record.to_string();
    Ok(format!("{{\"blocks\":[{blocks}],{}", record.trim_start_matches('{')))
}

/// The program as one request of the pipe protocol, on one line.
///
/// # Errors
///
/// As [`run`]; also a program that cannot be read to its end.
pub(super) fn request(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let study = read(asked, &profile, patience)?;
    if let Some(refused) = &study.refused {
        return Err(Trouble::wrong(refused.to_string()));
    }
    let record = wire::ProfileRecord::new(&profile, &profile.parameters);
    wire::request("workbench", &profile, &record, &study.blocks).map_err(|fault| Trouble::wrong(fault.text()))
}

/// How the program ends with each of some radii: a JSON array of `radius`, `alarm` (null, or its name) and `line`.
///
/// # Errors
///
/// As [`run`]; also a program whose blocks, times the radii, are more than [`MOST_BLOCKS`].
pub(super) fn radii(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let mut answers = Vec::new();
    for radius in &asked.radii {
        let study = read(&Asked { radius: radius.clone(), ..asked.clone() }, &profile, patience)?;
        if study.blocks.len() * asked.radii.len() > MOST_BLOCKS {
            return Err(Trouble::too_large(format!(
                "{} radii are tried with programs of at most {} blocks",
                asked.radii.len(),
                MOST_BLOCKS / asked.radii.len()
            )));
        }
        let alarm = ending(&study, &profile, patience)?;
        answers.push(json!({
            "radius": radius,
            "alarm": alarm.map(|alarm| alarm.kind.id()),
            "line": alarm.and_then(|alarm| study.sources.get(alarm.block)).map(|source| source.line),
        }));
    }
    Ok(Value::Array(answers).to_string())
}

/// The alarm that the blocks end in, if they do.
fn ending(study: &Study, profile: &Profile, patience: &Patience) -> Result<Option<Alarm>, Trouble> {
    let mut engine = Engine::new(&profile.parameters);
    let mut stopped = Ok(());
    for (block, source) in study.blocks.iter().zip(&study.sources) {
        patience.check(source.line)?;
        stopped = stopped.and_then(|()| engine.push(block, &mut Deaf));
    }
    match stopped.and_then(|()| engine.finish(&mut Deaf)) {
        Ok(()) => Ok(None),
        Err(Stop::Alarm(alarm)) => Ok(Some(alarm)),
        Err(Stop::Contradiction) => Err(Trouble::own("its exact answers contradict each other")),
    }
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

/// Reads the program up to its end or its first fault.
fn read(asked: &Asked, profile: &Profile, patience: &Patience) -> Result<Study, Trouble> {
    let tools = asked.table()?;
    let lines: Vec<&str> = asked.program.lines().collect();
    let mut reader = Reader::new("program", asked.program.as_bytes(), profile, &tools).skip_deleted(asked.block_delete);
    let machine = &profile.machine;
    let axes = Axes { plane: machine.plane, x_words: machine.x_words };
    let mut study = Study { blocks: Vec::new(), sources: Vec::new(), axes, refused: None };
    while let Some(next) = reader.next() {
        let block = match next {
            Ok(block) => block,
            Err(diagnostic) => {
                study.refused = Some(diagnostic);
                break;
            }
        };
        if study.blocks.len() == MOST_BLOCKS {
            return Err(Trouble::too_large(format!(
                "a program in the workbench has at most {MOST_BLOCKS} blocks; `radcomp run` has no limit"
            )));
        }
        patience.check(block.line)?;
        study.axes.plane = reader.plane();
        let text = lines.get(block.line.saturating_sub(1) as usize).map_or(String::new(), |line| (*line).to_owned());
        study.sources.push(Source { line: block.line, sequence: block.sequence, text });
        study.blocks.push(block.block);
    }
    Ok(study)
}

fn last_line(study: &Study) -> u32 {
    study.sources.last().map_or(0, |source| source.line)
}

/// What the model says of a program.
struct Told {
    /// The outcome.
    run: Run,
    /// The explanation of each block, one JSON object a line.
    blocks: String,
    drawing: Drawing,
}

/// Runs the blocks.
fn tell(study: &Study, profile: &Profile, patience: &Patience) -> Result<Told, Trouble> {
    let teller = Teller::new(Vec::new(), Choice::All, TOLD_DIGITS, false).as_json();
    let mut listener = Listener { teller, drawing: Drawing::new(study.axes), run: Run::default() };
    let mut engine = Engine::new(&profile.parameters);
    let mut stopped = Ok(());
    for (block, source) in study.blocks.iter().zip(&study.sources) {
        patience.check(source.line)?;
        listener.drawing.read(block, source, study.axes);
        // The contour after an alarm is drawn too.
        if stopped.is_ok() {
            listener.teller.read(block, source.clone(), study.axes);
            stopped = engine.push(block, &mut listener);
        }
    }
    // A line that cannot be read leaves the corner before it open.
    if stopped.is_ok() && study.refused.is_none() {
        stopped = engine.finish(&mut listener);
    }
    let Listener { mut teller, mut drawing, mut run } = listener;
    match stopped {
        Ok(()) => {}
        Err(Stop::Alarm(alarm)) => {
            drawing.alarm(alarm);
            run.alarm = Some(alarm);
        }
        Err(Stop::Contradiction) => return Err(Trouble::own("its exact answers contradict each other")),
    }
    teller.finish(run.alarm).map_err(Trouble::own)?;
    let blocks = String::from_utf8(teller.into_inner()).map_err(Trouble::own)?;
    Ok(Told { run, blocks, drawing })
}

/// Hears the model, and keeps what it answers.
struct Listener {
    teller: Teller<Vec<u8>>,
    drawing: Drawing,
    run: Run,
}

impl Sink for Listener {
    fn step(&mut self, step: Step<Real>) {
        self.teller.step(step.clone());
        self.drawing.step(step.clone());
        self.run.steps.push(step);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        self.teller.advisory(advisory.clone());
        self.drawing.advisory(advisory.clone());
        self.run.advisories.push(advisory);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        self.teller.decide(decision)
    }
}

/// Where a block stands.
fn place(study: &Study, block: usize) -> Value {
    let source = study.sources.get(block);
    json!({ "block": block, "line": source.map(|at| at.line), "n": source.and_then(|at| at.sequence.clone()) })
}

fn path(study: &Study, told: &Told) -> Vec<Value> {
    let mut shapes = told.drawing.path();
    let element = |step: &Step<Real>| {
        let mut record = place(study, step.block);
        if let (Value::Object(record), Value::Object(more)) = (&mut record, event(step, study.axes, PATH_DIGITS)) {
            record.extend(more);
        }
        if !matches!(step.segment, Segment::Hold) {
            let (shape, radius) = shapes.next().unwrap_or_default();
            record["shape"] = shape;
            record["tool"] = json!(radius);
        }
        record
    };
    told.run.steps.iter().map(element).collect()
}

fn warning(study: &Study, advisory: &Advisory<Real>) -> Value {
    let mut record = place(study, advisory.block);
    record["clause"] = json!(advisory.kind.clause().id());
    record["advisory"] = json!(advisory.kind.id());
    record["text"] = json!(advisory.kind.text());
    record["amount"] = number(&advisory.amount, TOLD_DIGITS);
    record
}

fn stopped_at(study: &Study, profile: &Profile, alarm: Alarm) -> Value {
    let mut record = place(study, alarm.block);
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
