//! The control: every parameter that the compensation reads.

use radcomp_spec::Parameters;
use radcomp_spec::parameters::{
    Cancel, CornerOwner, MOST_NON_MOVING, OuterCorner, Ratio, Reversal, ReversedPath, SideChange,
    SideChangeAfterStartUp, StartUp, StartUpLost,
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
    #[serde(deserialize_with = "allowed")]
    pub non_moving_allowed: u8,
    pub corner_owner: Id<CornerOwner>,
    pub reversed_path: Id<ReversedPath>,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub arc_end_tolerance: Ratio,
    #[serde(serialize_with = "write_ratio", deserialize_with = "read_ratio")]
    pub far_intersection: Ratio,
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
        }
    }
}

fn allowed<'de, D: Deserializer<'de>>(deserializer: D) -> Result<u8, D::Error> {
    let count = u8::deserialize(deserializer)?;
    if count <= MOST_NON_MOVING {
        return Ok(count);
    }
    Err(Error::custom(format!("non-moving-allowed is at most {MOST_NON_MOVING}")))
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
