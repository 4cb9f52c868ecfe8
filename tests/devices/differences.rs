//! What `spec/LINUXCNC.md` says that the stock interpreter does otherwise: each program through the real `rs274` and through
//! the model, and the waivers that cover the differences.

use std::collections::BTreeSet;
use std::fs;

use radcomp::certify::{Campaign, Waivers, certify, group};
use radcomp::device::linuxcnc::LinuxCnc;
use radcomp::device::{Answer, Device};
use radcomp::gcode::{Tools, read};
use radcomp::judge::{Budget, Grade, judge_answer};
use radcomp::report::AnswerRecord;
use radcomp_model::number::parse_decimal;
use radcomp_model::run;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Block, Direction, Segment, Step};
use rug::Rational;
use serde::Deserialize;

use super::linuxcnc::RS274;
use super::{limits, repository};

/// A difference, as the document tells it. Blocks are counted from 1, coordinates are rounded to four decimals.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
struct Difference {
    radius: String,
    program: String,
    rs274: Vec<String>,
    rs274_alarm: Option<String>,
    rule: Vec<String>,
    rule_alarm: Option<String>,
    /// The clause and the kind of difference that the judge names.
    cause: String,
}

/// The differences of the document, each with its heading.
fn differences() -> Vec<(String, Difference)> {
    let text = fs::read_to_string(repository("spec/LINUXCNC.md")).unwrap();
    let mut found = Vec::new();
    for section in text.split("\n## ").skip(1) {
        let heading = section.lines().next().unwrap().to_owned();
        for block in section.split("```toml difference\n").skip(1) {
            let block = block.split("```").next().unwrap();
            found.push((heading.clone(), toml::from_str(block).unwrap_or_else(|error| panic!("{heading}: {error}"))));
        }
    }
    found
}

fn profile() -> Profile {
    Profile::builtin("linuxcnc").unwrap()
}

fn blocks(difference: &Difference) -> Vec<Block<Rational>> {
    let tools = Tools::empty().with_radius(1, parse_decimal(&difference.radius).unwrap());
    let tools = tools.with_radius(2, Rational::from(3));
    let program = read("program", difference.program.as_bytes(), &profile(), &tools);
    program.unwrap_or_else(|error| panic!("{error}")).blocks.into_iter().map(|read| read.block).collect()
}

/// The moves of a path, in words.
fn told(steps: &[Step<f64>]) -> Vec<String> {
    let point = |[a, b]: [f64; 2]| {
        let [a, b] = [a, b].map(|value| (value * 1e4).round() / 1e4 + 0.0);
        format!("{a} {b}")
    };
    let moves = steps.iter().filter_map(|step| {
        let number = step.block + 1;
        Some(match step.segment {
            Segment::Hold => return None,
            Segment::Line { end } => format!("{number} line {}", point(end)),
            Segment::Arc { end, centre, direction, .. } => {
                let sense = if direction == Direction::Clockwise { "cw" } else { "ccw" };
                format!("{number} {sense} {} about {}", point(end), point(centre))
            }
        })
    });
    moves.collect()
}

fn alarm(alarm: Option<Alarm>) -> Option<String> {
    alarm.map(|alarm| format!("{} {}", alarm.block + 1, alarm.kind.id()))
}

/// The exact outcome, its numbers rounded.
fn outcome(blocks: &[Block<Rational>]) -> Answer {
    let exact = run(&profile().parameters, blocks);
    let point = |point: &[radcomp_model::number::Real; 2]| [point[0].to_f64(), point[1].to_f64()];
    let steps = exact.steps.iter().map(|step| Step {
        block: step.block,
        clause: step.clause,
        rapid: step.rapid,
        main: step.main,
        segment: match &step.segment {
            Segment::Hold => Segment::Hold,
            Segment::Line { end } => Segment::Line { end: point(end) },
            Segment::Arc { end, centre, direction, full } => {
                Segment::Arc { end: point(end), centre: point(centre), direction: *direction, full: *full }
            }
        },
    });
    Answer { steps: steps.collect(), alarm: exact.alarm }
}

#[test]
fn each_difference_is_what_the_document_says() {
    let waivers = Waivers::parse(&fs::read_to_string(repository("examples/linuxcnc-waivers.toml")).unwrap()).unwrap();
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };
    let mut device = LinuxCnc::run(RS274.clone(), &profile(), limits()).unwrap();
    let differences = differences();
    assert!(differences.len() >= 5, "{}", differences.len());
    let mut wrong = Vec::new();
    for (heading, difference) in &differences {
        let blocks = blocks(difference);
        assert!(blocks.len() <= 6, "{heading}: {} blocks", blocks.len());
        let rule = outcome(&blocks);
        let answer = device.answer(&profile().parameters, &blocks).unwrap_or_else(|fault| panic!("{heading}: {fault}"));
        let mut expect = |what: &str, is: String, said: String| {
            if is != said {
                wrong.push(format!("{heading}: {what} is {is}, the document says {said}"));
            }
        };
        expect("the rule's path", format!("{:?}", told(&rule.steps)), format!("{:?}", difference.rule));
        expect("the rule's alarm", format!("{:?}", alarm(rule.alarm)), format!("{:?}", difference.rule_alarm));
        expect("the path of rs274", format!("{:?}", told(&answer.steps)), format!("{:?}", difference.rs274));
        expect("the alarm of rs274", format!("{:?}", alarm(answer.alarm)), format!("{:?}", difference.rs274_alarm));
        let judged = judge_answer(Ok(answer), &profile().parameters, &blocks, &budget);
        expect("the cause", group(&judged.verdict), difference.cause.clone());
        let covered = waivers.covering("", &judged).is_some();
        expect("whether a waiver covers it", covered.to_string(), "true".to_owned());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// As one would by hand: an interpreter for each program, which has answered nothing before.
#[test]
fn what_a_report_tells_is_found_again_with_the_interpreter_alone() {
    let campaign = Campaign {
        profile: profile(),
        seed: 1,
        programs: 4_000,
        budget: Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 },
        waivers: Waivers::default(),
        threads: 2,
    };
    let device = || LinuxCnc::run(RS274.clone(), &profile(), limits()).unwrap();
    let outcome = certify(&campaign, device, |_| {});
    assert!(outcome.groups.len() >= 5, "{} causes", outcome.groups.len());
    for (cause, _, smallest) in &outcome.groups {
        let answer = device().answer(&profile().parameters, &smallest.blocks).unwrap();
        assert_eq!(Some(AnswerRecord::from(&answer)), smallest.case.answer, "{cause}");
    }
}

#[test]
fn each_waiver_names_sections_of_the_document() {
    let text = fs::read_to_string(repository("examples/linuxcnc-waivers.toml")).unwrap();
    let headings: BTreeSet<_> =
        differences().iter().filter_map(|(heading, _)| Some(heading.split_whitespace().next()?.to_owned())).collect();
    for waiver in Waivers::parse(&text).unwrap().0 {
        let named: Vec<_> =
            waiver.reason.split([' ', ',', ';', ':']).filter(|word| word.starts_with("LCNC-")).collect();
        assert!(!named.is_empty(), "{waiver}: {}", waiver.reason);
        assert!(named.iter().all(|name| headings.contains(*name)), "{waiver}: {}", waiver.reason);
        assert!(waiver.difference.is_some() && waiver.program.is_none(), "{waiver}");
    }
}
