//! Whether a device is set up: what each of a few plain programs, on which no two controls differ, shows of its adapter.

use std::time::Instant;

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Segment, Side, Step};
use rug::Rational;

use super::{Answer, Device, DeviceFault, ask};
use crate::generate::{self, Reach};

/// What one test found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// What was tested.
    pub test: &'static str,
    /// What was seen, if all is well; what is wrong and what would be right, if not.
    pub result: Result<String, String>,
}

/// How far from the expected point a coordinate may lie, in millimetres: adapters may print four decimals.
const NEAR: f64 = 0.001;
/// How many programs are in flight in the test of that.
const MANY: u64 = 60;
/// How many blocks the long program has.
const LONG: usize = 5000;

/// Tests a device. After a device that does not answer at all there are no further tests.
pub fn ping(device: &mut dyn Device, profile: &Profile) -> Vec<Finding> {
    let mut findings = vec![Finding { test: "answers one straight move", result: straight(device, profile) }];
    if findings[0].result.is_err() {
        return findings;
    }
    let tests: [(&'static str, Test); 8] = [
        ("coordinates are absolute, in millimetres", absolute),
        ("arcs", arc),
        ("blocks without movement", hold),
        ("rapid traverse", rapid),
        ("the empty program", empty),
        ("compensation", compensation),
        ("several programs in flight", many),
        ("a long program", long),
    ];
    for (test, run) in tests {
        findings.push(Finding { test, result: run(device, profile) });
    }
    findings
}

type Test = fn(&mut dyn Device, &Profile) -> Result<String, String>;

fn point(a: f64, b: f64) -> [Rational; 2] {
    let thousandths = |value: f64| Rational::from(((value * 1000.0).round() as i64, 1000));
    [thousandths(a), thousandths(b)]
}

fn line(a: f64, b: f64) -> Block<Rational> {
    Block::moving(Movement::Line { end: point(a, b) })
}

fn told(device: &mut dyn Device, profile: &Profile, blocks: &[Block<Rational>]) -> Result<Answer, String> {
    let answer = ask(device, &profile.parameters, blocks).map_err(|fault| fault.to_string())?;
    match answer.alarm {
        Some(alarm) => Err(format!("the answer is the alarm {} at block {}", alarm.kind.id(), alarm.block)),
        None => Ok(answer),
    }
}

fn end(step: &Step<f64>) -> Option<[f64; 2]> {
    match step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => Some(end),
        Segment::Hold => None,
    }
}

fn is_near(p: [f64; 2], q: [f64; 2]) -> bool {
    (p[0] - q[0]).abs() <= NEAR && (p[1] - q[1]).abs() <= NEAR
}

/// What a wrong point looks like.
fn guess(found: [f64; 2], wanted: [f64; 2], start: [f64; 2]) -> &'static str {
    let scaled = |factor: f64| [wanted[0] * factor, wanted[1] * factor];
    if is_near(found, [wanted[1], wanted[0]]) {
        "; the two coordinates are in the wrong order"
    } else if is_near(found, [wanted[0] - start[0], wanted[1] - start[1]]) {
        "; it looks like a distance from the start of the move, not like an absolute point"
    } else if is_near(scaled(1.0 / 25.4), found) || is_near(scaled(25.4), found) {
        "; it looks like inches taken for millimetres or the reverse"
    } else if is_near(found, [wanted[0] * 2.0, wanted[1]]) || is_near(found, [wanted[0], wanted[1] * 2.0]) {
        "; it looks like a diameter: every coordinate is a radius value"
    } else {
        ""
    }
}

fn moves(answer: &Answer) -> Vec<&Step<f64>> {
    answer.steps.iter().filter(|step| step.segment != Segment::Hold).collect()
}

fn expect_ends(answer: &Answer, wanted: &[[f64; 2]]) -> Result<(), String> {
    let moves = moves(answer);
    if moves.len() != wanted.len() {
        return Err(format!("{} moves in the answer; the program has {}", moves.len(), wanted.len()));
    }
    let mut start = [0.0, 0.0];
    for (index, (step, wanted)) in moves.iter().zip(wanted).enumerate() {
        let found = end(step).unwrap_or_default();
        if !is_near(found, *wanted) {
            let [a, b] = found;
            let hint = guess(found, *wanted, start);
            return Err(format!("move {index} ends at ({a}, {b}), not at ({}, {}){hint}", wanted[0], wanted[1]));
        }
        if step.block != index {
            let hint = if step.block == index + 1 { "; blocks are counted from 0" } else { "" };
            return Err(format!("the move of block {index} is said to be of block {}{hint}", step.block));
        }
        start = *wanted;
    }
    Ok(())
}

fn straight(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let answer = told(device, profile, &[line(3.0, 7.0)])?;
    expect_ends(&answer, &[[3.0, 7.0]]).map(|()| "one line to (3, 7)".to_owned())
}

fn absolute(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let answer = told(device, profile, &[line(12.345, -6.5), line(12.345, 20.25), line(-1.001, 2.0)])?;
    expect_ends(&answer, &[[12.345, -6.5], [12.345, 20.25], [-1.001, 2.0]])?;
    Ok("three lines end where they are programmed".to_owned())
}

fn arc(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let arc = Movement::Arc {
        end: point(10.0, 30.0),
        centre: Centre::FromStart(point(-10.0, 0.0)),
        direction: Direction::Counterclockwise,
    };
    let answer = told(device, profile, &[line(20.0, 20.0), Block::moving(arc)])?;
    expect_ends(&answer, &[[20.0, 20.0], [10.0, 30.0]])?;
    match moves(&answer)[1].segment {
        Segment::Arc { direction: Direction::Clockwise, .. } => {
            Err("a G03 arc is answered as cw; G03 is ccw, seen from the positive end of the plane's normal".to_owned())
        }
        Segment::Arc { full: true, .. } => Err("a quarter of a turn is answered as a full one".to_owned()),
        Segment::Arc { centre, .. } if is_near(centre, [10.0, 20.0]) => {
            Ok("centre and sense are as they should be".to_owned())
        }
        Segment::Arc { centre: [a, b], .. } => {
            let from_start = is_near([a, b], [-10.0, 0.0]);
            let hint = if from_start { "; it is given from the start of the arc, and has to be absolute" } else { "" };
            Err(format!("the centre is at ({a}, {b}), not at (10, 20){hint}"))
        }
        _ => Err("the arc is answered as a line".to_owned()),
    }
}

fn hold(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let answer = told(device, profile, &[line(1.0, 0.0), Block::empty(), line(2.0, 5.0)])?;
    let kinds: Vec<(usize, bool)> =
        answer.steps.iter().map(|step| (step.block, step.segment == Segment::Hold)).collect();
    if kinds == [(0, false), (1, true), (2, false)] {
        return Ok("a hold stands between the two moves".to_owned());
    }
    Err("a block that moves nothing in the plane has to be answered by a hold with its number, where it is executed"
        .to_owned())
}

fn rapid(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let blocks = [Block { rapid: true, ..line(5.0, 1.0) }, line(6.0, 3.0)];
    let answer = told(device, profile, &blocks)?;
    expect_ends(&answer, &[[5.0, 1.0], [6.0, 3.0]])?;
    match moves(&answer)[..] {
        [first, second] if first.rapid && !second.rapid => Ok("G00 is told from G01".to_owned()),
        _ => Err("\"rapid\" has to be true for the G00 move and false for the G01 move".to_owned()),
    }
}

fn empty(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    match told(device, profile, &[])?.steps.len() {
        0 => Ok("no steps".to_owned()),
        count => Err(format!("{count} steps; a program without blocks has none")),
    }
}

fn compensation(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let on =
        Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(Rational::from(2)), ..line(10.0, 0.0) };
    let off = Block { compensation: Some(Compensation::Off), ..line(40.0, 0.0) };
    let blocks = [on, line(20.0, 0.0), line(30.0, 0.0), off];
    let answer = match ask(device, &profile.parameters, &blocks) {
        Err(DeviceFault::Unsupported(reason)) => return Ok(format!("not supported: {reason}")),
        Err(fault) => return Err(fault.to_string()),
        Ok(answer) => answer,
    };
    if let Some(alarm) = answer.alarm {
        return Err(format!("the alarm {} on a straight contour", alarm.kind.id()));
    }
    // On a straight contour the tool's centre passes (20, 2), whatever the control.
    let at = |wanted: [f64; 2]| moves(&answer).iter().any(|step| end(step).is_some_and(|end| is_near(end, wanted)));
    match [2.0, -2.0, 1.0, 4.0, 0.0].map(|height| at([20.0, height])) {
        [true, ..] => Ok("G41 with a radius of 2 mm runs 2 mm to the left".to_owned()),
        [_, true, ..] => Err("G41 runs on the right of the contour; it has to run on the left".to_owned()),
        [_, _, true, ..] => Err("the offset is half the radius: the radius was taken for a diameter".to_owned()),
        [_, _, _, true, _] => Err("the offset is twice the radius".to_owned()),
        [.., true] => Err("the path is the programmed contour: compensation was not switched on".to_owned()),
        _ => Err("G41 along X with a radius of 2 mm does not pass (20, 2)".to_owned()),
    }
}

fn many(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let programs: Vec<_> = (0..MANY).map(|number| generate::program(1, number, Reach::of(profile))).collect();
    let start = Instant::now();
    let together = device.answer_all(&profile.parameters, &programs);
    let seconds = start.elapsed().as_secs_f64();
    let mut unsupported = 0;
    for (number, (program, answer)) in programs.iter().zip(&together).enumerate() {
        match answer {
            Err(DeviceFault::Unsupported(_)) => unsupported += 1,
            Err(fault) => return Err(format!("program {number} of {MANY}: {fault}")),
            Ok(answer) if number % 6 == 0 => match ask(device, &profile.parameters, program) {
                Ok(alone) if alone == *answer => {}
                _ => {
                    return Err(format!(
                        "program {number} of {MANY} is answered otherwise when it is asked again, alone"
                    ));
                }
            },
            Ok(_) => {}
        }
    }
    let rate = MANY as f64 / seconds.max(1e-9);
    let aside = if unsupported == 0 { String::new() } else { format!(", {unsupported} not supported") };
    Ok(format!("{MANY} programs answered{aside}, {rate:.0} a second"))
}

fn long(device: &mut dyn Device, profile: &Profile) -> Result<String, String> {
    let wanted: Vec<[f64; 2]> = (1..=LONG).map(|index| [index as f64, (index % 2) as f64]).collect();
    let blocks: Vec<_> = wanted.iter().map(|[a, b]| line(*a, *b)).collect();
    let answer = told(device, profile, &blocks)?;
    expect_ends(&answer, &wanted).map(|()| format!("{LONG} blocks"))
}
