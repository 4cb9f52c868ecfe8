//! Compensation codes and offset numbers: [TRC-PLANE-05], [TRC-MODE-03], [TRC-CANCEL-07], [TRC-TIP-01].

use radcomp_spec::parameters::{Activation, OffsetZero, Tip};
use radcomp_spec::{Block, Compensation, Side, clause};
use rug::Rational;

use super::{Offset, State};
use crate::gcode::Nose;
use crate::gcode::arrange::{Command, Given};
use crate::gcode::diagnostic::{Kind, LineFault};
use crate::gcode::offsets;
use crate::gcode::tools::Tool;
use crate::gcode::word::Word;

impl State<'_> {
    /// What a code of the activation table means.
    pub(super) fn activation(&self, index: usize, given: &Given) -> Result<Compensation, LineFault> {
        let (code, name) = (given.code, &self.profile.name);
        let fault = |kind, message| LineFault::new(kind, given.span.clone(), message).citing(clause::TRC_PLANE_05);
        match self.profile.activation[index] {
            Activation::Cancel => Ok(Compensation::Off),
            Activation::Left => Ok(Compensation::On(Side::Left)),
            Activation::Right => Ok(Compensation::On(Side::Right)),
            Activation::Absent => {
                let codes = ["G40", "G41", "G42", "G43", "G44"].into_iter().zip(self.profile.activation);
                let known: Vec<_> =
                    codes.filter(|(_, means)| *means != Activation::Absent).map(|(code, _)| code).collect();
                let message =
                    format!("profile {name} has no {code}; its codes of compensation are {}", known.join(", "));
                Err(fault(Kind::AbsentCode, message))
            }
            Activation::Undeclared => {
                let message = format!("the sources of profile {name} do not tell what {code} does");
                let help = format!(
                    "a profile of your own can declare it; put into a file, with \"left\", \"right\" or \"cancel\":\n\n\
                     name = \"my-{name}\"\n\
                     title = \"{name} with {code} declared\"\n\
                     extends = \"{name}\"\n\
                     [activation]\n\
                     {code} = {{ value = \"left\", source = \"D\", clause = \"{}\" }}",
                    clause::TRC_PLANE_05
                );
                Err(fault(Kind::UndeclaredCode, message).helping(help))
            }
        }
    }

    /// Whether the program is in mode: after a block with G41 or G42, an offset number other than 0 being in force.
    pub(super) fn in_mode(&self) -> bool {
        self.side.is_some() && self.offset == Offset::Number
    }

    /// Executes the compensation code and the offset number of a block.
    pub(super) fn compensate(
        &mut self,
        command: &Command<'_>,
        code: Option<(Compensation, &Given)>,
        block: &mut Block<Rational>,
    ) -> Result<(), LineFault> {
        let (before, nose_before) = (self.in_mode(), self.nose.clone());
        let selected = self.select_offset(command, block)?;
        match code {
            Some((Compensation::Off, _)) => self.side = None,
            Some((Compensation::On(side), given)) => {
                self.check_offset(given)?;
                self.side = Some(side);
            }
            None => {}
        }
        if self.side.is_some() && self.offset == Offset::Zero {
            let place = selected.map(|word| word.span.clone()).or(code.map(|(_, given)| given.span.clone()));
            self.check_zero(place.unwrap_or_default())?;
        }
        // While number 0 is in force the codes stay, but start nothing; a number puts them to work again.
        block.compensation = match (code, before, self.in_mode()) {
            (Some((Compensation::Off, _)), ..) | (_, true, false) => Some(Compensation::Off),
            (_, false, true) => self.side.map(Compensation::On),
            (code, true, true) => code.map(|(code, _)| code),
            (_, false, false) => None,
        };
        let off = block.compensation == Some(Compensation::Off);
        self.started &= !off;
        self.nose_of_block = if off { nose_before } else { self.nose.clone() };
        Ok(())
    }

    /// Selects the offset number of a block, and says by which word.
    fn select_offset<'c, 'a>(
        &mut self,
        command: &'c Command<'a>,
        block: &mut Block<Rational>,
    ) -> Result<Option<&'c Word<'a>>, LineFault> {
        self.orientation = None;
        let Some((number, word)) = offsets::selected(command, self.profile)? else { return Ok(None) };
        if number == 0 {
            self.offset = Offset::Zero;
            return Ok(Some(word));
        }
        let Some(tool) = self.tools.tool(number) else {
            let message = format!("the tool table has no number {number}; {}", self.tools.listed());
            return Err(LineFault::new(Kind::UnknownOffset, word.span.clone(), message));
        };
        self.offset = Offset::Number;
        self.nose = self.nose_of(tool, word)?;
        self.orientation = tool.orientation;
        block.radius = Some(tool.radius());
        Ok(Some(word))
    }

    /// The nose of a tool, if it has an orientation.
    fn nose_of(&self, tool: &Tool, word: &Word<'_>) -> Result<Option<Nose>, LineFault> {
        let Some(orientation) = tool.orientation else { return Ok(None) };
        match self.profile.tips[usize::from(orientation.min(9))] {
            Tip::Absent => {
                let (number, name) = (word.number, &self.profile.name);
                let message =
                    format!("tool {number} has the orientation {orientation}, which profile {name} does not have");
                let fault = LineFault::new(Kind::AbsentOrientation, word.span.clone(), message);
                Err(fault.citing(clause::TRC_TIP_01))
            }
            tip => Ok(Some(Nose { radius: tool.radius().abs(), tip })),
        }
    }

    /// A side needs an offset number.
    fn check_offset(&self, given: &Given) -> Result<(), LineFault> {
        if self.offset != Offset::Unset {
            return Ok(());
        }
        let word = if offsets::t_selects_offset(self.profile) { "T0101" } else { "D1" };
        let message = format!("no offset is selected: a word such as {word} has to come first or stand here");
        Err(LineFault::new(Kind::NoOffset, given.span.clone(), message).citing(clause::TRC_MODE_03))
    }

    /// A side and number 0 together.
    fn check_zero(&self, place: std::ops::Range<usize>) -> Result<(), LineFault> {
        match self.profile.machine.offset_zero {
            OffsetZero::Cancel => Ok(()),
            OffsetZero::Refused => {
                let name = &self.profile.name;
                let message =
                    format!("profile {name} does not tell what offset 0 does to compensation; G40 cancels it");
                Err(LineFault::new(Kind::OffsetZero, place, message).citing(clause::TRC_CANCEL_07))
            }
        }
    }
}
