//! What a profile says of junctions.

use radcomp_spec::parameters::{
    ArcExtension, ArcOnRapid, CornerOwner, EqualRadius, Ratio, Reversal, SideChange, SideCodeVector, StartUp, StartUpB,
};
use radcomp_spec::{OuterCorner, Parameters};

/// What a profile says of junctions, and the outer corner in force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rules {
    /// [TRC-CORNER-09]
    pub reversal: Reversal,
    /// [TRC-SIDE-01]
    pub side_change: SideChange,
    /// The one in force. [TRC-CORNER-11]
    pub outer: OuterCorner,
    /// [TRC-CORNER-12]
    pub owner: CornerOwner,
    /// [TRC-START-06]
    pub start_up: StartUp,
    /// Type B passes its own normal. [TRC-START-06], [TRC-CANCEL-05]
    pub via_normal: bool,
    /// A cosine. [TRC-CORNER-13]
    pub limit: f64,
    /// [TRC-CORNER-14]
    pub extension: ArcExtension,
    /// A cosine; 0: there is no smallest corner. [TRC-CORNER-15]
    pub smallest: f64,
    /// A cosine; 0: no corner counts as straight. [TRC-CORNER-16]
    pub straight: f64,
    /// [TRC-CORNER-17]
    pub arc_on_rapid: ArcOnRapid,
    /// In millimetres; 0: no vector is dropped. [TRC-CORNER-18]
    pub small: f64,
    /// [TRC-ARC-08]
    pub equal_radius: EqualRadius,
    /// [TRC-START-11]
    pub side_code_vector: SideCodeVector,
}

impl Rules {
    /// The rules at the start of a program.
    pub fn new(parameters: &Parameters) -> Rules {
        Rules {
            reversal: parameters.reversal,
            side_change: parameters.side_change,
            outer: parameters.outer_corner,
            owner: parameters.corner_owner,
            start_up: parameters.start_up,
            via_normal: parameters.start_up_b == StartUpB::ViaNormal,
            limit: value(parameters.corner_limit_cosine),
            extension: parameters.arc_extension,
            smallest: value(parameters.smallest_corner_cosine),
            straight: value(parameters.straight_band_cosine),
            arc_on_rapid: parameters.arc_on_rapid,
            small: value(parameters.small_vector_limit),
            equal_radius: parameters.equal_radius,
            side_code_vector: parameters.side_code_vector,
        }
    }
}

/// A parameter's value; the quotient of two exact numbers is the decimal, rounded.
pub(crate) fn value(ratio: Ratio) -> f64 {
    f64::from(ratio.numerator) / f64::from(ratio.denominator)
}
