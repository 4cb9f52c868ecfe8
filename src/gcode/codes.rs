//! The G and M codes that are accepted, with what they mean or why they mean nothing for the geometry.

use std::fmt;

use radcomp_spec::parameters::{CornerCodes, Plane};
use radcomp_spec::{AlarmKind, Approach, Direction, OuterCorner};

use super::word::NAMED;

/// A code that is accepted.
#[derive(Debug)]
pub(super) struct Code {
    /// G or M; [`NAMED`] of a code that is a word.
    pub(super) letter: char,
    /// Its number; 0 of a code that is a word.
    pub(super) number: u32,
    /// Codes of one group exclude each other in a block.
    pub(super) group: Group,
    /// What the reader does with it.
    pub(super) meaning: Meaning,
    /// What it says; of a code without a meaning here, why the geometry does not need it.
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
    Approach,
    Vector,
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
    /// M96, M97, G450 or G451: which codes they are, and the outer corner.
    Corner(CornerCodes, OuterCorner),
    /// NORM or KONT ([TRC-START-12]).
    Approach(Approach),
    /// G38 ([TRC-VEC-01]).
    HeldVector,
    /// G39 ([TRC-VEC-01]).
    CornerArc,
    /// G04.
    Dwell,
    /// G50: with S and without axis words it limits the spindle speed; a lathe sets coordinates with it.
    SpindleLimit,
    /// A code that is refused outside offset mode, and in it unless the profile has this alarm for it ([TRC-MODE-08]).
    NotInMode(AlarmKind),
    /// M06 ([TRC-MODE-08]).
    ToolChange,
    /// M00 or M01 ([TRC-LOOK-08]).
    Stop,
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

/// A cycle code: one of those that a profile may have an alarm for in mode.
const fn cycle(number: u32) -> Code {
    g(number, Group::CannedCycle, Meaning::NotInMode(AlarmKind::CannedCycleInMode), "canned cycles")
}

const fn not_in_mode(number: u32, alarm: AlarmKind, reason: &'static str) -> Code {
    g(number, Group::NonModal, Meaning::NotInMode(alarm), reason)
}

/// Every code that is accepted, somewhere.
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
    not_in_mode(28, AlarmKind::ReferenceReturnInMode,   "reference points"),
    not_in_mode(29, AlarmKind::ReferenceReturnInMode,   "reference points"),
    not_in_mode(30, AlarmKind::ReferenceReturnInMode,   "reference points"),
    g(38, Group::Vector,       Meaning::HeldVector,            "a vector held, or a new one"),
    g(39, Group::Vector,       Meaning::CornerArc,             "corner arc"),
    g(40, Group::Compensation, Meaning::Compensation(0),       "as the profile declares"),
    g(41, Group::Compensation, Meaning::Compensation(1),       "as the profile declares"),
    g(42, Group::Compensation, Meaning::Compensation(2),       "as the profile declares"),
    g(43, Group::Compensation, Meaning::Compensation(3),       "as the profile declares"),
    g(44, Group::Compensation, Meaning::Compensation(4),       "as the profile declares"),
    g(49, Group::ToolLength,   Meaning::Nothing,               "cancels a tool length offset; none can be in force"),
    g(50, Group::NonModal,     Meaning::SpindleLimit,          "with S alone it limits the spindle speed"),
    not_in_mode(53, AlarmKind::MachineCoordinatesInMode, "machine coordinates"),
    g(54, Group::WorkOffset,   Meaning::Nothing,               "the first work offset, in whose coordinates everything is; no other is accepted"),
    cycle(70), cycle(71), cycle(72), cycle(73), cycle(74), cycle(75), cycle(76), cycle(77), cycle(78), cycle(79),
    g(80, Group::CannedCycle,  Meaning::Nothing,               "cancels a canned cycle; none can be in force"),
    cycle(81), cycle(82), cycle(83), cycle(84), cycle(85), cycle(86), cycle(87), cycle(88), cycle(89),
    g(90, Group::Distance,     Meaning::Incremental(false),    "absolute coordinates"),
    g(91, Group::Distance,     Meaning::Incremental(true),     "incremental coordinates"),
    not_in_mode(92, AlarmKind::SetCoordinatesInMode, "shifted coordinates, threads"),
    g(94, Group::Feed,         Meaning::Nothing,               "feed for each minute: speed, not path"),
    g(95, Group::Feed,         Meaning::Nothing,               "feed for each turn: speed, not path"),
    g(96, Group::Speed,        Meaning::Nothing,               "constant surface speed: speed, not path"),
    g(97, Group::Speed,        Meaning::Nothing,               "constant spindle speed: speed, not path"),
    g(98, Group::FeedOrReturn, Meaning::Nothing,               "feed of a lathe, or return level of canned cycles, which are not accepted"),
    g(99, Group::FeedOrReturn, Meaning::Nothing,               "feed of a lathe, or return level of canned cycles, which are not accepted"),
    g(450, Group::Corner,      Meaning::Corner(CornerCodes::G450G451, OuterCorner::Arc),        "outer corners by an arc"),
    g(451, Group::Corner,      Meaning::Corner(CornerCodes::G450G451, OuterCorner::LimitAngle), "outer corners by intersection down to a limit angle"),
    m( 0, Group::Stop,         Meaning::Stop,                  "program stop: no movement"),
    m( 1, Group::Stop,         Meaning::Stop,                  "optional stop: no movement"),
    m( 2, Group::Stop,         Meaning::End,                   "end of program"),
    m( 3, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 4, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 5, Group::Spindle,      Meaning::Nothing,               "spindle: no movement"),
    m( 6, Group::ToolChange,   Meaning::ToolChange,            "tool change: taken to come back to the same point"),
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
    m(96, Group::Corner,       Meaning::Corner(CornerCodes::M96M97, OuterCorner::Arc),          "outer corners by an arc"),
    m(97, Group::Corner,       Meaning::Corner(CornerCodes::M96M97, OuterCorner::Intersection), "outer corners by intersection"),
];

/// The codes that are words.
static NAMED_CODES: [(&str, Code); 2] = [
    ("NORM", approach(Approach::Norm, "start-up and cancel at right angles")),
    ("KONT", approach(Approach::Kont, "start-up and cancel round the contour's point")),
];

const fn approach(approach: Approach, reason: &'static str) -> Code {
    Code { letter: NAMED, number: 0, group: Group::Approach, meaning: Meaning::Approach(approach), reason }
}

/// The code that is this word.
pub(super) fn named(name: &str) -> Option<&'static Code> {
    NAMED_CODES.iter().find(|(known, _)| *known == name).map(|(_, code)| code)
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, _)) = NAMED_CODES.iter().find(|(_, code)| code.meaning == self.meaning) {
            return f.write_str(name);
        }
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
