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
