//! Programs: their blocks.

use radcomp_spec::{AlarmKind, Approach, Block, Centre, Compensation, Direction, Movement, OuterCorner};
use rug::Rational;
use serde::{Deserialize, Serialize};

use super::number::Exact;
use super::word::Id;

/// One block of a program, exactly.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockRecord {
    /// What the block moves in the plane.
    pub movement: MovementRecord,
    /// At rapid traverse; left out if not.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub rapid: bool,
    /// The compensation code, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compensation: Option<Id<Compensation>>,
    /// The vector of I, J, K beside the compensation code, if they stand there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vector: Option<[Exact; 2]>,
    /// The tool radius that the block puts in force, if it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius: Option<Exact>,
    /// The outer corner that the block puts in force, if it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub corner: Option<Id<OuterCorner>>,
    /// Start-up and cancel as NORM or KONT of the block chooses them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub approach: Option<Id<Approach>>,
    /// A code that loses the look-ahead; left out if there is none.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stops_look_ahead: bool,
    /// The alarm of a code that is not for offset mode, if the block has one there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub not_in_mode: Option<Id<AlarmKind>>,
}

/// The movement of a block.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum MovementRecord {
    /// No movement in the plane.
    None,
    /// A straight move.
    Line {
        /// End point.
        end: [Exact; 2],
    },
    /// A circular move.
    Arc {
        /// End point.
        end: [Exact; 2],
        /// How the centre was programmed.
        centre: CentreRecord,
        /// Sense.
        direction: Id<Direction>,
    },
    /// A dummy block.
    Dummy {
        /// Its vector.
        vector: [Exact; 2],
    },
    /// A straight move that holds the vector.
    HeldVector {
        /// End point.
        end: [Exact; 2],
    },
    /// A new vector.
    NewVector {
        /// The vector at right angles to which it stands.
        vector: [Exact; 2],
    },
    /// A corner arc.
    CornerArc {
        /// The vector at right angles to which it ends; left out: the next element decides.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        vector: Option<[Exact; 2]>,
    },
}

/// How the centre of an arc was programmed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum CentreRecord {
    /// The vector from the start point to the centre.
    FromStart([Exact; 2]),
    /// The radius, negative for the longer arc.
    Radius(Exact),
}

impl From<&Block<Rational>> for BlockRecord {
    fn from(block: &Block<Rational>) -> Self {
        let Block { movement, rapid, compensation, vector, radius, corner, approach, stops_look_ahead, not_in_mode } =
            block;
        let point = |[a, b]: &[Rational; 2]| [Exact(a.clone()), Exact(b.clone())];
        BlockRecord {
            movement: match movement {
                Movement::None => MovementRecord::None,
                Movement::Line { end } => MovementRecord::Line { end: point(end) },
                Movement::Dummy { vector } => MovementRecord::Dummy { vector: point(vector) },
                Movement::HeldVector { end } => MovementRecord::HeldVector { end: point(end) },
                Movement::NewVector { vector } => MovementRecord::NewVector { vector: point(vector) },
                Movement::CornerArc { vector } => MovementRecord::CornerArc { vector: vector.as_ref().map(point) },
                Movement::Arc { end, centre, direction } => MovementRecord::Arc {
                    end: point(end),
                    centre: match centre {
                        Centre::FromStart(vector) => CentreRecord::FromStart(point(vector)),
                        Centre::Radius(radius) => CentreRecord::Radius(Exact(radius.clone())),
                    },
                    direction: Id(*direction),
                },
            },
            rapid: *rapid,
            compensation: compensation.map(Id),
            vector: vector.as_ref().map(point),
            radius: radius.clone().map(Exact),
            corner: corner.map(Id),
            approach: approach.map(Id),
            stops_look_ahead: *stops_look_ahead,
            not_in_mode: not_in_mode.map(Id),
        }
    }
}

impl From<&BlockRecord> for Block<Rational> {
    fn from(record: &BlockRecord) -> Self {
        let BlockRecord {
            movement,
            rapid,
            compensation,
            vector,
            radius,
            corner,
            approach,
            stops_look_ahead,
            not_in_mode,
        } = record;
        let point = |[a, b]: &[Exact; 2]| [a.0.clone(), b.0.clone()];
        Block {
            movement: match movement {
                MovementRecord::None => Movement::None,
                MovementRecord::Line { end } => Movement::Line { end: point(end) },
                MovementRecord::Dummy { vector } => Movement::Dummy { vector: point(vector) },
                MovementRecord::HeldVector { end } => Movement::HeldVector { end: point(end) },
                MovementRecord::NewVector { vector } => Movement::NewVector { vector: point(vector) },
                MovementRecord::CornerArc { vector } => Movement::CornerArc { vector: vector.as_ref().map(point) },
                MovementRecord::Arc { end, centre, direction } => Movement::Arc {
                    end: point(end),
                    centre: match centre {
                        CentreRecord::FromStart(vector) => Centre::FromStart(point(vector)),
                        CentreRecord::Radius(radius) => Centre::Radius(radius.0.clone()),
                    },
                    direction: direction.0,
                },
            },
            rapid: *rapid,
            compensation: compensation.map(|id| id.0),
            vector: vector.as_ref().map(point),
            radius: radius.as_ref().map(|radius| radius.0.clone()),
            corner: corner.map(|id| id.0),
            approach: approach.map(|id| id.0),
            stops_look_ahead: *stops_look_ahead,
            not_in_mode: not_in_mode.map(|id| id.0),
        }
    }
}
