//! The movement of a block: straight moves, arcs, dummy blocks ([TRC-LOOK-01], [TRC-ARC-01], [TRC-DUMMY-01]).

use std::ops::Range;

use radcomp_spec::clause;
use radcomp_spec::parameters::{Dummy, Measure};
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement};
use rug::Rational;

use super::State;
use crate::gcode::arrange::Command;
use crate::gcode::axes::{AXES, CENTRES, axes_of, name_of};
use crate::gcode::codes::Motion;
use crate::gcode::diagnostic::{Kind, LineFault};
use crate::gcode::word::Word;

impl State<'_> {
    /// Reads the axis, centre and radius words of a block into its movement, or the centre words into the vector beside
    /// its compensation code.
    pub(super) fn move_axes(
        &mut self,
        command: &Command<'_>,
        code: Option<Compensation>,
        block: &mut Block<Rational>,
    ) -> Result<(), LineFault> {
        for letter in ['P', 'U'] {
            if let Some(word) = command.word(letter) {
                return Err(word_of_dwell(word));
            }
        }
        let (axes, centres, radius) = (command.words_of(AXES), command.words_of(CENTRES), command.word('R'));
        let given = |words: [Option<&Word<'_>>; 3]| words.into_iter().flatten().next().map(|word| word.span.clone());
        let (axis, centre) = (given(axes), given(centres));
        let moves_axes = axis.is_some();
        let Some(first) = axis.or_else(|| centre.clone()).or(radius.map(|word| word.span.clone())) else {
            return Ok(());
        };
        let Some(motion) = self.motion else {
            let message = "no G00, G01, G02 or G03 is in force: one has to come first or stand here";
            return Err(LineFault::new(Kind::NoMotion, first, message));
        };
        self.stay_in_plane(&first)?;
        let from = self.position.clone();
        self.step(axes);
        block.movement = match motion {
            Motion::Arc(direction) => self.arc(direction, centres, radius, first)?,
            Motion::Rapid | Motion::Feed => match (radius, centre, moves_axes) {
                (Some(radius), ..) => return Err(word_of_arc(radius.span.clone())),
                (None, Some(centre), _)
                    if let Some(code) = code.filter(|code| moves_axes || !self.forms_dummy(*code)) =>
                {
                    let moves = self.moves_from(&from);
                    block.vector = self.vector_beside(code, block.compensation, moves, centres, centre)?;
                    self.line(axes)
                }
                (None, Some(centre), true) => return Err(word_of_arc(centre)),
                (None, Some(centre), false) => self.dummy(centres, centre)?,
                (None, None, _) => self.line(axes),
            },
        };
        // A dummy block owns corner moves ([TRC-DUMMY-02]), so its rate counts too.
        block.rapid = motion == Motion::Rapid;
        if moves_axes || matches!(block.movement, Movement::Arc { .. }) {
            self.moved_in = Some(self.plane);
        }
        let moves = match block.movement {
            Movement::Line { .. } => self.moves_from(&from),
            Movement::Arc { .. } => true,
            _ => false,
        };
        self.started |= moves && self.in_mode();
        Ok(())
    }

    /// Whether the programmed point stands elsewhere in the plane than before.
    fn moves_from(&self, before: &[Rational; 3]) -> bool {
        let [a, b, _] = axes_of(self.plane);
        before[a] != self.position[a] || before[b] != self.position[b]
    }

    /// All movements of a program are in one plane.
    pub(super) fn stay_in_plane(&self, first: &Range<usize>) -> Result<(), LineFault> {
        match self.moved_in {
            Some(before) if before != self.plane => {
                let (before, now) = (name_of(before), name_of(self.plane));
                let message = format!(
                    "the movements so far are in {before}, and {now} is in force; movements in two planes are not supported yet"
                );
                Err(LineFault::new(Kind::PlaneChange, first.clone(), message).citing(clause::TRC_PLANE_01))
            }
            _ => Ok(()),
        }
    }

    /// Moves the programmed point; diameters are halved ([TRC-PLANE-03]).
    pub(super) fn step(&mut self, axes: [Option<&Word<'_>>; 3]) {
        for (axis, word) in axes.into_iter().enumerate() {
            let Some(word) = word else { continue };
            let mut value = self.length(word);
            if word.letter == 'X' && self.profile.machine.x_words == Measure::Diameter {
                value /= 2;
            }
            match self.incremental {
                true => self.position[axis] += value,
                false => self.position[axis] = value,
            }
        }
    }

    fn line(&self, axes: [Option<&Word<'_>>; 3]) -> Movement<Rational> {
        let [a, b, _] = axes_of(self.plane);
        match axes[a].is_some() || axes[b].is_some() {
            true => Movement::Line { end: self.in_plane(&self.position) },
            false => Movement::None,
        }
    }

    fn arc(
        &self,
        direction: Direction,
        centres: [Option<&Word<'_>>; 3],
        radius: Option<&Word<'_>>,
        first: Range<usize>,
    ) -> Result<Movement<Rational>, LineFault> {
        let [a, b, normal] = axes_of(self.plane);
        if let Some(word) = centres[normal] {
            let (plane, [i, j]) = (name_of(self.plane), [CENTRES[a], CENTRES[b]]);
            let message = format!("the centre words of the plane {plane} are {i} and {j}");
            let fault = LineFault::new(Kind::CentreOffPlane, word.span.clone(), message);
            return Err(fault.citing(clause::TRC_PLANE_01));
        }
        let centre = match (radius, centres[a].is_some() || centres[b].is_some()) {
            (Some(radius), true) => {
                let message = "an arc has a centre or an R, not both";
                return Err(arc_fault(Kind::CentreAndRadius, radius.span.clone(), message));
            }
            (None, false) => {
                let message = format!("an arc needs {} and {}, or R", CENTRES[a], CENTRES[b]);
                let help = "a straight move needs G01 or G00, as G02 and G03 stay in force";
                return Err(arc_fault(Kind::NoCentre, first, message).helping(help));
            }
            (Some(radius), false) => Centre::Radius(self.length(radius)),
            (None, true) => {
                let offset = centres.map(|word| word.map(|word| self.length(word)).unwrap_or_default());
                Centre::FromStart(self.in_plane(&offset))
            }
        };
        Ok(Movement::Arc { end: self.in_plane(&self.position), centre, direction })
    }

    fn dummy(&self, centres: [Option<&Word<'_>>; 3], first: Range<usize>) -> Result<Movement<Rational>, LineFault> {
        let fault =
            |message: String| LineFault::new(Kind::DummyRefused, first.clone(), message).citing(clause::TRC_DUMMY_01);
        let [a, b, _] = axes_of(self.plane);
        if self.profile.machine.dummy == Dummy::None {
            return Err(fault(format!(
                "I, J and K alone are a dummy block, and profile {} has none",
                self.profile.name
            )));
        }
        if !self.in_mode() {
            return Err(fault("I, J and K alone are a dummy block, which stands in offset mode only".to_owned()));
        }
        if !self.started {
            return Err(fault("a dummy block comes after the start-up block".to_owned()));
        }
        let mut vector = centres.map(|word| word.map(|word| self.length(word)).unwrap_or_default());
        // [TRC-DUMMY-05]
        if self.profile.machine.dummy_first_axis == Measure::Diameter {
            vector[0] /= 2;
        }
        let vector = self.in_plane(&vector);
        if vector.iter().all(|component| component.is_zero()) {
            let [i, j] = [CENTRES[a], CENTRES[b]];
            return Err(fault(format!("a dummy block needs {i} or {j} other than 0: it gives a direction")));
        }
        Ok(Movement::Dummy { vector })
    }

    /// The plane's coordinates of a point or a vector.
    pub(super) fn in_plane(&self, point: &[Rational; 3]) -> [Rational; 2] {
        let [a, b, _] = axes_of(self.plane);
        [point[a].clone(), point[b].clone()]
    }

    /// A length in millimetres.
    pub(super) fn length(&self, word: &Word<'_>) -> Rational {
        match self.inches {
            true => word.value() * Rational::from((254, 10)),
            false => word.value(),
        }
    }
}

fn arc_fault(kind: Kind, span: Range<usize>, message: impl Into<String>) -> LineFault {
    LineFault::new(kind, span, message).citing(clause::TRC_ARC_01)
}

/// I, J, K or R in a straight move.
pub(super) fn word_of_arc(span: Range<usize>) -> LineFault {
    arc_fault(Kind::MisplacedWord, span, "a straight move has no centre and no radius; G02 or G03 makes it an arc")
}

/// P or U in a block that is not a dwell.
pub(super) fn word_of_dwell(word: &Word<'_>) -> LineFault {
    match word.letter {
        'U' => {
            let message = "incremental axis words are not supported: G91 with X says the same";
            LineFault::new(Kind::UnsupportedWord, word.span.clone(), message)
        }
        _ => LineFault::new(Kind::MisplacedWord, word.span.clone(), "P is the time of a dwell: G04"),
    }
}
