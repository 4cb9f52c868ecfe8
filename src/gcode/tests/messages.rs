//! What is said of what no word, no code and no profile has.

use radcomp_spec::AlarmKind;
use radcomp_spec::profile::Profile;

use super::tools;
use crate::gcode::{Kind, read};

#[test]
fn every_unexpected_character_has_its_message() {
    let profile = Profile::builtin("seed-mill").unwrap();
    for (text, message) in [
        ("G01 X#1", "variables and expressions are not supported"),
        ("G01 *", "variables and expressions are not supported"),
        ("G01 %", "a `%` stands alone in its line"),
        ("G01 /X1", "the `/` of block delete stands first in its line"),
        ("G01 )", "no comment is open here"),
        ("G01 X1 2", "a number needs a letter before it"),
        ("G01 X1 +", "a number needs a letter before it"),
        ("G01 X1 \u{7}", "a control character"),
        ("G01 X1 é", "a word is a letter from A to Z and a number, such as X12.5"),
    ] {
        let fault = read("part.nc", text.as_bytes(), &profile, &tools()).unwrap_err();
        assert_eq!(
            (fault.kind, fault.length, fault.message.as_ref()),
            (Kind::UnexpectedCharacter, 1, message),
            "{text}"
        );
    }
}

/// In offset mode each code asks its own parameter of the profile.
#[test]
fn each_code_that_is_not_for_offset_mode_has_its_own_rule() {
    let codes = [
        ("reference-return", "G28 X0", AlarmKind::ReferenceReturnInMode),
        ("machine-coordinates", "G53 G00 X0", AlarmKind::MachineCoordinatesInMode),
        ("set-coordinates", "G92 X0", AlarmKind::SetCoordinatesInMode),
        ("canned-cycle", "G81 X0 Z0 R0", AlarmKind::CannedCycleInMode),
        ("plane-change", "G18", AlarmKind::PlaneChangeInMode),
    ];
    for (parameter, ..) in codes {
        let profile = Profile::changed("seed-mill", "own", [(parameter, r#""alarm""#)]).unwrap();
        for (other, code, kind) in codes {
            let program = format!("G41 D1 G01 X10\nX20\n{code}\n");
            let read = read("part.nc", program.as_bytes(), &profile, &tools());
            if other == parameter {
                assert_eq!(read.unwrap().blocks[2].block.not_in_mode, Some(kind), "{code}");
            } else {
                assert_eq!(read.unwrap_err().kind, Kind::NotInMode, "{code} where {parameter} alone is an alarm");
            }
        }
    }
}

#[test]
fn an_absent_code_tells_those_that_there_are() {
    let profile = Profile::builtin("seed-mill").unwrap();
    let fault = read("part.nc", b"G43 X1\n", &profile, &tools()).unwrap_err();
    let message = "profile seed-mill has no G43; its codes of compensation are G40, G41, G42";
    assert_eq!((fault.kind, fault.message.as_ref()), (Kind::AbsentCode, message));
}

/// What stands beside a compensation code is refused as such, also where no dummy block is asked for.
#[test]
fn words_that_mean_nothing_beside_a_code_are_refused_with_the_code() {
    let profile = Profile::builtin("fanuc-30i").unwrap();
    let fault = read("part.nc", b"G01 G41 D1 I3 J-4\n", &profile, &tools()).unwrap_err();
    assert_eq!(
        (fault.column, fault.message.as_ref()),
        (12, "profile fanuc-30i gives I, J and K no meaning beside a code of a side at start-up")
    );
}

/// An arc that starts up has started: a vector may follow it that does not move.
#[test]
fn an_arc_starts_up() {
    let values = [("start-up-arc", r#""moved-centre""#), ("side-code-vector", r#""right-angles""#)];
    let profile = Profile::changed("seed-mill", "own", values).unwrap();
    let program = |start: &str| format!("G00 X-20 Y0\nG41 D1 {start}\nG01 G41 I3 J-4\nX20\n");
    let blocks = |start| read("part.nc", program(start).as_bytes(), &profile, &tools()).map(|read| read.blocks);
    assert!(blocks("G03 X10 Y0 R30 F100").unwrap()[2].block.vector.is_some());
    assert_eq!(blocks("F100").unwrap_err().column, 9, "no block has moved");
}
