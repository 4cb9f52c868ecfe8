//! Path elements and alarms as C sees them.

use radcomp_spec::{Alarm, AlarmKind, Direction, Segment, Step, clause};

use crate::block::{RADCOMP_ARC, RADCOMP_CLOCKWISE, RADCOMP_COUNTERCLOCKWISE, RADCOMP_LINE, RADCOMP_NONE};

/// One element of the path of the tool's centre, from where the one before ended.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct radcomp_step {
    /// The block that the element belongs to.
    pub block: u64,
    /// RADCOMP_LINE, RADCOMP_ARC, or RADCOMP_NONE: a block without movement is executed here.
    pub shape: u32,
    /// RADCOMP_CLOCKWISE or RADCOMP_COUNTERCLOCKWISE, of an arc.
    pub direction: u32,
    /// Not 0: the arc is a whole turn.
    pub full: u32,
    /// Not 0: at rapid traverse.
    pub rapid: u32,
    /// The end point.
    pub end: [f64; 2],
    /// The centre of an arc, absolute.
    pub centre: [f64; 2],
}

/// An alarm, or none.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct radcomp_alarm {
    /// The block that it is raised at.
    pub block: u64,
    /// Its name in the specification, such as "radius-too-small", with a zero at its end; empty for no alarm.
    pub name: [core::ffi::c_char; RADCOMP_NAME],
}

/// How long a name may be, with the zero at its end.
pub const RADCOMP_NAME: usize = 48;

impl Default for radcomp_alarm {
    fn default() -> Self {
        radcomp_alarm { block: 0, name: [0; RADCOMP_NAME] }
    }
}

impl From<&Step<f64>> for radcomp_step {
    fn from(step: &Step<f64>) -> Self {
        let mut out =
            radcomp_step { block: step.block as u64, rapid: u32::from(step.rapid), ..radcomp_step::default() };
        match &step.segment {
            Segment::Hold => out.shape = RADCOMP_NONE,
            Segment::Line { end } => (out.shape, out.end) = (RADCOMP_LINE, *end),
            Segment::Arc { end, centre, direction, full } => {
                (out.shape, out.end, out.centre) = (RADCOMP_ARC, *end, *centre);
                out.direction = u32::from(*direction == Direction::Counterclockwise);
                out.full = u32::from(*full);
            }
        }
        out
    }
}

impl radcomp_step {
    /// The element in the words of the specification; none if a value is none.
    pub fn step(&self) -> Option<Step<f64>> {
        let segment = match (self.shape, self.direction) {
            (RADCOMP_NONE, _) => Segment::Hold,
            (RADCOMP_LINE, _) => Segment::Line { end: self.end },
            (RADCOMP_ARC, RADCOMP_CLOCKWISE | RADCOMP_COUNTERCLOCKWISE) => Segment::Arc {
                end: self.end,
                centre: self.centre,
                direction: match self.direction {
                    RADCOMP_CLOCKWISE => Direction::Clockwise,
                    _ => Direction::Counterclockwise,
                },
                full: self.full != 0,
            },
            _ => return None,
        };
        let (block, rapid) = (usize::try_from(self.block).ok()?, self.rapid != 0);
        Some(Step { block, clause: clause::TRC_MODE_01, rapid, main: true, segment })
    }
}

impl From<Alarm> for radcomp_alarm {
    fn from(alarm: Alarm) -> Self {
        radcomp_alarm { block: alarm.block as u64, name: name(alarm.kind) }
    }
}

impl radcomp_alarm {
    /// The alarm; `Ok(None)` if there is none, an error if there is none of this name.
    #[allow(clippy::result_unit_err, reason = "there is one error, and the caller words it")]
    pub fn alarm(&self) -> Result<Option<Alarm>, ()> {
        let Some(kind) = kind(&self.name)? else { return Ok(None) };
        Ok(Some(Alarm { block: usize::try_from(self.block).map_err(|_| ())?, kind }))
    }
}

/// The name of an alarm, with a zero at its end.
pub(crate) fn name(kind: AlarmKind) -> [core::ffi::c_char; RADCOMP_NAME] {
    let mut name = [0; RADCOMP_NAME];
    // The last byte stays zero.
    for (to, from) in name[..RADCOMP_NAME - 1].iter_mut().zip(kind.id().bytes()) {
        *to = from as core::ffi::c_char;
    }
    name
}

/// The alarm of a name; `Ok(None)` for an empty one, an error if there is none of this name.
pub(crate) fn kind(name: &[core::ffi::c_char; RADCOMP_NAME]) -> Result<Option<AlarmKind>, ()> {
    let length = name.iter().position(|byte| *byte == 0).ok_or(())?;
    if length == 0 {
        return Ok(None);
    }
    let is = |kind: &&AlarmKind| kind.id().bytes().eq(name[..length].iter().map(|byte| *byte as u8));
    AlarmKind::ALL.iter().find(is).copied().map(Some).ok_or(())
}
