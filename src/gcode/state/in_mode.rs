//! Codes that are not for offset mode: [TRC-MODE-08].

use radcomp_spec::parameters::{InMode, ToolChange};
use radcomp_spec::{AlarmKind, clause};

use super::State;
use crate::gcode::arrange::{Command, Given, not_supported};
use crate::gcode::codes::Meaning;
use crate::gcode::diagnostic::{Kind, LineFault};
use crate::gcode::offsets;
use crate::gcode::word::Word;

/// What a profile says of a code in mode.
enum Rule {
    NoMovement,
    Alarm,
    Unsupported,
}

impl State<'_> {
    /// The alarm of a code in a block, which is in mode; the first one in the order of [`AlarmKind`].
    pub(super) fn not_in_mode(&self, command: &Command<'_>) -> Result<Option<AlarmKind>, LineFault> {
        let mut raised = None;
        for given in command.codes() {
            let Some(kind) = self.concerns(given, command)? else { continue };
            if !self.in_mode() {
                outside(given)?;
                continue;
            }
            match self.rule(kind) {
                Rule::NoMovement => {}
                Rule::Alarm => raised = raised.into_iter().chain([kind]).min(),
                Rule::Unsupported => {
                    let (name, code) = (&self.profile.name, given.code);
                    let message = format!("profile {name} does not tell what {code} does while compensation is on");
                    let fault = LineFault::new(Kind::NotInMode, given.span.clone(), message);
                    return Err(fault.citing(clause::TRC_MODE_08).helping("G40 comes first"));
                }
            }
        }
        Ok(raised)
    }

    /// The alarm that a code would raise in mode; none if it may stand there.
    fn concerns(&self, given: &Given, command: &Command<'_>) -> Result<Option<AlarmKind>, LineFault> {
        Ok(match given.code.meaning {
            Meaning::Plane(plane) => (plane != self.plane).then_some(AlarmKind::PlaneChangeInMode),
            Meaning::NotInMode(kind) => Some(kind),
            Meaning::ToolChange => Some(AlarmKind::ToolChangeInMode),
            Meaning::SpindleLimit if limits_the_spindle(command) => None,
            Meaning::SpindleLimit if self.in_mode() && offsets::t_selects_offset(self.profile) => {
                Some(AlarmKind::SetCoordinatesInMode)
            }
            Meaning::SpindleLimit => {
                let message = "G50 is supported with an S word alone, as the limit of the spindle speed";
                return Err(LineFault::new(Kind::UnsupportedCode, given.span.clone(), message));
            }
            _ => None,
        })
    }

    fn rule(&self, kind: AlarmKind) -> Rule {
        let machine = &self.profile.machine;
        let in_mode = match kind {
            AlarmKind::PlaneChangeInMode => machine.plane_change,
            AlarmKind::ReferenceReturnInMode => machine.reference_return,
            AlarmKind::MachineCoordinatesInMode => machine.machine_coordinates,
            AlarmKind::SetCoordinatesInMode => machine.set_coordinates,
            AlarmKind::ToolChangeInMode => match machine.tool_change {
                ToolChange::NoMovement => return Rule::NoMovement,
                ToolChange::Alarm => InMode::Alarm,
                ToolChange::Unsupported => InMode::Unsupported,
            },
            // Only cycle codes are left.
            _ => machine.canned_cycle,
        };
        match in_mode {
            InMode::Alarm => Rule::Alarm,
            InMode::Unsupported => Rule::Unsupported,
        }
    }
}

/// Outside the mode the plane may change and tools too; the other codes would leave the programmed point unknown.
fn outside(given: &Given) -> Result<(), LineFault> {
    match given.code.meaning {
        Meaning::NotInMode(_) => Err(not_supported(&given.code.to_string(), given.code.reason, given.span.clone())),
        _ => Ok(()),
    }
}

/// G50 limits the spindle speed if S stands alone with it; with axis words it would set the coordinates.
fn limits_the_spindle(command: &Command<'_>) -> bool {
    let others = |word: &&Word<'_>| !"NS".contains(word.letter);
    command.word('S').is_some() && command.words().find(others).is_none()
}
