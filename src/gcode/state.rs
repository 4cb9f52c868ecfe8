//! The modal state of a program, and what one block does to it.

mod movement;

use radcomp_spec::clause;
use radcomp_spec::parameters::{Activation, CornerCodes, Plane};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Compensation, OuterCorner, Side};
use rug::Rational;

use super::arrange::{Command, Given};
use super::axes::{axes_of, name_of};
use super::codes::{Group, Meaning, Motion};
use super::diagnostic::{Kind, LineFault};
use super::offsets;
use super::tools::Tools;
use super::word::Word;

/// What is in force between two blocks.
#[derive(Debug)]
pub(super) struct State<'p> {
    profile: &'p Profile,
    tools: &'p Tools,
    plane: Plane,
    motion: Option<Motion>,
    inches: bool,
    incremental: bool,
    /// The side, while G41 or G42 is in force.
    side: Option<Side>,
    /// A block that moves has been read since the side came into force ([TRC-START-01]).
    started: bool,
    /// An offset number other than 0 is selected.
    offset: bool,
    /// A movement has been read.
    moved: bool,
    /// The programmed point, on the axes X, Y and Z, in millimetres and radius values.
    position: [Rational; 3],
}

impl<'p> State<'p> {
    pub(super) fn new(profile: &'p Profile, tools: &'p Tools) -> Self {
        State {
            profile,
            tools,
            plane: profile.machine.plane,
            motion: None,
            inches: false,
            incremental: false,
            side: None,
            started: false,
            offset: false,
            moved: false,
            position: Default::default(),
        }
    }

    pub(super) fn plane(&self) -> Plane {
        self.plane
    }

    /// The coordinate on the plane's normal axis.
    pub(super) fn normal(&self) -> &Rational {
        &self.position[axes_of(self.plane)[2]]
    }

    /// Executes a block. After a fault the state is of no use.
    pub(super) fn execute(&mut self, command: &Command<'_>) -> Result<Block<Rational>, LineFault> {
        let mut block = Block::empty();
        let mut compensation = None;
        let mut dwell = None;
        for given in command.codes() {
            match given.code.meaning {
                Meaning::Motion(motion) => self.motion = Some(motion),
                Meaning::Plane(plane) => self.choose_plane(plane, given)?,
                Meaning::Inches(inches) => self.inches = inches,
                Meaning::Incremental(incremental) => self.incremental = incremental,
                Meaning::Compensation(index) => compensation = Some((self.activation(index, given)?, given)),
                Meaning::Corner(corner) => block.corner = Some(self.corner(corner, given)?),
                Meaning::Dwell => dwell = Some(given),
                Meaning::SpindleLimit => spindle_limit(command, given)?,
                Meaning::End | Meaning::Nothing => {}
            }
        }
        self.select_offset(command, compensation.as_ref(), &mut block)?;
        if let Some((compensation, given)) = compensation {
            self.compensate(compensation, given)?;
            block.compensation = Some(compensation);
        }
        if let Some(dwell) = dwell {
            check_dwell(command, dwell)?;
        } else {
            self.move_axes(command, &mut block)?;
        }
        Ok(block)
    }

    fn choose_plane(&mut self, plane: Plane, given: &Given) -> Result<(), LineFault> {
        if plane == self.plane {
            return Ok(());
        }
        let fault = |message: String| {
            Err(LineFault::new(Kind::PlaneChange, given.span.clone(), message).citing(clause::TRC_PLANE_01))
        };
        let now = name_of(self.plane);
        if self.side.is_some() {
            return fault(format!(
                "the plane {now} cannot be left while compensation is on: G40 and a move come first"
            ));
        }
        if self.moved {
            return fault(format!(
                "the plane is {now} since the first movement; a change after it is not supported yet"
            ));
        }
        self.plane = plane;
        Ok(())
    }

    /// What a code of the activation table means.
    fn activation(&self, index: usize, given: &Given) -> Result<Compensation, LineFault> {
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

    fn corner(&self, corner: OuterCorner, given: &Given) -> Result<OuterCorner, LineFault> {
        match self.profile.machine.corner_codes {
            CornerCodes::M96M97 => Ok(corner),
            CornerCodes::None => {
                let message = format!("profile {} has no {}", self.profile.name, given.code);
                Err(LineFault::new(Kind::AbsentCode, given.span.clone(), message).citing(clause::TRC_CORNER_11))
            }
        }
    }

    fn select_offset(
        &mut self,
        command: &Command<'_>,
        compensation: Option<&(Compensation, &Given)>,
        block: &mut Block<Rational>,
    ) -> Result<(), LineFault> {
        let Some((number, word)) = offsets::selected(command, self.profile)? else { return Ok(()) };
        if number == 0 {
            let on = match compensation {
                Some((compensation, _)) => *compensation != Compensation::Off,
                None => self.side.is_some(),
            };
            if on {
                let message = "offset 0 cancels compensation, which is not supported yet; G40 cancels too";
                return Err(LineFault::new(Kind::OffsetZero, word.span.clone(), message).citing(clause::TRC_MODE_03));
            }
            self.offset = false;
            return Ok(());
        }
        match self.tools.radius_of(number) {
            None => {
                let message = format!("the tool table has no number {number}; {}", self.tools.listed());
                Err(LineFault::new(Kind::UnknownOffset, word.span.clone(), message))
            }
            Some(radius) => {
                self.offset = true;
                block.radius = Some(radius.clone());
                Ok(())
            }
        }
    }

    fn compensate(&mut self, compensation: Compensation, given: &Given) -> Result<(), LineFault> {
        match compensation {
            Compensation::Off => (self.side, self.started) = (None, false),
            Compensation::On(_) if !self.offset => {
                let word = if offsets::t_selects_offset(self.profile) { "T0101" } else { "D1" };
                let message = format!("no offset is selected: a word such as {word} has to come first or stand here");
                let fault = LineFault::new(Kind::NoOffset, given.span.clone(), message);
                return Err(fault.citing(clause::TRC_MODE_03));
            }
            Compensation::On(side) => self.side = Some(side),
        }
        Ok(())
    }
}

/// G50 limits the spindle speed if S stands alone with it; with axis words it would shift the coordinates.
fn spindle_limit(command: &Command<'_>, given: &Given) -> Result<(), LineFault> {
    let other = command.words().find(|word| !"NS".contains(word.letter));
    match (other, command.word('S')) {
        (None, Some(_)) => Ok(()),
        _ => {
            let message = "G50 is supported with an S word alone, as the limit of the spindle speed";
            Err(LineFault::new(Kind::UnsupportedCode, given.span.clone(), message))
        }
    }
}

/// G04 has one time, as X, U or P, and moves nothing.
fn check_dwell(command: &Command<'_>, given: &Given) -> Result<(), LineFault> {
    let mut time: Option<&Word<'_>> = None;
    for word in command.words() {
        let message = match word.letter {
            'X' | 'U' | 'P' => match time {
                None if word.number.starts_with('-') => {
                    let message = "a time is not negative";
                    return Err(LineFault::new(Kind::WrongNumber, word.span.clone(), message));
                }
                None => {
                    time = Some(word);
                    continue;
                }
                Some(first) => format!("{} is the time of this dwell already", first.letter),
            },
            'Y' | 'Z' | 'I' | 'J' | 'K' | 'R' => "a block with G04 does not move".to_owned(),
            _ => continue,
        };
        return Err(LineFault::new(Kind::MisplacedWord, word.span.clone(), message).citing(clause::TRC_LOOK_01));
    }
    if let Some(motion) = command.code(Group::Motion) {
        let message = format!("G04 and {} exclude each other in one block", motion.code);
        return Err(LineFault::new(Kind::ConflictingCodes, motion.span.clone(), message));
    }
    match time {
        Some(_) => Ok(()),
        None => Err(LineFault::new(Kind::MissingTime, given.span.clone(), "G04 needs a time: X, U or P")),
    }
}
