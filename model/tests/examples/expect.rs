//! What an example expects, beside what the model answers.

use std::fmt;

use radcomp_model::number::Real;
use radcomp_model::{Run, Vector, tip};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Direction, Segment, Step};
use rug::Rational;

use crate::example::Example;

/// A word of a step, advisory or point; numbers are compared exactly.
#[derive(Clone, PartialEq)]
enum Word {
    Text(String),
    Number(Real),
}

impl fmt::Debug for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Word::Text(text) => f.write_str(text),
            Word::Number(value) => write!(f, "{value}"),
        }
    }
}

type Sentence = Vec<Word>;

/// Every difference, for people; `lines` are the lines of the blocks.
pub fn faults(example: &Example, profile: &Profile, lines: &[usize], run: &Run) -> Vec<String> {
    let mut faults = Vec::new();
    let mut compare = |what: &str, expected: Vec<Sentence>, answered: Vec<Sentence>| {
        if expected != answered {
            faults.push(format!("{what} {expected:?}\n    answered {answered:?}"));
        }
    };
    let path = run.steps.iter().map(|step| step_in_words(step, lines));
    compare("path", sentences(&example.path), path.collect());
    let alarm = run.alarm.map(|alarm| vec![count(lines[alarm.block]), text(alarm.kind.id())]);
    compare("alarm", sentences(example.alarm.as_slice()), alarm.into_iter().collect());
    if let Some(expected) = &example.advisories {
        // In the order of blocks: that of a block is looked at when the next one has been read.
        let mut advisories: Vec<_> = run.advisories.iter().collect();
        advisories.sort_by_key(|advisory| advisory.block);
        let advisories = advisories.into_iter().map(|advisory| {
            let amount = Word::Number(advisory.amount.clone());
            vec![count(lines[advisory.block]), text(advisory.kind.id()), amount]
        });
        compare("advisories", sentences(expected), advisories.collect());
    }
    if let Some(expected) = &example.tip_path {
        let orientation = profile.tips[example.tip.unwrap_or(0)];
        let radius = Real::rational(example.offset(1).expect("tool 1 has a radius"));
        let moves = run.steps.iter().filter(|step| step.segment != Segment::Hold);
        let tips = moves.map(|step| match tip(step, &profile.parameters, &radius, orientation) {
            Some(Vector { a, b }) => vec![Word::Number(a), Word::Number(b)],
            None => vec![text("none")],
        });
        compare("tip-path", sentences(expected), tips.collect());
    }
    if run.contradiction {
        faults.push("the engine contradicts itself".to_owned());
    }
    faults
}

fn text(word: &str) -> Word {
    Word::Text(word.to_owned())
}

fn count(value: usize) -> Word {
    Word::Number(Real::rational(Rational::from(value)))
}

/// What an example writes.
fn sentences(texts: &[String]) -> Vec<Sentence> {
    let word = |word: &str| Real::parse(word).map_or_else(|_| text(word), Word::Number);
    texts.iter().map(|text| text.split_whitespace().map(word).collect()).collect()
}

/// A step as an example would write it.
fn step_in_words(step: &Step<Real>, lines: &[usize]) -> Sentence {
    let point = |[a, b]: &[Real; 2]| [Word::Number(a.clone()), Word::Number(b.clone())];
    let mut words = vec![count(lines[step.block])];
    match &step.segment {
        Segment::Hold => words.push(text("hold")),
        Segment::Line { end } => {
            words.push(text("line"));
            words.extend(point(end));
        }
        Segment::Arc { end, centre, direction, full } => {
            words.push(text("arc"));
            words.push(text(match direction {
                Direction::Clockwise => "cw",
                Direction::Counterclockwise => "ccw",
            }));
            words.extend(point(end));
            words.push(text("centre"));
            words.extend(point(centre));
            words.extend(full.then(|| text("full")));
        }
    }
    words.push(text(step.clause.id()));
    words
}
