//! What a device answered.

use radcomp_spec::{Alarm, AlarmKind, Clause, Direction, Segment, Step};
use serde::{Deserialize, Serialize};

use super::number::Binary;
use super::word::Id;
use crate::device::Answer;

/// A device's answer to one program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnswerRecord {
    /// The path of the tool's centre, from (0, 0).
    pub steps: Vec<StepRecord>,
    /// The alarm that ended it, if there is one.
    pub alarm: Option<AlarmRecord>,
}

/// One element of the path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StepRecord {
    /// The block that it belongs to.
    pub block: usize,
    /// The clause that the device names for it.
    pub clause: Id<Clause>,
    /// At rapid traverse.
    pub rapid: bool,
    /// The block's own move, not a corner move.
    pub main: bool,
    /// Its geometry.
    pub segment: SegmentRecord,
}

/// The geometry of an element.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum SegmentRecord {
    /// A block without movement is executed here.
    Hold,
    /// A straight move.
    Line {
        /// End point.
        end: [Binary; 2],
    },
    /// A circular move.
    Arc {
        /// End point.
        end: [Binary; 2],
        /// Centre.
        centre: [Binary; 2],
        /// Sense.
        direction: Id<Direction>,
        /// A whole turn.
        full: bool,
    },
}

/// An alarm and the block that it was raised at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AlarmRecord {
    /// The block.
    pub block: usize,
    /// The alarm.
    pub alarm: Id<AlarmKind>,
}

impl From<&Answer> for AnswerRecord {
    fn from(answer: &Answer) -> Self {
        let Answer { steps, alarm } = answer;
        AnswerRecord { steps: steps.iter().map(StepRecord::from).collect(), alarm: alarm.map(AlarmRecord::from) }
    }
}

impl From<&AnswerRecord> for Answer {
    fn from(record: &AnswerRecord) -> Self {
        let AnswerRecord { steps, alarm } = record;
        Answer { steps: steps.iter().map(Step::from).collect(), alarm: alarm.map(Alarm::from) }
    }
}

impl From<&Step<f64>> for StepRecord {
    fn from(step: &Step<f64>) -> Self {
        let Step { block, clause, rapid, main, segment } = step;
        let segment = match segment {
            Segment::Hold => SegmentRecord::Hold,
            Segment::Line { end } => SegmentRecord::Line { end: end.map(Binary) },
            Segment::Arc { end, centre, direction, full } => SegmentRecord::Arc {
                end: end.map(Binary),
                centre: centre.map(Binary),
                direction: Id(*direction),
                full: *full,
            },
        };
        StepRecord { block: *block, clause: Id(*clause), rapid: *rapid, main: *main, segment }
    }
}

impl From<&StepRecord> for Step<f64> {
    fn from(record: &StepRecord) -> Self {
        let StepRecord { block, clause, rapid, main, segment } = record;
        let point = |point: &[Binary; 2]| point.map(|value| value.0);
        let segment = match segment {
            SegmentRecord::Hold => Segment::Hold,
            SegmentRecord::Line { end } => Segment::Line { end: point(end) },
            SegmentRecord::Arc { end, centre, direction, full } => {
                Segment::Arc { end: point(end), centre: point(centre), direction: direction.0, full: *full }
            }
        };
        Step { block: *block, clause: clause.0, rapid: *rapid, main: *main, segment }
    }
}

impl From<Alarm> for AlarmRecord {
    fn from(alarm: Alarm) -> Self {
        AlarmRecord { block: alarm.block, alarm: Id(alarm.kind) }
    }
}

impl From<AlarmRecord> for Alarm {
    fn from(record: AlarmRecord) -> Self {
        Alarm { block: record.block, kind: record.alarm.0 }
    }
}
