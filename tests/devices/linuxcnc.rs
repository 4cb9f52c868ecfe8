//! The real `rs274` of LinuxCNC, on programs whose paths are worked out by hand.
//!
//! LinuxCNC's rules: the first move ends at right angles to itself; an outer corner is an arc about it, which runs with the
//! feed of the next block; an inner corner is the meeting point of the two offset contours.

use std::ffi::OsString;
use std::process::Command;
use std::sync::LazyLock;

use radcomp::certify::programs;
use radcomp::device::linuxcnc::LinuxCnc;
use radcomp::device::pipe::Limits;
use radcomp::device::{Answer, Device, DeviceFault};
use radcomp::gcode::{Tools, read};
use radcomp::judge::Grade;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, AlarmKind, Block, Direction, Segment};
use rug::Rational;

use super::{limits, repository};

/// The interpreter in `$RS274`, or Debian's.
pub static RS274: LazyLock<OsString> = LazyLock::new(|| {
    std::env::var_os("RS274").unwrap_or_else(|| {
        let output = Command::new(repository("scripts/linuxcnc")).output().expect("scripts/linuxcnc runs");
        assert!(output.status.success(), "no rs274: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("a path").trim_end().into()
    })
});

fn device(profile: &str) -> LinuxCnc {
    let patient = Limits { timeout: std::time::Duration::from_secs(20), ..limits() };
    LinuxCnc::run(RS274.clone(), &Profile::builtin(profile).unwrap(), patient).unwrap()
}

fn blocks(profile: &str, program: &str) -> Vec<Block<Rational>> {
    let tools = Tools::empty().with_radius(1, Rational::from(2)).with_radius(2, Rational::from(1));
    let program = read("program", program.as_bytes(), &Profile::builtin(profile).unwrap(), &tools);
    program.unwrap_or_else(|error| panic!("{error}")).blocks.into_iter().map(|read| read.block).collect()
}

fn answer(program: &str) -> Result<Answer, DeviceFault> {
    let profile = Profile::builtin("seed-mill").unwrap();
    device("seed-mill").answer(&profile.parameters, &blocks("seed-mill", program))
}

/// The steps of an answer: block, kind, end, and the centre of an arc, rounded to a millionth.
fn told(answer: &Answer) -> Vec<String> {
    let point = |[a, b]: [f64; 2]| {
        let [a, b] = [a, b].map(|value| (value * 1e6).round() / 1e6 + 0.0);
        format!("{a} {b}")
    };
    let steps = answer.steps.iter().map(|step| match step.segment {
        Segment::Hold => format!("{} hold", step.block),
        Segment::Line { end } if step.rapid => format!("{} rapid {}", step.block, point(end)),
        Segment::Line { end } => format!("{} line {}", step.block, point(end)),
        Segment::Arc { end, centre, direction, full } => {
            let sense = if direction == Direction::Clockwise { "cw" } else { "ccw" };
            let full = if full { " full" } else { "" };
            format!("{} {sense}{full} {} about {}", step.block, point(end), point(centre))
        }
    });
    steps.collect()
}

#[track_caller]
fn runs(program: &str, path: &[&str]) {
    let answer = answer(program).unwrap();
    assert_eq!(told(&answer), path);
    assert_eq!(answer.alarm, None);
}

#[track_caller]
fn stops(program: &str, path: &[&str], block: usize, kind: AlarmKind) {
    let answer = answer(program).unwrap();
    assert_eq!(told(&answer), path);
    assert_eq!(answer.alarm, Some(Alarm { block, kind }));
}

#[test]
fn an_inner_and_an_outer_corner() {
    runs(
        "G41 D1 G01 X10 Y0\nX20\nY10\nX30\nG40 X40\n",
        &["0 line 10 2", "1 line 18 2", "2 line 18 10", "3 cw 20 12 about 20 10", "3 line 30 12", "4 line 40 10"],
    );
}

#[test]
fn the_right_side_is_the_mirror_image() {
    runs(
        "G42 D1 G01 X10 Y0\nX20\nY-10\nX30\nG40 X40\n",
        &[
            "0 line 10 -2",
            "1 line 18 -2",
            "2 line 18 -10",
            "3 ccw 20 -12 about 20 -10",
            "3 line 30 -12",
            "4 line 40 -10",
        ],
    );
}

#[test]
fn a_negative_radius_is_the_other_side() {
    let profile = Profile::builtin("seed-mill").unwrap();
    let tools = Tools::empty().with_radius(1, Rational::from(-2));
    let program = read("program", &b"G41 D1 G01 X10 Y0\nX20\nY-10\nX30\nG40 X40\n"[..], &profile, &tools).unwrap();
    let blocks: Vec<_> = program.blocks.into_iter().map(|read| read.block).collect();
    let answer = device("seed-mill").answer(&profile.parameters, &blocks).unwrap();
    assert_eq!(told(&answer)[..2], ["0 line 10 -2", "1 line 18 -2"]);
}

#[test]
fn numbers_have_all_their_digits() {
    // The lines y = 1 and y = x - 10 + √2 meet at x = 11 - √2.
    let answer = answer("G41 D2 G01 X5 Y0\nX10\nX20 Y10\nG40 X30 Y20\n").unwrap();
    let Segment::Line { end: [x, y] } = answer.steps[1].segment else { panic!("{answer:?}") };
    assert!((x - (11.0 - 2_f64.sqrt())).abs() < 1e-13 && (y - 1.0).abs() < 1e-13, "({x:?}, {y:?})");
}

#[test]
fn blocks_without_movement_are_executed_between_their_neighbours() {
    runs(
        "G04 P0\nG41 D1 G01 X10 Y0\nG04 P0\nX20\nG04 P0\nG04 P0\nY10\nG40 X40\n",
        &["0 hold", "1 line 10 2", "2 hold", "3 line 18 2", "4 hold", "5 hold", "6 line 18 10", "7 line 40 10"],
    );
}

#[test]
fn a_move_of_no_length_is_no_movement() {
    // The interpreter prints such a move too, where it stands; it has no length.
    runs("G01 X10 Y0\nX10\nX20\n", &["0 line 10 0", "1 hold", "1 line 10 0", "2 line 20 0"]);
}

#[test]
fn a_whole_circle_inside() {
    runs(
        "G41 D2 G01 X10 Y0\nG03 X10 Y0 I0 J5\nG01 X20\nG40 X30\n",
        &["0 line 10 1", "1 ccw full 10 1 about 10 5", "2 line 20 1", "3 line 30 0"],
    );
}

#[test]
fn an_arc_is_concentric() {
    // A quarter of a turn about (10, 10), the tool outside: 10 + 2.
    runs(
        "G42 D1 G01 X5 Y0\nX10\nG03 X20 Y10 I0 J10\nG01 Y20\nG40 Y30\n",
        &["0 line 5 -2", "1 line 10 -2", "2 ccw 22 10 about 10 10", "3 line 22 20", "4 line 20 30"],
    );
}

#[test]
fn rapid_moves_are_told_from_feed_moves() {
    runs("G00 X10 Y5\nG01 X20\nG00 X0 Y0\n", &["0 rapid 10 5", "1 line 20 5", "2 rapid 0 0"]);
}

#[test]
fn the_plane_of_a_lathe() {
    // In (Z, X), as in (X, Y) above.
    let program = "G01 Z10 X0\nG41 T0101 Z20\nZ30\nX20\nZ40\nG40 Z50\n";
    let profile = Profile::builtin("yasnac-lx").unwrap();
    let blocks = blocks("yasnac-lx", program);
    let answer = device("yasnac-lx").answer(&profile.parameters, &blocks).unwrap();
    let path = [
        "0 line 10 0",
        "1 line 20 2",
        "2 line 28 2",
        "3 line 28 10",
        "4 cw 30 12 about 30 10",
        "4 line 40 12",
        "5 line 50 10",
    ];
    assert_eq!(told(&answer), path);
}

#[test]
fn an_error_ends_the_path_and_loses_the_move_that_was_held_back() {
    stops("G41 D1 G01 X10 Y0\nX20\nG42 Y20\nX40\n", &["0 line 10 2"], 2, AlarmKind::SideChangeForbidden);
}

#[test]
fn errors_are_alarms_at_their_block() {
    stops("G01 X10\nG03 X20 Y0 I4 J0\n", &["0 line 10 0"], 1, AlarmKind::EndOffArc);
    stops("G01 X10\nG04 P0\nG03 X10 Y0 I0 J0\n", &["0 line 10 0", "1 hold"], 2, AlarmKind::CentreAtEnd);
    stops("G01 X10\nG03 X20 Y0 R1\n", &["0 line 10 0"], 1, AlarmKind::NoSuchArc);
    stops("G41 D1 G01 X10 Y0\nG03 X10 Y2 I0 J1\nG01 X0\n", &[], 1, AlarmKind::RadiusTooSmall);
    stops("G41 D1 G01 X1 Y0\nX20\nG40 X30\n", &[], 0, AlarmKind::EntryTooShort);
    stops(
        "G41 D1 G01 X10 Y0\nX20\nG40\nG02 X30 Y0 I5 J0\n",
        &["0 line 10 2", "1 line 20 2", "2 hold"],
        3,
        AlarmKind::ArcAtCancel,
    );
    // A line and an arc whose offsets do not meet, told as of an arc before.
    let narrow = "G42 D2 G01 X6 Y-8\nX9 Y-12\nG02 X7.85 Y-11.42 R-1.001\nG40 G01 X9 Y0\n";
    stops(narrow, &["0 line 5.2 -8.6"], 2, AlarmKind::NoIntersection);
    // The last move is looked at when the program ends.
    stops("G41 D1 G01 X10 Y0\nX20\nY1\n", &["0 line 10 2", "1 line 18 2"], 2, AlarmKind::ReversedLine);
    // A step of 1 mm is too short for a tool of 2 mm: it would run backwards.
    stops("G41 D1 G01 X10 Y0\nX11\nY20\nX30\n", &["0 line 10 2"], 1, AlarmKind::ReversedLine);
}

#[test]
fn another_radius_in_mode_is_refused() {
    stops("G41 D1 G01 X10 Y0\nX20\nD2 X30\nX40\n", &["0 line 10 2"], 2, AlarmKind::OffsetChangedInMode);
    runs("G41 D1 G01 X10 Y0\nG40 D2 X20\nG41 X30\n", &["0 line 10 2", "1 line 20 0", "2 line 30 1"]);
}

#[test]
fn what_it_has_no_words_for_is_not_asked() {
    let fault = answer("G41 D1 G01 X10 Y0\nI1 J0\nX20\n").unwrap_err();
    assert_eq!(fault.id(), "unsupported", "{fault}");
}

#[test]
fn one_programs_error_does_not_reach_the_next() {
    let profile = Profile::builtin("seed-mill").unwrap();
    let texts = ["G41 D1 G01 X10 Y0\nX20\nG42 Y20\nX40\nX50\n", "G41 D1 G01 X10 Y0\nX20\n", "G01 X7 Y1\n"];
    let programs: Vec<_> = texts.iter().cycle().take(60).map(|text| blocks("seed-mill", text)).collect();
    let answers = device("seed-mill").answer_all(&profile.parameters, &programs);
    for (index, answer) in answers.iter().enumerate() {
        let path: &[&str] = [&["0 line 10 2"][..], &["0 line 10 2", "1 line 20 2"], &["0 line 7 1"]][index % 3];
        assert_eq!(told(answer.as_ref().unwrap()), path);
    }
}

#[test]
fn an_interpreter_that_is_not_there_is_told() {
    let profile = Profile::builtin("seed-mill").unwrap();
    let mut device = LinuxCnc::run("no-such-rs274".into(), &profile, limits()).unwrap();
    let fault = device.answer(&profile.parameters, &blocks("seed-mill", "G01 X1\n")).unwrap_err();
    assert!(fault.text().contains("no such command"), "{fault}");
}

#[test]
fn programs_are_answered_by_the_hundred_and_more_a_second() {
    let profile = Profile::builtin("seed-mill").unwrap();
    let programs: Vec<_> = programs(&profile, 1, 6000, Grade::Binary64).map(|(_, blocks)| blocks).collect();
    let mut device = device("seed-mill");
    // Starting up is not counted.
    assert!(device.answer(&profile.parameters, &blocks("seed-mill", "G01 X1\n")).is_ok());
    let start = std::time::Instant::now();
    let answers: Vec<_> = programs.chunks(60).flat_map(|chunk| device.answer_all(&profile.parameters, chunk)).collect();
    let asked = answers.iter().filter(|answer| !matches!(answer, Err(DeviceFault::Unsupported(_)))).count();
    let rate = asked as f64 / start.elapsed().as_secs_f64();
    println!("{asked} programs, {rate:.0} a second");
    // A machine that does other work beside is no reason to fail.
    assert!(asked > 2000 && rate > 250.0, "{asked} programs, {rate:.0} a second");
    let text = |fault: &DeviceFault| fault.text().contains("an error that is no alarm here");
    let strange: Vec<_> = answers
        .iter()
        .filter_map(|answer| answer.as_ref().err())
        .filter(|fault| fault.id() != "unsupported" && !text(fault))
        .collect();
    assert_eq!(strange, Vec::<&DeviceFault>::new());
}
