//! What is said beside the exact path: whether it is safe, and how a device's path stands to it.

use radcomp_model::Run;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Step};
use serde_json::{Value, json};

use super::study::{Patience, Study};
use super::{Asked, MOST_JUDGED, Trouble, drawing};
use crate::device::wire::{self, Reply};
use crate::device::{Answer, Builtin, DeviceFault, ask};
use crate::explain::Source;
use crate::judge::{Budget, Difference, Divergence, Grade, Verdict, judge_answer};
use crate::safety::{Contour, Finding, check};

/// How deep the tool may enter the part, how much may be left uncut, and how far a device's point may lie off, in
/// millimetres: what `radcomp safety` and `radcomp certify` take if they are told nothing.
const BUDGET: f64 = 1e-6;

/// The device that a request names, and what is said of its answer; null if it names none.
pub(super) fn device(asked: &Asked, study: &Study, profile: &Profile, exact: &Run) -> Value {
    let parameters = &profile.parameters;
    let (name, answer) = match asked.device.trim() {
        "" => return Value::Null,
        "builtin" => ("builtin", ask(&mut Builtin, parameters, &study.blocks)),
        text => ("the answer given", pasted(text, study.blocks.len())),
    };
    let answer = match answer {
        Ok(answer) => answer,
        Err(fault) => return json!({ "name": name, "fault": fault.to_string() }),
    };
    let mut record = json!({
        "name": name,
        "path": drawing::steps(&answer.steps),
        "elements": answer.steps.len(),
        "alarm": answer.alarm.map(|alarm| json!({
            "block": alarm.block,
            "at": name_of(&study.sources, alarm.block),
            "alarm": alarm.kind.id(),
            "text": alarm.kind.text(),
        })),
    });
    if asked.safety && study.refused.is_none() {
        let stop = [exact.alarm, answer.alarm].into_iter().flatten().map(|alarm| alarm.block).min();
        record["safety"] = safety(study, &answer.steps, stop);
    }
    record["verdict"] = match study.blocks.len() <= MOST_JUDGED {
        true => verdict(study, profile, answer),
        false => {
            json!({ "id": null, "text": format!("programs of more than {MOST_JUDGED} blocks are not judged here") })
        }
    };
    record
}

/// The program as one request of the pipe protocol, on one line.
///
/// # Errors
///
/// As [`run`](super::run); also a program that cannot be read to its end.
pub(super) fn request(asked: &Asked, patience: &Patience) -> Result<String, Trouble> {
    let profile = asked.control()?;
    let study = Study::read(asked, &profile, patience)?;
    if let Some(refused) = &study.refused {
        return Err(Trouble::wrong(refused.to_string()));
    }
    let record = wire::ProfileRecord::new(&profile, &profile.parameters);
    wire::request("workbench", &profile, &record, &study.blocks).map_err(|fault| Trouble::wrong(fault.text()))
}

/// An answer of the pipe protocol: one line, or one object over several lines.
fn pasted(text: &str, blocks: usize) -> Result<Answer, DeviceFault> {
    match Reply::read(text.as_bytes()) {
        Ok(reply) => reply.within(blocks).answer,
        Err(error) => Err(DeviceFault::Garbled(error.0)),
    }
}

fn verdict(study: &Study, profile: &Profile, answer: Answer) -> Value {
    let increment = profile.machine.least_increment;
    let least_increment = f64::from(increment.numerator) / f64::from(increment.denominator);
    let budget = Budget { grade: Grade::Binary64, least_increment, delta: BUDGET };
    let judged = judge_answer(Ok(answer), &profile.parameters, &study.blocks, &budget);
    let (text, block, clause) = match &judged.verdict {
        Verdict::Exact => ("the exact outcome, to within 10⁻⁶ mm".to_owned(), None, None),
        Verdict::Admissible(_) => (
            "the exact outcome of an input that the device's rounding cannot tell from this one".to_owned(),
            None,
            None,
        ),
        Verdict::AdmissibleWithoutWitness(_) => ("an outcome that the band allows".to_owned(), None, None),
        Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence) => {
            (told(divergence, &study.sources), Some(divergence.block), Some(divergence.clause.id()))
        }
        Verdict::Fault(fault) => (fault.to_string(), None, None),
    };
    json!({ "id": judged.verdict.id(), "text": text, "block": block, "clause": clause, "green": judged.verdict.is_green() })
}

/// Where a device first differs, in words.
fn told(divergence: &Divergence, sources: &[Source]) -> String {
    let at = name_of(sources, divergence.block);
    let alarm = |alarm: Option<Alarm>| {
        alarm.map_or_else(
            || "no alarm".to_owned(),
            |alarm| format!("alarm {} at {}", alarm.kind.id(), name_of(sources, alarm.block)),
        )
    };
    let words = match &divergence.difference {
        Difference::End(off) => format!("end point off by {off:.6} mm"),
        Difference::Centre(off) => format!("arc centre off by {off:.6} mm"),
        Difference::Place(off) => format!("executed {off:.6} mm from its place"),
        Difference::NotFinite => "a number that is not finite".to_owned(),
        Difference::Missing => "the path ends too early".to_owned(),
        Difference::Surplus => "the path goes on too far".to_owned(),
        Difference::Kind => "another kind of element".to_owned(),
        Difference::Block => "an element of another block".to_owned(),
        Difference::Alarm(expected, observed) => {
            format!("expected {}, got {}", alarm(*expected), alarm(*observed))
        }
    };
    format!("first difference at {at}: {words}")
}

/// The safety verdict on a path, as far as the program runs: up to the block of an alarm.
pub(super) fn safety(study: &Study, path: &[Step<f64>], stop: Option<usize>) -> Value {
    let whole = Contour::of(&study.blocks);
    let contour = match stop {
        Some(block) => whole.before(block),
        None => whole,
    };
    let path: Vec<_> = path.iter().filter(|step| stop.is_none_or(|stop| step.block < stop)).cloned().collect();
    let verdict = check(&contour, &path, BUDGET);
    let mut record = finding(&verdict.path, study);
    if contour.is_empty() {
        record["text"] = json!("nothing is compensated");
    }
    record["start_up"] = finding(&verdict.start_up, study);
    record["cancel"] = finding(&verdict.cancel, study);
    // What lies after an alarm is uncut of course.
    record["uncut"] = verdict.uncut.filter(|_| stop.is_none()).map_or(Value::Null, |uncut| {
        json!({
            "block": uncut.contour_block,
            "text": format!("{:.6} mm of {} left uncut", uncut.length, name_of(&study.sources, uncut.contour_block)),
        })
    });
    record
}

fn finding(finding: &Finding, study: &Study) -> Value {
    match finding {
        Finding::Safe { .. } => json!({ "state": "safe", "text": "the tool never enters the part" }),
        Finding::Gouges(gouge) | Finding::Undecided(gouge) => {
            let (low, high) = gouge.depth;
            let contour = name_of(&study.sources, gouge.contour_block);
            let (state, text) = match finding {
                Finding::Gouges(_) => ("gouges", format!("the tool enters the part by {low:.6} mm at {contour}")),
                _ => ("undecided", format!("between {low:.3e} and {high:.3e} mm deep at {contour}")),
            };
            json!({
                "state": state,
                "text": text,
                "block": gouge.path_block,
                "centre": gouge.centre,
                "contour": gouge.contour,
            })
        }
        Finding::OutOfRange { block } => {
            let at = name_of(&study.sources, *block);
            json!({ "state": "undecided", "text": format!("{at} holds a number out of range"), "block": block })
        }
    }
}

/// A block as people find it.
fn name_of(sources: &[Source], block: usize) -> String {
    match sources.get(block) {
        Some(Source { sequence: Some(sequence), .. }) => format!("N{sequence}"),
        Some(source) => format!("line {}", source.line),
        None => format!("block {block}"),
    }
}
