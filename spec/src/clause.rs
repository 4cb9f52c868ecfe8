//! The ids of the normative clauses, as constants that code cites. The text stands in `spec/clauses/*.md`.

use core::fmt;

/// The id of a normative clause, such as `TRC-CORNER-03`. Ids are never reused.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Clause(&'static str);

impl Clause {
    /// The id as written in the specification.
    pub const fn id(self) -> &'static str {
        self.0
    }
}

impl fmt::Debug for Clause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

impl fmt::Display for Clause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

macro_rules! clauses {
    ($($name:ident = $id:literal: $title:literal;)*) => {
        $(
            #[doc = concat!("`", $id, "`: ", $title, ".")]
            pub const $name: Clause = Clause($id);
        )*

        /// Every clause with its title, in the order of the specification.
        pub const ALL: &[(Clause, &str)] = &[$(($name, $title)),*];
    };
}

clauses! {
    TRC_PLANE_01 = "TRC-PLANE-01": "Plane coordinates";
    TRC_PLANE_02 = "TRC-PLANE-02": "Sides";
    TRC_PLANE_03 = "TRC-PLANE-03": "Diameter words";
    TRC_PLANE_04 = "TRC-PLANE-04": "Offset of a line and of an arc";
    TRC_PLANE_05 = "TRC-PLANE-05": "Activation codes";
    TRC_MODE_01 = "TRC-MODE-01": "Cancel mode";
    TRC_MODE_02 = "TRC-MODE-02": "A code without movement";
    TRC_MODE_03 = "TRC-MODE-03": "Offset changed in mode";
    TRC_MODE_04 = "TRC-MODE-04": "End of program in mode";
    TRC_MODE_05 = "TRC-MODE-05": "The same code again";
    TRC_MODE_06 = "TRC-MODE-06": "Where an alarm stops the tool";
    TRC_MODE_07 = "TRC-MODE-07": "Numbers out of range";
    TRC_MODE_08 = "TRC-MODE-08": "Codes that are not for offset mode";
    TRC_MODE_09 = "TRC-MODE-09": "Axes outside the plane";
    TRC_MODE_10 = "TRC-MODE-10": "A block that is lost in an alarm";
    TRC_MODE_11 = "TRC-MODE-11": "Each block its own offset value";
    TRC_START_01 = "TRC-START-01": "The start-up block";
    TRC_START_02 = "TRC-START-02": "Start-up, type A";
    TRC_START_03 = "TRC-START-03": "An arc as start-up block";
    TRC_START_04 = "TRC-START-04": "Start-up without a next element";
    TRC_START_05 = "TRC-START-05": "Start-up before a cancel block";
    TRC_START_06 = "TRC-START-06": "Start-up, type B";
    TRC_START_07 = "TRC-START-07": "Start-up at right angles to the entry move";
    TRC_START_08 = "TRC-START-08": "Start-up without movement, type C";
    TRC_START_09 = "TRC-START-09": "An arc as entry move";
    TRC_START_10 = "TRC-START-10": "I, J, K at start-up: a vector at right angles";
    TRC_START_11 = "TRC-START-11": "I, J, K at start-up: an imaginary line";
    TRC_START_12 = "TRC-START-12": "Codes that choose start-up and cancel";
    TRC_CORNER_01 = "TRC-CORNER-01": "Inner and outer corners";
    TRC_CORNER_02 = "TRC-CORNER-02": "Tangent junction";
    TRC_CORNER_03 = "TRC-CORNER-03": "Inner corner of two lines";
    TRC_CORNER_04 = "TRC-CORNER-04": "Inner corner with an arc";
    TRC_CORNER_05 = "TRC-CORNER-05": "No intersection at an inner corner";
    TRC_CORNER_06 = "TRC-CORNER-06": "Outer obtuse corner: intersection";
    TRC_CORNER_07 = "TRC-CORNER-07": "Normals of arcs at an outer corner";
    TRC_CORNER_08 = "TRC-CORNER-08": "Outer acute corner: squared off";
    TRC_CORNER_09 = "TRC-CORNER-09": "Exact reversal";
    TRC_CORNER_10 = "TRC-CORNER-10": "Outer corner by an arc";
    TRC_CORNER_11 = "TRC-CORNER-11": "M96 and M97";
    TRC_CORNER_12 = "TRC-CORNER-12": "The block that owns a corner";
    TRC_CORNER_13 = "TRC-CORNER-13": "Limit angle of an outer corner";
    TRC_CORNER_14 = "TRC-CORNER-14": "An arc extended by itself";
    TRC_CORNER_15 = "TRC-CORNER-15": "The smallest corner of type B";
    TRC_CORNER_16 = "TRC-CORNER-16": "Corners that count as straight";
    TRC_CORNER_17 = "TRC-CORNER-17": "A rapid block after an outer corner by an arc";
    TRC_CORNER_18 = "TRC-CORNER-18": "Small vectors";
    TRC_SIDE_01 = "TRC-SIDE-01": "Direct change of side";
    TRC_SIDE_02 = "TRC-SIDE-02": "Contact with both contours";
    TRC_SIDE_03 = "TRC-SIDE-03": "Side change without a contact point";
    TRC_SIDE_04 = "TRC-SIDE-04": "Side change after start-up";
    TRC_SIDE_05 = "TRC-SIDE-05": "Contact anywhere";
    TRC_SIDE_06 = "TRC-SIDE-06": "Crossing over the whole block";
    TRC_SIDE_07 = "TRC-SIDE-07": "Negative tool radius";
    TRC_SIDE_08 = "TRC-SIDE-08": "No arc runs past a full turn";
    TRC_CANCEL_01 = "TRC-CANCEL-01": "The block before G40";
    TRC_CANCEL_02 = "TRC-CANCEL-02": "The cancel block";
    TRC_CANCEL_03 = "TRC-CANCEL-03": "G40 without movement";
    TRC_CANCEL_04 = "TRC-CANCEL-04": "An arc as cancel block";
    TRC_CANCEL_05 = "TRC-CANCEL-05": "Cancel, type B";
    TRC_CANCEL_06 = "TRC-CANCEL-06": "Cancel without movement, type C";
    TRC_CANCEL_07 = "TRC-CANCEL-07": "Offset number 0";
    TRC_CANCEL_08 = "TRC-CANCEL-08": "G40 with I, J, K";
    TRC_LOOK_01 = "TRC-LOOK-01": "Blocks without movement";
    TRC_LOOK_02 = "TRC-LOOK-02": "Look-ahead over blocks without movement";
    TRC_LOOK_03 = "TRC-LOOK-03": "Look-ahead lost";
    TRC_LOOK_04 = "TRC-LOOK-04": "The line after a settled junction";
    TRC_LOOK_05 = "TRC-LOOK-05": "The arc after a settled junction";
    TRC_LOOK_06 = "TRC-LOOK-06": "What lost look-ahead cuts";
    TRC_LOOK_07 = "TRC-LOOK-07": "A move of length zero";
    TRC_LOOK_08 = "TRC-LOOK-08": "Codes that stop reading ahead";
    TRC_DUMMY_01 = "TRC-DUMMY-01": "Dummy blocks";
    TRC_DUMMY_02 = "TRC-DUMMY-02": "The junction before a dummy block";
    TRC_DUMMY_03 = "TRC-DUMMY-03": "The dummy before an arc";
    TRC_DUMMY_04 = "TRC-DUMMY-04": "A dummy inside a run of blocks without movement";
    TRC_DUMMY_05 = "TRC-DUMMY-05": "Dummy words of a lathe";
    TRC_ARC_01 = "TRC-ARC-01": "Forms of an arc";
    TRC_ARC_02 = "TRC-ARC-02": "Centre at the start or the end";
    TRC_ARC_03 = "TRC-ARC-03": "End off the arc";
    TRC_ARC_04 = "TRC-ARC-04": "Two radii within the tolerance";
    TRC_ARC_05 = "TRC-ARC-05": "The tool inside an arc";
    TRC_ARC_06 = "TRC-ARC-06": "Radius too small for its chord";
    TRC_ARC_07 = "TRC-ARC-07": "Full circles";
    TRC_ARC_08 = "TRC-ARC-08": "Arc radius and tool radius equal";
    TRC_WEDGE_01 = "TRC-WEDGE-01": "Intersection far away";
    TRC_WEDGE_02 = "TRC-WEDGE-02": "A line whose tool path runs backwards";
    TRC_WEDGE_03 = "TRC-WEDGE-03": "An arc whose tool path runs backwards";
    TRC_TIP_01 = "TRC-TIP-01": "The imaginary tool tip";
    TRC_TIP_02 = "TRC-TIP-02": "Geometry and wear";
    TRC_TIP_03 = "TRC-TIP-03": "The programmed point of a lathe";
    TRC_VEC_01 = "TRC-VEC-01": "Vector codes";
    TRC_VEC_02 = "TRC-VEC-02": "A corner arc with a direction";
    TRC_VEC_03 = "TRC-VEC-03": "A corner arc to the next element";
    TRC_VEC_04 = "TRC-VEC-04": "A move that holds the vector";
    TRC_VEC_05 = "TRC-VEC-05": "A new vector";
    TRC_VEC_06 = "TRC-VEC-06": "I, J, K beside the code of a side in mode";
    TRC_INT_01 = "TRC-INT-01": "What is looked at for interference";
    TRC_INT_02 = "TRC-INT-02": "Vectors that interfere";
    TRC_INT_03 = "TRC-INT-03": "Removal of vectors";
    TRC_INT_04 = "TRC-INT-04": "Interference of several blocks";
    TRC_INT_05 = "TRC-INT-05": "Avoidance";
}
