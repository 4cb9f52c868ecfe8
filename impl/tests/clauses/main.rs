//! Every worked example of the clauses and every vector that is no error of the program, word by word: paths, clauses
//! and alarms.

#[path = "../common/mod.rs"]
mod common;
mod example;
mod reader;

use common::{run, write};
use example::{Example, expected, number};
use radcomp_spec::parameters::{StartUp, StartUpLost, Tip};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Segment, Step, clause};
use reader::Reader;

/// The largest coordinate of the examples is 10⁹; most are below 100.
const TOLERANCE: f64 = 1e-12;

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * a.abs().max(100.0)
}

fn check(example: &Example) -> Result<(), String> {
    let profile = example.profile();
    let own = example.number("radius") + example.number("wear");
    let mut tools: Vec<(u32, f64)> = vec![(1, own)];
    for (tool, radius) in example.table("tools") {
        tools.push((tool.parse().unwrap(), radius.trim_matches('"').parse().unwrap()));
    }
    let mut reader = Reader::new(&profile, tools);
    let program = example.between("program = \"\"\"\n", "\"\"\"");
    let blocks: Vec<_> = program.lines().map(|line| reader.block(line)).collect();
    let (steps, alarm) = run(&profile.parameters, &blocks);
    let alarm = alarm.map(|alarm| format!("{} {}", alarm.block + 1, alarm.kind.id()));
    if alarm.as_deref() != example.text("alarm") {
        return Err(format!("alarm {alarm:?}"));
    }
    let path = example.list("path");
    let written: Vec<_> = steps.iter().map(write).collect();
    let same = path.len() == written.len()
        && path.iter().zip(&written).all(|(line, written)| {
            let expected = expected(line);
            expected.0 == written.0
                && expected.1.len() == written.1.len()
                && expected.1.iter().zip(&written.1).all(|(a, b)| near(*a, *b))
        });
    if !same {
        return Err(format!("path {written:?}"));
    }
    let tips = example.list("tip-path");
    let found = tip_path(&profile, example, &steps, own.abs());
    let at_tip = |(line, tip): (&&str, &[f64; 2])| {
        let (a, b) = line.split_once(' ').unwrap();
        near(number(a), tip[0]) && near(number(b), tip[1])
    };
    let same = tips.is_empty() || tips.len() == found.len() && tips.iter().zip(&found).all(at_tip);
    if same { Ok(()) } else { Err(format!("tip-path {found:?}")) }
}

/// The tip at the end of each step that is not a hold. [TRC-TIP-03]
fn tip_path(profile: &Profile, example: &Example, steps: &[Step<f64>], radius: f64) -> Vec<[f64; 2]> {
    let tip = match profile.tips[example.number("tip") as usize] {
        Tip::Centre | Tip::Absent => [0.0, 0.0],
        Tip::PlusPlus => [1.0, 1.0],
        Tip::MinusPlus => [-1.0, 1.0],
        Tip::MinusMinus => [-1.0, -1.0],
        Tip::PlusMinus => [1.0, -1.0],
        Tip::Plus => [1.0, 0.0],
        Tip::Minus => [-1.0, 0.0],
        Tip::UpPlus => [0.0, 1.0],
        Tip::UpMinus => [0.0, -1.0],
    };
    let parameters = &profile.parameters;
    let no_vector = parameters.start_up_lost == StartUpLost::NoVector && parameters.start_up != StartUp::EntryNormal;
    let cancel_mode = |step: &Step<f64>| {
        [clause::TRC_MODE_01, clause::TRC_CANCEL_02, clause::TRC_CANCEL_03, clause::TRC_CANCEL_06]
            .contains(&step.clause)
            || no_vector && step.clause == clause::TRC_START_04
    };
    let end = |step: &Step<f64>| match step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => {
            let reach = if cancel_mode(step) { 0.0 } else { radius };
            Some([end[0] + reach * tip[0], end[1] + reach * tip[1]])
        }
        Segment::Hold => None,
    };
    steps.iter().filter_map(end).collect()
}

/// Checks the examples between the parts that `split` makes of the files of a folder.
fn check_all<'a>(folder: &str, texts: &'a mut Vec<String>, split: impl Fn(&'a str) -> Vec<Example<'a>>) -> usize {
    let (mut examples, mut failures) = (0, String::new());
    for file in std::fs::read_dir(folder).unwrap() {
        texts.push(std::fs::read_to_string(file.unwrap().path()).unwrap());
    }
    for text in &*texts {
        for example in split(text) {
            if example.field("error").is_some() {
                continue;
            }
            examples += 1;
            if let Err(reason) = check(&example) {
                failures += &format!("{}\n{reason}\n\n", example.0);
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
    examples
}

#[test]
fn worked_examples() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../spec/clauses");
    let examples = check_all(folder, &mut Vec::new(), |text| {
        text.split("```toml example\n").skip(1).map(|part| Example(part.split_once("\n```").unwrap().0)).collect()
    });
    assert!(examples > 250, "only {examples} examples");
}

#[test]
fn vectors() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/vectors");
    let vectors = check_all(folder, &mut Vec::new(), |text| text.split("[[vector]]\n").skip(1).map(Example).collect());
    assert!(vectors > 15, "only {vectors} vectors");
}
