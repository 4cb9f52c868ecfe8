//! The named decisions: every branch of the rules that geometry takes.

use crate::clause::{self, Clause};

macro_rules! decisions {
    ($($name:ident = $id:literal, $clause:ident, $margin:literal;)*) => {
        /// A branch of the rules. Its margin is signed, in millimetres; the variant's text says what it measures.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum DecisionKind {
            $(#[doc = concat!("`", $id, "`: ", $margin, ".")] $name,)*
        }

        impl DecisionKind {
            /// Every kind of decision.
            pub const ALL: &[DecisionKind] = &[$(DecisionKind::$name),*];

            /// The name used in reports.
            pub const fn id(self) -> &'static str {
                match self { $(DecisionKind::$name => $id,)* }
            }

            /// The clause whose sentence it decides.
            pub const fn clause(self) -> Clause {
                match self { $(DecisionKind::$name => clause::$clause,)* }
            }

            /// What the margin measures.
            pub const fn margin(self) -> &'static str {
                match self { $(DecisionKind::$name => $margin,)* }
            }
        }
    };
}

impl DecisionKind {
    /// Whether the path or an alarm depends on it; the others only decide whether a warning is given.
    pub const fn shapes_the_path(self) -> bool {
        !matches!(self, DecisionKind::NearCorner | DecisionKind::LineInForward)
    }
}

decisions! {
    Moves = "moves", TRC_LOOK_01, "length of the programmed move; zero is no movement";
    CentreDistance = "centre-distance", TRC_ARC_02, "distance of start or end from the arc's centre less the tolerance; zero and negative are an alarm";
    ChordFits = "chord-fits", TRC_ARC_06, "programmed radius and tolerance less half the chord; negative is an alarm";
    HalfTurn = "half-turn", TRC_ARC_06, "programmed radius less half the chord; negative is a half turn about its middle";
    EndOnArc = "end-on-arc", TRC_ARC_03, "tolerance less the difference of the two radii; negative is an alarm";
    WholeTurn = "whole-turn", TRC_ARC_07, "distance of the tool's start and end from the full circle's own normal; zero is a whole turn";
    ToolFitsArc = "tool-fits-arc", TRC_ARC_05, "arc radius less tool radius, tool inside; zero and negative are an alarm";
    CentresApart = "centres-apart", TRC_CORNER_05, "distance of the centres of two arcs; zero is no intersection";
    Turn = "turn", TRC_CORNER_01, "sine of the turn toward the tool's side times the shorter arm; positive is an inner corner";
    RightAngle = "right-angle", TRC_CORNER_08, "cosine of the turn times the shorter arm; negative is an acute corner";
    OffsetsMeet = "offsets-meet", TRC_CORNER_05, "by how much the two offset curves overlap; negative is an alarm";
    ContactExists = "contact-exists", TRC_SIDE_02, "by how much the offset curves of a side change overlap; negative is no contact";
    ContactWithin = "contact-within", TRC_SIDE_02, "tool radius less the distance of the contact point from the offset element; negative is no contact";
    NearerContact = "nearer-contact", TRC_SIDE_02, "distance from the corner of the second contact point less that of the first; zero is no contact";
    EntryLength = "entry-length", TRC_START_07, "length of the entry move less the tool radius; zero and negative are an alarm";
    EntryArc = "entry-arc", TRC_START_09, "how far the entry's start lies toward the arc's centre from its new end; zero and negative are an alarm";
    ImaginaryLineMet = "imaginary-line-met", TRC_CANCEL_08, "by how much the offset curve and that of the imaginary line overlap; negative is no common point";
    SmallestCorner = "smallest-corner", TRC_CORNER_15, "cosine of the turn plus the limit, times the shorter arm; negative is a single vector";
    LimitAngle = "limit-angle", TRC_CORNER_13, "cosine of the turn plus the limit, times the shorter arm; negative is an arc";
    ExtensionsMeet = "extensions-meet", TRC_CORNER_14, "by how much the two extended offset curves overlap; negative is an alarm";
    StraightBand = "straight-band", TRC_CORNER_16, "cosine of the turn less the limit, times the shorter arm; zero and positive are straight";
    SmallVector = "small-vector", TRC_CORNER_18, "the greater coordinate difference of two vectors less the limit; zero and negative drop the latter";
    LineForward = "line-forward", TRC_WEDGE_02, "tool travel along the programmed direction; negative runs backwards";
    ArcForward = "arc-forward", TRC_WEDGE_03, "margin of the sweep comparison; negative runs backwards";
    InterferenceApart = "interference-apart", TRC_INT_02, "distance of two corners whose vectors are compared; zero never interferes";
    LineInterference = "line-interference", TRC_INT_02, "the way from vector to vector along that from corner to corner; negative interferes";
    ArcInterference = "arc-interference", TRC_INT_02, "margin of the sweep comparison of an arc's vectors; negative interferes";
    AvoidanceTurn = "avoidance-turn", TRC_INT_05, "cosine of the turn over the blocks left out times the shorter arm; negative is an alarm";
    AvoidanceParallel = "avoidance-parallel", TRC_INT_05, "sine of the turn toward the tool's side over the blocks left out times the shorter arm; zero is an alarm";
    AvoidanceMeets = "avoidance-meets", TRC_INT_05, "by how much the offset curves before and behind the blocks left out overlap; negative is an alarm";
    NearerAvoidance = "nearer-avoidance", TRC_INT_05, "distance from the corner of the second common point less that of the first; zero is an alarm";
    LineInForward = "line-in-forward", TRC_LOOK_05, "straight move along the tangent at an arc's start; negative is advised";
    NearCorner = "near-corner", TRC_WEDGE_01, "the limit less the distance of the vector's end from the corner; negative is advised";
}
