//! The G and M codes that are accepted, with what they mean or why they mean nothing for the geometry.

use std::fmt;

use radcomp_spec::parameters::Plane;
use radcomp_spec::{Direction, OuterCorner};

/// A code that is accepted.
#[derive(Debug)]
pub(super) struct Code {
    /// G or M.
    pub(super) letter: char,
    /// Its number.
    pub(super) number: u32,
    /// Codes of one group exclude each other in a block.
    pub(super) group: Group,
    /// What the reader does with it.
    pub(super) meaning: Meaning,
    /// What it says; of a code without a meaning here, why the geometry does not need it.
    #[cfg_attr(
        not(test),
        expect(dead_code, reason = "the reason of each line of the table is for its readers and its test")
    )]
    pub(super) reason: &'static str,
}

/// The modal groups; also what excludes each other without being modal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Group {
    Motion,
    Plane,
    Units,
    Distance,
    Compensation,
    ToolLength,
    WorkOffset,
    CannedCycle,
    Feed,
    Speed,
    FeedOrReturn,
    NonModal,
    Stop,
    Spindle,
    ToolChange,
    Coolant,
    Gear,
    Corner,
}

/// What the reader does with a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// Which way the axes move.
    Motion(Motion),
    /// Choice of plane.
    Plane(Plane),
    /// Inches, or else millimetres.
    Inches(bool),
    /// Incremental, or else absolute.
    Incremental(bool),
    /// G40 and the number of codes after it: what it means stands in the profile's activation table.
    Compensation(usize),
    /// M96 or M97.
    Corner(OuterCorner),
    /// G04.
    Dwell,
    /// G50: accepted with S and without axis words only.
    SpindleLimit,
    /// M02 or M30.
    End,
    /// Nothing for the geometry.
    Nothing,
}

/// The motion codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Motion {
    /// G00.
    Rapid,
    /// G01.
    Feed,
    /// G02, G03.
    Arc(Direction),
}

const fn g(number: u32, group: Group, meaning: Meaning, reason: &'static str) -> Code {
    Code { letter: 'G', number, group, meaning, reason }
}

const fn m(number: u32, group: Group, meaning: Meaning, reason: &'static str) -> Code {
    Code { letter: 'M', number, group, meaning, reason }
}

/// Every code that is accepted.
#[rustfmt::skip]
pub(super) const CODES: &[Code] = &[
    g( 0, Group::Motion,       Meaning::Motion(Motion::Rapid), "rapid traverse; moves are taken to be straight"),
    g( 1, Group::Motion,       Meaning::Motion(Motion::Feed),  "straight move"),
    g( 2, Group::Motion,       Meaning::Motion(Motion::Arc(Direction::Clockwise)),        "clockwise arc"),
    g( 3, Group::Motion,       Meaning::Motion(Motion::Arc(Direction::Counterclockwise)), "counter-clockwise arc"),
    g( 4, Group::NonModal,     Meaning::Dwell,                 "dwell"),
    g(17, Group::Plane,        Meaning::Plane(Plane::Xy),      "plane (X, Y)"),
    g(18, Group::Plane,        Meaning::Plane(Plane::Zx),      "plane (Z, X)"),
    g(19, Group::Plane,        Meaning::Plane(Plane::Yz),      "plane (Y, Z)"),
    g(20, Group::Units,        Meaning::Inches(true),          "inches"),
    g(21, Group::Units,        Meaning::Inches(false),         "millimetres"),
    g(40, Group::Compensation, Meaning::Compensation(0),       "as the profile declares"),
    g(41, Group::Compensation, Meaning::Compensation(1),       "as the profile declares"),
    g(42, Group::Compensation, Meaning::Compensation(2),       "as the profile declares"),
    g(43, Group::Compensation, Meaning::Compensation(3),       "as the profile declares"),
    g(44, Group::Compensation, Meaning::Compensation(4),       "as the profile declares"),
    g(49, Group::ToolLength,   Meaning::Nothing,               "cancels a tool length offset; none can be in force"),
    g(50, Group::NonModal,     Meaning::SpindleLimit,          "with S alone it limits the spindle speed"),
    g(54, Group::WorkOffset,   Meaning::Nothing,               "the first work offset, in whose coordinates everything is; no other is accepted"),
    g(80, Group::CannedCycle,  Meaning::Nothing,               "cancels a canned cycle; none can be in force"),
    g(90, Group::Distance,     Meaning::Incremental(false),    "absolute coordinates"),
    g(91, Group::Distance,     Meaning::Incremental(true),     "incremental coordinates"),
    g(94, Group::Feed,         Meaning::Nothing,               "feed for each minute: speed, not path"),
    g(95, Group::Feed,         Meaning::Nothing,               "feed for each turn: speed, not path"),
    g(96, Group::Speed,        Meaning::Nothing,               "constant surface speed: speed, not path"),
    g(97, Group::Speed,        Meaning::Nothing,               "constant spindle speed: speed, not path"),
    g(98, Group::FeedOrReturn, Meaning::Nothing,               "feed of a lathe, or return level of canned cycles, which are not accepted"),
    g(99, Group::FeedOrReturn, Meaning::Nothing,               "feed of a lathe, or return level of canned cycles, which are not accepted"),
    m( 0, Group::Stop,         Meaning::Nothing,               "program stop: no movement"),
    m( 1, Group::Stop,         Meaning::Nothing,               "optional stop: no movement"),
    m( 2, Group::Stop,         Meaning::End,                   "end of program"),
    m( 3, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 4, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 5, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 6, Group::ToolChange,   Meaning::Nothing,               "tool change: taken to come back to the same point"),
    m( 7, Group::Coolant,      Meaning::Nothing,               "coolant: no movement"),
    m( 8, Group::Coolant,      Meaning::Nothing,               "coolant: no movement"),
    m( 9, Group::Coolant,      Meaning::Nothing,               "coolant: no movement"),
    m(30, Group::Stop,         Meaning::End,                   "end of program"),
    m(40, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(41, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(42, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(43, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(44, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(45, Group::Gear,         Meaning::Nothing,               "spindle gear: no movement"),
    m(96, Group::Corner,       Meaning::Corner(OuterCorner::Arc),          "outer corners by an arc"),
    m(97, Group::Corner,       Meaning::Corner(OuterCorner::Intersection), "outer corners by intersection"),
];

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{:02}", self.letter, self.number)
    }
}

/// The code of this letter and number, if it is accepted.
pub(super) fn find(letter: char, number: u32) -> Option<&'static Code> {
    CODES.iter().find(|code| code.letter == letter && code.number == number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_holds_each_code_once_with_a_reason() {
        for (index, code) in CODES.iter().enumerate() {
            assert!(!code.reason.is_empty());
            let twice = CODES[..index].iter().any(|other| (other.letter, other.number) == (code.letter, code.number));
            assert!(!twice, "{code:?}");
        }
    }
}
