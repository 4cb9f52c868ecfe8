//! The one table of profile parameters: what a file may say, and where its value goes.

use crate::clause::{self, Clause};
use crate::parameters::*;
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
    /// A whole number from 0, or `"unbounded"`.
    Count {
        /// The greatest number.
        most: u8,
        /// Its field; none is unbounded.
        field: fn(&mut Profile) -> &mut Option<u8>,
    },
    /// A decimal from 0 to 1, written as a string so that it stays exact.
    Cosine {
        /// Its field.
        field: fn(&mut Profile) -> &mut Ratio,
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
    /// The table of the file that the parameter stands in: `machine`, `activation`, `compensation` or `tips`.
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
            Values::Count { most, .. } => format!("a whole number from 0 to {most}, or \"unbounded\""),
            Values::Cosine { .. } => "a decimal in quotes, from 0 to 1, such as \"0.5\"".to_owned(),
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
        key: "machine.approach-codes",
        meaning: "codes that choose start-up and cancel",
        clause: clause::TRC_START_12,
        values: word!(ApproachCodes, machine.approach_codes),
    },
    Parameter {
        key: "machine.plane-change",
        meaning: "a change of plane in mode",
        clause: clause::TRC_MODE_08,
        values: word!(InMode, machine.plane_change),
    },
    Parameter {
        key: "machine.reference-return",
        meaning: "G28, G29 and G30 in mode",
        clause: clause::TRC_MODE_08,
        values: word!(InMode, machine.reference_return),
    },
    Parameter {
        key: "machine.machine-coordinates",
        meaning: "G53 in mode",
        clause: clause::TRC_MODE_08,
        values: word!(InMode, machine.machine_coordinates),
    },
    Parameter {
        key: "machine.set-coordinates",
        meaning: "G92, or G50 of a lathe, in mode",
        clause: clause::TRC_MODE_08,
        values: word!(InMode, machine.set_coordinates),
    },
    Parameter {
        key: "machine.tool-change",
        meaning: "M06 in mode",
        clause: clause::TRC_MODE_08,
        values: word!(ToolChange, machine.tool_change),
    },
    Parameter {
        key: "machine.canned-cycle",
        meaning: "canned cycles in mode",
        clause: clause::TRC_MODE_08,
        values: word!(InMode, machine.canned_cycle),
    },
    Parameter {
        key: "machine.read-ahead-stop",
        meaning: "M00, M01, M02 and M30 in mode",
        clause: clause::TRC_LOOK_08,
        values: word!(ReadAheadStop, machine.read_ahead_stop),
    },
    Parameter {
        key: "machine.offset-zero",
        meaning: "offset number 0",
        clause: clause::TRC_CANCEL_07,
        values: word!(OffsetZero, machine.offset_zero),
    },
    Parameter {
        key: "machine.vector-codes",
        meaning: "codes that give or hold a vector",
        clause: clause::TRC_VEC_01,
        values: word!(VectorCodes, machine.vector_codes),
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
    Parameter {
        key: "compensation.start-up-b",
        meaning: "what type B passes besides the corner",
        clause: clause::TRC_START_06,
        values: word!(StartUpB, parameters.start_up_b),
    },
    Parameter {
        key: "compensation.start-up-without-movement",
        meaning: "start-up code in a block without movement",
        clause: clause::TRC_START_08,
        values: word!(StartUpWithoutMovement, parameters.start_up_without_movement),
    },
    Parameter {
        key: "compensation.start-up-arc",
        meaning: "arc as start-up block",
        clause: clause::TRC_START_09,
        values: word!(StartUpArc, parameters.start_up_arc),
    },
    Parameter {
        key: "compensation.cancel-without-movement",
        meaning: "G40 in a block without movement",
        clause: clause::TRC_CANCEL_06,
        values: word!(CancelWithoutMovement, parameters.cancel_without_movement),
    },
    Parameter {
        key: "compensation.corner-limit-cosine",
        meaning: "cosine of the smallest angle α that `limit-angle` forms by intersection",
        clause: clause::TRC_CORNER_13,
        values: Values::Cosine { field: |profile| &mut profile.parameters.corner_limit_cosine },
    },
    Parameter {
        key: "compensation.arc-extension",
        meaning: "what stands for an arc beyond its end at an outer corner",
        clause: clause::TRC_CORNER_14,
        values: word!(ArcExtension, parameters.arc_extension),
    },
    Parameter {
        key: "compensation.smallest-corner-cosine",
        meaning: "cosine of the angle α below which type B passes a single vector; 0 is none",
        clause: clause::TRC_CORNER_15,
        values: Values::Cosine { field: |profile| &mut profile.parameters.smallest_corner_cosine },
    },
    Parameter {
        key: "compensation.straight-band-cosine",
        meaning: "cosine of the turn up to which a corner counts as straight; 0 is none",
        clause: clause::TRC_CORNER_16,
        values: Values::Cosine { field: |profile| &mut profile.parameters.straight_band_cosine },
    },
    Parameter {
        key: "compensation.arc-on-rapid",
        meaning: "outer corner by an arc that a rapid block owns",
        clause: clause::TRC_CORNER_17,
        values: word!(ArcOnRapid, parameters.arc_on_rapid),
    },
    Parameter {
        key: "compensation.small-vector-limit",
        meaning: "coordinate difference of corner vectors that is ignored, in millimetres; 0 is none",
        clause: clause::TRC_CORNER_18,
        values: Values::Decimal { positive: false, field: |profile| &mut profile.parameters.small_vector_limit },
    },
    Parameter {
        key: "compensation.same-code",
        meaning: "code of the side in force, given again",
        clause: clause::TRC_MODE_05,
        values: word!(SameCode, parameters.same_code),
    },
    Parameter {
        key: "compensation.negative-radius",
        meaning: "negative tool radius",
        clause: clause::TRC_SIDE_07,
        values: word!(NegativeRadius, parameters.negative_radius),
    },
    Parameter {
        key: "compensation.equal-radius",
        meaning: "arc whose radius is the tool radius, tool inside",
        clause: clause::TRC_ARC_08,
        values: word!(EqualRadius, parameters.equal_radius),
    },
    Parameter {
        key: "compensation.zero-length-move",
        meaning: "straight move of length zero in mode",
        clause: clause::TRC_LOOK_07,
        values: word!(ZeroLengthMove, parameters.zero_length_move),
    },
    Parameter {
        key: "compensation.pending-at-alarm",
        meaning: "block that waits for its end when an alarm is raised",
        clause: clause::TRC_MODE_10,
        values: word!(PendingAtAlarm, parameters.pending_at_alarm),
    },
    Parameter {
        key: "compensation.side-code-vector",
        meaning: "I, J, K beside G41 or G42",
        clause: clause::TRC_START_10,
        values: word!(SideCodeVector, parameters.side_code_vector),
    },
    Parameter {
        key: "compensation.cancel-vector",
        meaning: "I, J, K beside G40",
        clause: clause::TRC_CANCEL_08,
        values: word!(CancelVector, parameters.cancel_vector),
    },
    Parameter {
        key: "compensation.offset-change",
        meaning: "offset value of another magnitude in mode",
        clause: clause::TRC_MODE_03,
        values: word!(OffsetChange, parameters.offset_change),
    },
    Parameter {
        key: "compensation.chord-tolerance",
        meaning: "by how much half a chord may exceed the radius of its arc, in millimetres",
        clause: clause::TRC_ARC_06,
        values: Values::Decimal { positive: false, field: |profile| &mut profile.parameters.chord_tolerance },
    },
    Parameter {
        key: "compensation.centre-tolerance",
        meaning: "how far from an end of its arc a centre counts as lying there, in millimetres",
        clause: clause::TRC_ARC_02,
        values: Values::Decimal { positive: false, field: |profile| &mut profile.parameters.centre_tolerance },
    },
    Parameter {
        key: "compensation.interference",
        meaning: "interference of vectors of one or several blocks",
        clause: clause::TRC_INT_01,
        values: word!(Interference, parameters.interference),
    },
    Parameter {
        key: "compensation.interference-blocks",
        meaning: "blocks that move and are read together for interference",
        clause: clause::TRC_INT_04,
        values: word!(InterferenceBlocks, parameters.interference_blocks),
    },
    Parameter {
        key: "compensation.interference-boundary",
        meaning: "vectors that lead the tool neither forward nor back",
        clause: clause::TRC_INT_02,
        values: word!(InterferenceBoundary, parameters.interference_boundary),
    },
    Parameter {
        key: "tips.T0",
        meaning: "imaginary tip of orientation 0, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[0]),
    },
    Parameter {
        key: "tips.T1",
        meaning: "imaginary tip of orientation 1, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[1]),
    },
    Parameter {
        key: "tips.T2",
        meaning: "imaginary tip of orientation 2, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[2]),
    },
    Parameter {
        key: "tips.T3",
        meaning: "imaginary tip of orientation 3, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[3]),
    },
    Parameter {
        key: "tips.T4",
        meaning: "imaginary tip of orientation 4, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[4]),
    },
    Parameter {
        key: "tips.T5",
        meaning: "imaginary tip of orientation 5, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[5]),
    },
    Parameter {
        key: "tips.T6",
        meaning: "imaginary tip of orientation 6, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[6]),
    },
    Parameter {
        key: "tips.T7",
        meaning: "imaginary tip of orientation 7, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[7]),
    },
    Parameter {
        key: "tips.T8",
        meaning: "imaginary tip of orientation 8, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[8]),
    },
    Parameter {
        key: "tips.T9",
        meaning: "imaginary tip of orientation 9, as signs of (a, b)",
        clause: clause::TRC_TIP_01,
        values: word!(Tip, tips[9]),
    },
];
