//! The one table of profile parameters: what a file may say, and where its value goes.

use crate::clause::{self, Clause};
use crate::parameters::{
    Activation, Cancel, CornerCodes, CornerOwner, Dummy, MOST_NON_MOVING, Measure, OuterCorner, Plane, Ratio, Reversal,
    ReversedPath, SideChange, SideChangeAfterStartUp, StartUp, StartUpLost,
};
use crate::profile::Profile;

/// A parameter of a profile.
pub struct Parameter {
    /// Table and name, such as `compensation.corner-owner`.
    pub key: &'static str,
    /// What the parameter decides.
    pub meaning: &'static str,
    /// The clause that says what it does.
    pub clause: Clause,
    /// What a file may give it, and the field that takes it.
    pub(super) values: Values,
}

/// The values of a parameter.
pub(super) enum Values {
    /// One of some words.
    Word {
        /// The words.
        words: fn() -> Vec<&'static str>,
        /// Puts the value that a word names into its field; false if no value has that name.
        set: fn(&mut Profile, &str) -> bool,
    },
    /// A whole number from 0.
    Count {
        /// The greatest.
        most: u8,
        /// Its field.
        field: fn(&mut Profile) -> &mut u8,
    },
    /// A decimal, written as a string so that it stays exact.
    Decimal {
        /// Whether 0 is refused.
        positive: bool,
        /// Its field.
        field: fn(&mut Profile) -> &mut Ratio,
    },
}

impl Parameter {
    /// The table of the file that the parameter stands in: `machine`, `activation` or `compensation`.
    pub fn table(&self) -> &'static str {
        self.key.split_once('.').map_or(self.key, |(table, _)| table)
    }

    /// The name within its table.
    pub fn name(&self) -> &'static str {
        self.key.split_once('.').map_or(self.key, |(_, name)| name)
    }

    /// The allowed values, for people.
    pub fn allowed(&self) -> String {
        match &self.values {
            Values::Word { words, .. } => words().iter().map(|word| format!("{word:?}")).collect::<Vec<_>>().join(", "),
            Values::Count { most, .. } => format!("a whole number from 0 to {most}"),
            Values::Decimal { positive, .. } => {
                let least = if *positive { "greater than 0" } else { "0 or greater" };
                format!("a decimal in quotes, {least}, such as \"0.001\"")
            }
        }
    }
}

/// The words of an enumeration of [`crate::parameters`], and the field that takes its value.
macro_rules! word {
    ($type:ident, $($field:tt)+) => {
        Values::Word {
            words: || $type::VALUES.iter().map(|(word, _)| *word).collect(),
            set: |profile, word| match $type::VALUES.iter().find(|(id, _)| *id == word) {
                Some((_, value)) => {
                    profile.$($field)+ = *value;
                    true
                }
                None => false,
            },
        }
    };
}

/// Every parameter, in the order of the tables in a profile file.
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        key: "machine.plane",
        meaning: "plane in force when a program starts",
        clause: clause::TRC_PLANE_01,
        values: word!(Plane, machine.plane),
    },
    Parameter {
        key: "machine.x-words",
        meaning: "X words measure a radius or a diameter",
        clause: clause::TRC_PLANE_03,
        values: word!(Measure, machine.x_words),
    },
    Parameter {
        key: "machine.least-increment",
        meaning: "least input increment, in millimetres",
        clause: clause::TRC_MODE_07,
        values: Values::Decimal { positive: true, field: |profile| &mut profile.machine.least_increment },
    },
    Parameter {
        key: "machine.dummy",
        meaning: "words that form a dummy block",
        clause: clause::TRC_DUMMY_01,
        values: word!(Dummy, machine.dummy),
    },
    Parameter {
        key: "machine.dummy-first-axis",
        meaning: "the I word of a dummy block measures a radius or a diameter",
        clause: clause::TRC_DUMMY_05,
        values: word!(Measure, machine.dummy_first_axis),
    },
    Parameter {
        key: "machine.corner-codes",
        meaning: "codes that choose the outer corner",
        clause: clause::TRC_CORNER_11,
        values: word!(CornerCodes, machine.corner_codes),
    },
    Parameter {
        key: "activation.G40",
        meaning: "what G40 means for compensation",
        clause: clause::TRC_PLANE_05,
        values: word!(Activation, activation[0]),
    },
    Parameter {
        key: "activation.G41",
        meaning: "what G41 means for compensation",
        clause: clause::TRC_PLANE_05,
        values: word!(Activation, activation[1]),
    },
    Parameter {
        key: "activation.G42",
        meaning: "what G42 means for compensation",
        clause: clause::TRC_PLANE_05,
        values: word!(Activation, activation[2]),
    },
    Parameter {
        key: "activation.G43",
        meaning: "what G43 means for compensation",
        clause: clause::TRC_PLANE_05,
        values: word!(Activation, activation[3]),
    },
    Parameter {
        key: "activation.G44",
        meaning: "what G44 means for compensation",
        clause: clause::TRC_PLANE_05,
        values: word!(Activation, activation[4]),
    },
    Parameter {
        key: "compensation.start-up",
        meaning: "vector that start-up ends on",
        clause: clause::TRC_START_02,
        values: word!(StartUp, parameters.start_up),
    },
    Parameter {
        key: "compensation.start-up-lost",
        meaning: "start-up whose next element is beyond the look-ahead",
        clause: clause::TRC_START_04,
        values: word!(StartUpLost, parameters.start_up_lost),
    },
    Parameter {
        key: "compensation.cancel",
        meaning: "vector that cancel starts from",
        clause: clause::TRC_CANCEL_01,
        values: word!(Cancel, parameters.cancel),
    },
    Parameter {
        key: "compensation.outer-corner",
        meaning: "outer corner in force when a program starts",
        clause: clause::TRC_CORNER_11,
        values: word!(OuterCorner, parameters.outer_corner),
    },
    Parameter {
        key: "compensation.reversal",
        meaning: "exact reversal of direction",
        clause: clause::TRC_CORNER_09,
        values: word!(Reversal, parameters.reversal),
    },
    Parameter {
        key: "compensation.side-change",
        meaning: "change of side in offset mode",
        clause: clause::TRC_SIDE_02,
        values: word!(SideChange, parameters.side_change),
    },
    Parameter {
        key: "compensation.side-change-after-start-up",
        meaning: "change of side at the first element after start-up",
        clause: clause::TRC_SIDE_04,
        values: word!(SideChangeAfterStartUp, parameters.side_change_after_start_up),
    },
    Parameter {
        key: "compensation.non-moving-allowed",
        meaning: "blocks without movement that look-ahead sees past",
        clause: clause::TRC_LOOK_02,
        values: Values::Count { most: MOST_NON_MOVING, field: |profile| &mut profile.parameters.non_moving_allowed },
    },
    Parameter {
        key: "compensation.corner-owner",
        meaning: "block that the moves of a corner belong to",
        clause: clause::TRC_CORNER_12,
        values: word!(CornerOwner, parameters.corner_owner),
    },
    Parameter {
        key: "compensation.reversed-path",
        meaning: "tool path that would run backwards along its block",
        clause: clause::TRC_WEDGE_02,
        values: word!(ReversedPath, parameters.reversed_path),
    },
    Parameter {
        key: "compensation.arc-end-tolerance",
        meaning: "allowed difference of an arc's two radii, in millimetres",
        clause: clause::TRC_ARC_03,
        values: Values::Decimal { positive: false, field: |profile| &mut profile.parameters.arc_end_tolerance },
    },
    Parameter {
        key: "compensation.far-intersection",
        meaning: "distance of an intersection that is advised, in tool radii",
        clause: clause::TRC_WEDGE_01,
        values: Values::Decimal { positive: false, field: |profile| &mut profile.parameters.far_intersection },
    },
];
