//! What a vector expects, compared with what the model answers.

use radcomp_model::number::Real;
use radcomp_model::{Run, run};
use radcomp_spec::parameters::Tip;
use radcomp_spec::{Direction, Parameters, Segment};

use super::Vector;
use crate::gcode::Program;
use crate::tip;

/// Runs a vector through reader and model. None if every expectation holds exactly, else the first that does not, in
/// words.
pub fn mismatch(vector: &Vector) -> Option<String> {
    check(vector).err()
}

fn check(vector: &Vector) -> Result<(), String> {
    let profile = vector.profile()?;
    let program = match (vector.read(&profile)?, &vector.error) {
        (Ok(program), None) => program,
        (Ok(_), Some(expected)) => return Err(format!("the reader should refuse the program: {expected}")),
        (Err(diagnostic), None) => return Err(format!("the reader refuses the program:\n{diagnostic}")),
        (Err(diagnostic), Some(expected)) => {
            let (line, part) = expected.split_once(':').ok_or("error: expected `LINE: part of the message`")?;
            let text = diagnostic.to_string();
            return if diagnostic.line.to_string() == line.trim() && text.contains(part.trim()) {
                Ok(())
            } else {
                Err(format!("expected the refusal `{expected}`, got\n{text}"))
            };
        }
    };
    let blocks: Vec<_> = program.blocks.iter().map(|read| read.block.clone()).collect();
    let run = run(&profile.parameters, &blocks);
    path(vector, &program, &run)?;
    tip_path(vector, &profile.parameters, &program, &run)?;
    let line = |block: usize| program.blocks.get(block).map_or(0, |read| read.line);
    let alarm = run.alarm.map(|alarm| format!("{} {}", line(alarm.block), alarm.kind.id()));
    if alarm != vector.alarm {
        return Err(format!("expected the alarm {:?}, got {alarm:?}", vector.alarm));
    }
    if let Some(expected) = &vector.advisories {
        let mut wanted = expected.iter();
        let mut advisories: Vec<_> = run.advisories.iter().collect();
        advisories.sort_by_key(|advisory| advisory.block);
        for advisory in advisories {
            let got = format!("{} {} {}", line(advisory.block), advisory.kind.id(), advisory.amount);
            let text = wanted.next().ok_or_else(|| format!("an advisory that is not expected: {got}"))?;
            let mut words = text.splitn(3, ' ');
            let place = words.next() == Some(&line(advisory.block).to_string());
            let kind = words.next() == Some(advisory.kind.id());
            if !place || !kind || number(words.next().unwrap_or(""))? != advisory.amount {
                return Err(format!("expected the advisory `{text}`, got `{got}`"));
            }
        }
        if let Some(text) = wanted.next() {
            return Err(format!("expected the advisory `{text}`, got none"));
        }
    }
    Ok(())
}

fn path(vector: &Vector, program: &Program, run: &Run) -> Result<(), String> {
    for index in 0..vector.path.len().max(run.steps.len()) {
        let got = run.steps.get(index).map(|step| {
            let line = program.blocks.get(step.block).map_or(0, |read| read.line);
            let geometry = match &step.segment {
                Segment::Hold => "hold".to_owned(),
                Segment::Line { end } => format!("line {} {}", end[0], end[1]),
                Segment::Arc { end, centre, direction, full } => format!(
                    "arc {} {} {} centre {} {}{}",
                    if *direction == Direction::Clockwise { "cw" } else { "ccw" },
                    end[0],
                    end[1],
                    centre[0],
                    centre[1],
                    if *full { " full" } else { "" }
                ),
            };
            format!("{line} {geometry} {}", step.clause)
        });
        let Some(expected) = vector.path.get(index) else {
            return Err(format!("step {}: nothing expected, got `{}`", index + 1, got.unwrap_or_default()));
        };
        let differs =
            || format!("step {}: expected `{expected}`, got `{}`", index + 1, got.clone().unwrap_or_default());
        let step = run.steps.get(index).ok_or_else(differs)?;
        let line = program.blocks.get(step.block).map_or(0, |read| read.line).to_string();
        let words: Vec<&str> = expected.split_whitespace().collect();
        let same = match (&step.segment, words.as_slice()) {
            (Segment::Hold, [at, "hold", clause]) => *at == line && *clause == step.clause.id(),
            (Segment::Line { end }, [at, "line", a, b, clause]) => {
                *at == line && *clause == step.clause.id() && number(a)? == end[0] && number(b)? == end[1]
            }
            (
                Segment::Arc { end, centre, direction, full },
                [at, "arc", sense, a, b, "centre", i, j, rest @ .., clause],
            ) => {
                let clockwise = *direction == Direction::Clockwise;
                *at == line
                    && *clause == step.clause.id()
                    && *sense == if clockwise { "cw" } else { "ccw" }
                    && *full == (*rest == ["full"])
                    && (rest.is_empty() || *full)
                    && number(a)? == end[0]
                    && number(b)? == end[1]
                    && number(i)? == centre[0]
                    && number(j)? == centre[1]
            }
            _ => false,
        };
        if !same {
            return Err(differs());
        }
    }
    Ok(())
}

/// The tip at the end of each step but the holds.
fn tip_path(vector: &Vector, parameters: &Parameters, program: &Program, run: &Run) -> Result<(), String> {
    let Some(expected) = &vector.tip_path else { return Ok(()) };
    let mut tips = Vec::new();
    for step in &run.steps {
        let nose = program.blocks.get(step.block).and_then(|read| read.nose.as_ref());
        let (radius, orientation) = nose.map_or((Real::zero(), Tip::Centre), |nose| ((&nose.radius).into(), nose.tip));
        let told = tip::at_end(step, nose, parameters);
        let exact = radcomp_model::tip(step, parameters, &radius, orientation).map(|tip| [tip.a, tip.b]);
        if told != exact {
            return Err(format!("the model and the toolkit have two tips after block {}", step.block));
        }
        tips.extend(exact);
    }
    for index in 0..expected.len().max(tips.len()) {
        let got = tips.get(index).map(|[a, b]| format!("{a} {b}")).unwrap_or_default();
        let wanted = expected.get(index).map(String::as_str).unwrap_or_default();
        let same = match (tips.get(index), wanted.split_once(' ')) {
            (Some(tip), Some((a, b))) => number(a)? == tip[0] && number(b)? == tip[1],
            _ => false,
        };
        if !same {
            return Err(format!("tip {}: expected `{wanted}`, got `{got}`", index + 1));
        }
    }
    Ok(())
}

fn number(text: &str) -> Result<Real, String> {
    Real::parse(text).map_err(|error| format!("{text:?}: {error}"))
}
