//! The control: every parameter that the compensation reads.

use radcomp_spec::Parameters;
use radcomp_spec::parameters::{
    ArcExtension, ArcOnRapid, Cancel, CancelVector, CancelWithoutMovement, CornerOwner, EqualRadius, Interference,
    InterferenceBlocks, InterferenceBoundary, MOST_NON_MOVING, NegativeRadius, OffsetChange, OuterCorner,
    PendingAtAlarm, Ratio, Reversal, ReversedPath, SameCode, SideChange, SideChangeAfterStartUp, SideCodeVector,
    StartUp, StartUpArc, StartUpB, StartUpLost, StartUpWithoutMovement, ZeroLengthMove,
};
use rug::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::number::Exact;
use super::word::Id;

/// The parameters by the names that profile files give them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[expect(missing_docs, reason = "each is the field of Parameters with its name")]
pub struct ParametersRecord {
    pub start_up: Id<StartUp>,
    pub start_up_lost: Id<StartUpLost>,
    pub cancel: Id<Cancel>,
    pub outer_corner: Id<OuterCorner>,
    pub reversal: Id<Reversal>,
    pub side_change: Id<SideChange>,
    pub side_change_after_start_up: Id<SideChangeAfterStartUp>,
    #[serde(serialize_with = "write_allowed", deserialize_with = "read_allowed")]
    pub non_moving_allowed: Option<u8>,
    pub corner_owner: Id<CornerOwner>,
    pub reversed_path: Id<ReversedPath>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub arc_end_tolerance: Ratio,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub far_intersection: Ratio,
    pub start_up_b: Id<StartUpB>,
    pub start_up_without_movement: Id<StartUpWithoutMovement>,
    pub start_up_arc: Id<StartUpArc>,
    pub cancel_without_movement: Id<CancelWithoutMovement>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub corner_limit_cosine: Ratio,
    pub arc_extension: Id<ArcExtension>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub smallest_corner_cosine: Ratio,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub straight_band_cosine: Ratio,
    pub arc_on_rapid: Id<ArcOnRapid>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub small_vector_limit: Ratio,
    pub same_code: Id<SameCode>,
    pub negative_radius: Id<NegativeRadius>,
    pub equal_radius: Id<EqualRadius>,
    pub zero_length_move: Id<ZeroLengthMove>,
    pub pending_at_alarm: Id<PendingAtAlarm>,
    pub side_code_vector: Id<SideCodeVector>,
    pub cancel_vector: Id<CancelVector>,
    pub offset_change: Id<OffsetChange>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub chord_tolerance: Ratio,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub centre_tolerance: Ratio,
    pub interference: Id<Interference>,
    pub interference_blocks: Id<InterferenceBlocks>,
    pub interference_boundary: Id<InterferenceBoundary>,
}

impl From<&Parameters> for ParametersRecord {
    fn from(parameters: &Parameters) -> Self {
        let Parameters {
            start_up,
            start_up_lost,
            cancel,
            outer_corner,
            reversal,
            side_change,
            side_change_after_start_up,
            non_moving_allowed,
            corner_owner,
            reversed_path,
            arc_end_tolerance,
            far_intersection,
            start_up_b,
            start_up_without_movement,
            start_up_arc,
            cancel_without_movement,
            corner_limit_cosine,
            arc_extension,
            smallest_corner_cosine,
            straight_band_cosine,
            arc_on_rapid,
            small_vector_limit,
            same_code,
            negative_radius,
            equal_radius,
            zero_length_move,
            pending_at_alarm,
            side_code_vector,
            cancel_vector,
            offset_change,
            chord_tolerance,
            centre_tolerance,
            interference,
            interference_blocks,
            interference_boundary,
        } = *parameters;
        ParametersRecord {
            start_up: Id(start_up),
            start_up_lost: Id(start_up_lost),
            cancel: Id(cancel),
            outer_corner: Id(outer_corner),
            reversal: Id(reversal),
            side_change: Id(side_change),
            side_change_after_start_up: Id(side_change_after_start_up),
            non_moving_allowed,
            corner_owner: Id(corner_owner),
            reversed_path: Id(reversed_path),
            arc_end_tolerance,
            far_intersection,
            start_up_b: Id(start_up_b),
            start_up_without_movement: Id(start_up_without_movement),
            start_up_arc: Id(start_up_arc),
            cancel_without_movement: Id(cancel_without_movement),
            corner_limit_cosine,
            arc_extension: Id(arc_extension),
            smallest_corner_cosine,
            straight_band_cosine,
            arc_on_rapid: Id(arc_on_rapid),
            small_vector_limit,
            same_code: Id(same_code),
            negative_radius: Id(negative_radius),
            equal_radius: Id(equal_radius),
            zero_length_move: Id(zero_length_move),
            pending_at_alarm: Id(pending_at_alarm),
            side_code_vector: Id(side_code_vector),
            cancel_vector: Id(cancel_vector),
            offset_change: Id(offset_change),
            chord_tolerance,
            centre_tolerance,
            interference: Id(interference),
            interference_blocks: Id(interference_blocks),
            interference_boundary: Id(interference_boundary),
        }
    }
}

impl From<&ParametersRecord> for Parameters {
    fn from(record: &ParametersRecord) -> Self {
        Parameters {
            start_up: record.start_up.0,
            start_up_lost: record.start_up_lost.0,
            cancel: record.cancel.0,
            outer_corner: record.outer_corner.0,
            reversal: record.reversal.0,
            side_change: record.side_change.0,
            side_change_after_start_up: record.side_change_after_start_up.0,
            non_moving_allowed: record.non_moving_allowed,
            corner_owner: record.corner_owner.0,
            reversed_path: record.reversed_path.0,
            arc_end_tolerance: record.arc_end_tolerance,
            far_intersection: record.far_intersection,
            start_up_b: record.start_up_b.0,
            start_up_without_movement: record.start_up_without_movement.0,
            start_up_arc: record.start_up_arc.0,
            cancel_without_movement: record.cancel_without_movement.0,
            corner_limit_cosine: record.corner_limit_cosine,
            arc_extension: record.arc_extension.0,
            smallest_corner_cosine: record.smallest_corner_cosine,
            straight_band_cosine: record.straight_band_cosine,
            arc_on_rapid: record.arc_on_rapid.0,
            small_vector_limit: record.small_vector_limit,
            same_code: record.same_code.0,
            negative_radius: record.negative_radius.0,
            equal_radius: record.equal_radius.0,
            zero_length_move: record.zero_length_move.0,
            pending_at_alarm: record.pending_at_alarm.0,
            side_code_vector: record.side_code_vector.0,
            cancel_vector: record.cancel_vector.0,
            offset_change: record.offset_change.0,
            chord_tolerance: record.chord_tolerance,
            centre_tolerance: record.centre_tolerance,
            interference: record.interference.0,
            interference_blocks: record.interference_blocks.0,
            interference_boundary: record.interference_boundary.0,
        }
    }
}

/// The word for any number of blocks without movement.
const UNBOUNDED: &str = "unbounded";

fn write_allowed<S: Serializer>(allowed: &Option<u8>, serializer: S) -> Result<S::Ok, S::Error> {
    match allowed {
        Some(count) => serializer.serialize_u8(*count),
        None => serializer.serialize_str(UNBOUNDED),
    }
}

fn read_allowed<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<u8>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Allowed {
        Count(u8),
        Word(String),
    }
    match Allowed::deserialize(deserializer)? {
        Allowed::Count(count) if count <= MOST_NON_MOVING => Ok(Some(count)),
        Allowed::Word(word) if word == UNBOUNDED => Ok(None),
        _ => Err(Error::custom(format!("non-moving-allowed is at most {MOST_NON_MOVING}, or \"{UNBOUNDED}\""))),
    }
}

fn write_ratio<S: Serializer>(ratio: &Ratio, serializer: S) -> Result<S::Ok, S::Error> {
    if ratio.denominator == 0 {
        return Err(serde::ser::Error::custom("a ratio whose denominator is zero"));
    }
    Exact(Rational::from((ratio.numerator, ratio.denominator))).serialize(serializer)
}

fn read_ratio<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Ratio, D::Error> {
    let Exact(value) = Exact::deserialize(deserializer)?;
    match (value.numer().to_u32(), value.denom().to_u32()) {
        (Some(numerator), Some(denominator)) => Ok(Ratio { numerator, denominator }),
        _ => Err(Error::custom("a limit is a ratio of two whole numbers below 2^32, 0 or greater")),
    }
}
