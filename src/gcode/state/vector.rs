//! Vectors that the program gives: G38 and G39, and I, J, K beside a compensation code.

use std::ops::Range;

use radcomp_spec::parameters::{CancelVector, Dummy, Measure, SideCodeVector, StartUp, VectorCodes};
use radcomp_spec::{Block, Compensation, Movement, clause};
use rug::Rational;

use super::State;
use super::movement::{word_of_arc, word_of_dwell};
use crate::gcode::arrange::{Command, Given};
use crate::gcode::axes::{AXES, CENTRES, axes_of, name_of};
use crate::gcode::codes::{Group, Meaning, Motion};
use crate::gcode::diagnostic::{Kind, LineFault};
use crate::gcode::word::Word;

impl State<'_> {
    /// G38 or G39, if the profile has them ([TRC-VEC-01]).
    pub(super) fn vector_code<'g>(&self, given: &'g Given) -> Result<&'g Given, LineFault> {
        match self.profile.machine.vector_codes {
            VectorCodes::G38G39 => Ok(given),
            VectorCodes::None => {
                let message = format!("profile {} has no {}", self.profile.name, given.code);
                Err(LineFault::new(Kind::AbsentCode, given.span.clone(), message).citing(clause::TRC_VEC_01))
            }
        }
    }

    /// Reads a block with G38 or G39 ([TRC-VEC-01]).
    pub(super) fn vector_block(
        &mut self,
        command: &Command<'_>,
        given: &Given,
        block: &mut Block<Rational>,
    ) -> Result<(), LineFault> {
        let fault = |kind, message: String| {
            let message = format!("{} {message}", given.code);
            LineFault::new(kind, given.span.clone(), message).citing(clause::TRC_VEC_01)
        };
        if command.code(Group::Compensation).is_some() {
            return Err(fault(
                Kind::ConflictingCodes,
                "and a compensation code exclude each other in one block".into(),
            ));
        }
        if command.codes().any(|other| other.code.meaning == Meaning::Dwell) {
            return Err(fault(Kind::ConflictingCodes, "and G04 exclude each other in one block".into()));
        }
        let holds = given.code.meaning == Meaning::HeldVector;
        if holds && !matches!(self.motion, Some(Motion::Rapid | Motion::Feed)) {
            return Err(fault(Kind::MisplacedWord, "needs a straight move in force, G00 or G01".into()));
        }
        for letter in ['P', 'U'] {
            if let Some(word) = command.word(letter) {
                return Err(word_of_dwell(word));
            }
        }
        if let Some(radius) = command.word('R') {
            return Err(word_of_arc(radius.span.clone()));
        }
        let [_, _, normal] = axes_of(self.plane);
        let (axes, centres) = (command.words_of(AXES), command.words_of(CENTRES));
        if axes[normal].is_some() {
            let message = format!("stands without words of an axis outside the plane, {}", name_of(self.plane));
            return Err(fault(Kind::MisplacedWord, message));
        }
        let (to_point, by_vector) = (axes.iter().any(Option::is_some), centres.iter().any(Option::is_some));
        if to_point && by_vector {
            return Err(fault(Kind::MisplacedWord, "has axis words or I, J, K, not both".into()));
        }
        self.stay_in_plane(&given.span)?;
        block.rapid = self.motion == Some(Motion::Rapid);
        let no_direction = || fault(Kind::MisplacedWord, "needs a direction, and this one has no length".into());
        block.movement = match (holds, to_point, by_vector) {
            (true, false, false) => {
                return Err(fault(Kind::MisplacedWord, "needs axis words, or I, J, K".into()));
            }
            (true, true, _) => {
                self.step(axes);
                self.moved_in = Some(self.plane);
                Movement::HeldVector { end: self.in_plane(&self.position) }
            }
            (true, ..) => Movement::NewVector { vector: self.vector(centres).ok_or_else(no_direction)? },
            (false, false, false) => Movement::CornerArc { vector: None },
            (false, true, _) => Movement::CornerArc { vector: Some(self.direction_to(axes).ok_or_else(no_direction)?) },
            (false, ..) => Movement::CornerArc { vector: Some(self.vector(centres).ok_or_else(no_direction)?) },
        };
        Ok(())
    }

    /// The vector of I, J, K beside a compensation code, which may be there and not have its effect: then none. `moves`
    /// says whether the block moves in the plane.
    pub(super) fn vector_beside(
        &self,
        code: Compensation,
        effect: Option<Compensation>,
        moves: bool,
        centres: [Option<&Word<'_>>; 3],
        first: Range<usize>,
    ) -> Result<Option<[Rational; 2]>, LineFault> {
        let (clause, side) = match code {
            Compensation::Off => (clause::TRC_CANCEL_08, "G40"),
            Compensation::On(_) if self.started => (clause::TRC_VEC_06, "a code of a side in mode"),
            Compensation::On(_) => (clause::TRC_START_10, "a code of a side at start-up"),
        };
        let fault = |message: String| LineFault::new(Kind::MisplacedWord, first.clone(), message).citing(clause);
        if !self.has_meaning(code) {
            let name = &self.profile.name;
            return Err(fault(format!("profile {name} gives I, J and K no meaning beside {side}")));
        }
        if !moves && !self.started && matches!(code, Compensation::On(_)) {
            return Err(fault(format!("I, J and K beside {side} stand in the block that moves")));
        }
        let vector =
            self.vector(centres).ok_or_else(|| fault("I, J and K give a direction of no length".to_owned()))?;
        Ok((effect == Some(code)).then_some(vector))
    }

    /// Whether I, J, K beside a compensation code mean something here.
    fn has_meaning(&self, code: Compensation) -> bool {
        let parameters = &self.profile.parameters;
        match code {
            Compensation::Off => parameters.cancel_vector != CancelVector::Refused,
            Compensation::On(_) => match parameters.side_code_vector {
                SideCodeVector::Refused => false,
                SideCodeVector::RightAngles => true,
                SideCodeVector::ImaginaryLine | SideCodeVector::ImaginaryPoint => {
                    !self.started && parameters.start_up != StartUp::EntryNormal
                }
            },
        }
    }

    /// Whether I, J, K alone beside a compensation code form a dummy block ([TRC-DUMMY-01]).
    pub(super) fn forms_dummy(&self, code: Compensation) -> bool {
        self.profile.machine.dummy == Dummy::Ijk && !self.has_meaning(code)
    }

    /// The vector of centre words in the plane, radius values; none if it is zero.
    fn vector(&self, centres: [Option<&Word<'_>>; 3]) -> Option<[Rational; 2]> {
        let vector = centres.map(|word| word.map(|word| self.length(word)).unwrap_or_default());
        not_zero(self.in_plane(&vector))
    }

    /// The vector from the programmed point to another, which stays where it is; none if they are one.
    fn direction_to(&self, axes: [Option<&Word<'_>>; 3]) -> Option<[Rational; 2]> {
        let mut vector: [Rational; 3] = Default::default();
        for (axis, word) in axes.into_iter().enumerate() {
            let Some(word) = word else { continue };
            let halves = word.letter == 'X' && self.profile.machine.x_words == Measure::Diameter;
            let value = if halves { self.length(word) / 2 } else { self.length(word) };
            vector[axis] = if self.incremental { value } else { value - &self.position[axis] };
        }
        not_zero(self.in_plane(&vector))
    }
}

fn not_zero(vector: [Rational; 2]) -> Option<[Rational; 2]> {
    vector.iter().any(|component| !component.is_zero()).then_some(vector)
}
