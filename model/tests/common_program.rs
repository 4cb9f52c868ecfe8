//! TV-1: a program that every control answers alike after its entry (NIST Handbook, figure 3), in plane coordinates.

use radcomp_model::run;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Parameters, Segment, Side};
use rug::Rational;

fn rational(text: &str) -> Rational {
    radcomp_model::number::parse_decimal(text).expect("a decimal")
}

fn line(a: &str, b: &str) -> Block<Rational> {
    Block::moving(Movement::Line { end: [rational(a), rational(b)] })
}

fn arc(direction: Direction, a: &str, b: &str, i: &str, j: &str) -> Block<Rational> {
    Block::moving(Movement::Arc {
        end: [rational(a), rational(b)],
        centre: Centre::FromStart([rational(i), rational(j)]),
        direction,
    })
}

fn parameters() -> Parameters {
    Profile::builtin("seed-mill").expect("a built-in profile").parameters
}

#[test]
fn every_control_answers_alike() {
    use Direction::{Clockwise, Counterclockwise};
    let blocks = [
        line("1", "5"),
        Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(rational("0.5")), ..line("1", "4") },
        arc(Counterclockwise, "2", "3", "1", "0"),
        arc(Clockwise, "3", "2", "0", "-1"),
        line("3", "-1"),
        arc(Clockwise, "2", "-2", "-1", "0"),
        line("-2", "-2"),
        arc(Clockwise, "-2.6", "-0.2", "0", "1"),
        line("1.4", "2.8"),
        arc(Clockwise, "2", "3", ".6", "-.8"),
        Block { compensation: Some(Compensation::Off), ..line("2", "5") },
    ];
    let run = run(&parameters(), &blocks);
    assert_eq!(run.alarm, None);
    let ends: Vec<_> = run
        .steps
        .iter()
        .map(|step| match &step.segment {
            Segment::Line { end } => format!("line {} {}", end[0], end[1]),
            Segment::Arc { end, centre, .. } => format!("arc {} {} about {} {}", end[0], end[1], centre[0], centre[1]),
            Segment::Hold => "hold".to_owned(),
        })
        .collect();
    let expected = [
        "line 1 5",
        "line 3/2 4",
        "arc 2 7/2 about 2 4",
        "arc 7/2 2 about 2 2",
        "line 7/2 -1",
        "arc 2 -5/2 about 2 -1",
        "line -2 -5/2",
        "arc -29/10 1/5 about -2 -1",
        "line 11/10 16/5",
        "arc 2 7/2 about 2 2",
        "line 2 5",
    ];
    assert_eq!(ends, expected);
    assert!(run.steps.iter().all(|step| step.main));
}
