//! What is said of a character that no word has.

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
