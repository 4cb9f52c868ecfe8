//! The modal state of a program, and what one block does to it.

mod compensation;
mod in_mode;
mod movement;
mod vector;

use radcomp_spec::parameters::{ApproachCodes, CornerCodes, Plane, ReadAheadStop, StartUpWithoutMovement};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Approach, Block, Compensation, OuterCorner, Side, clause};
use rug::Rational;

use super::Nose;
use super::arrange::{Command, Given};
use super::axes::axes_of;
use super::codes::{Group, Meaning, Motion};
use super::diagnostic::{Kind, LineFault};
use super::tools::Tools;
use super::word::Word;

/// What is in force between two blocks.
#[derive(Debug)]
pub(super) struct State<'p> {
    profile: &'p Profile,
    tools: &'p Tools,
    plane: Plane,
    /// The plane of the movements, once there is one.
    moved_in: Option<Plane>,
    motion: Option<Motion>,
    inches: bool,
    incremental: bool,
    /// The side of the last G41 or G42, until G40.
    side: Option<Side>,
    offset: Offset,
    /// A start-up block has been read since compensation came into force ([TRC-START-01]).
    started: bool,
    /// The programmed point, on the axes X, Y and Z, in millimetres and radius values.
    position: [Rational; 3],
    /// The nose of the tool that is selected ([TRC-TIP-01]).
    nose: Option<Nose>,
    /// The nose at the vectors of the last block: a block with G40 still has those of the tool before it.
    nose_of_block: Option<Nose>,
    /// The orientation of the tool that the last block selected.
    orientation: Option<u8>,
}

/// The offset number in force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Offset {
    /// None yet.
    Unset,
    /// Number 0 ([TRC-CANCEL-07]).
    Zero,
    /// Another number.
    Number,
}

impl<'p> State<'p> {
    pub(super) fn new(profile: &'p Profile, tools: &'p Tools) -> Self {
        State {
            profile,
            tools,
            plane: profile.machine.plane,
            moved_in: None,
            motion: None,
            inches: false,
            incremental: false,
            side: None,
            offset: Offset::Unset,
            started: false,
            position: Default::default(),
            nose: None,
            nose_of_block: None,
            orientation: None,
        }
    }

    /// The plane of the movements; before the first of them the plane in force.
    pub(super) fn plane(&self) -> Plane {
        self.moved_in.unwrap_or(self.plane)
    }

    /// The coordinate on the plane's normal axis.
    pub(super) fn normal(&self) -> &Rational {
        &self.position[axes_of(self.plane())[2]]
    }

    /// The nose at the vectors of the last block; none for a tool without an orientation.
    pub(super) fn nose(&self) -> Option<&Nose> {
        self.nose_of_block.as_ref()
    }

    /// The orientation of the tool that the last block selected, if it selected one that has an orientation.
    pub(super) fn orientation(&self) -> Option<u8> {
        self.orientation
    }

    /// Executes a block. After a fault the state is of no use.
    pub(super) fn execute(&mut self, command: &Command<'_>) -> Result<Block<Rational>, LineFault> {
        let mut block = Block::empty();
        let (mut compensation, mut dwell, mut plane, mut vector) = (None, None, None, None);
        for given in command.codes() {
            match given.code.meaning {
                Meaning::Motion(motion) => self.motion = Some(motion),
                Meaning::Plane(chosen) => plane = Some(chosen),
                Meaning::Inches(inches) => self.inches = inches,
                Meaning::Incremental(incremental) => self.incremental = incremental,
                Meaning::Compensation(index) => compensation = Some((self.activation(index, given)?, given)),
                Meaning::Corner(codes, corner) => block.corner = Some(self.corner(codes, corner, given)?),
                Meaning::Approach(approach) => block.approach = Some(self.approach(approach, given)?),
                Meaning::HeldVector | Meaning::CornerArc => vector = Some(self.vector_code(given)?),
                Meaning::Dwell => dwell = Some(given),
                Meaning::Stop => {
                    block.stops_look_ahead = self.profile.machine.read_ahead_stop == ReadAheadStop::BreaksLookAhead;
                }
                Meaning::SpindleLimit
                | Meaning::NotInMode(_)
                | Meaning::ToolChange
                | Meaning::End
                | Meaning::Nothing => {}
            }
        }
        self.compensate(command, compensation, &mut block)?;
        block.not_in_mode = self.not_in_mode(command)?;
        if block.not_in_mode.is_some() {
            // Its other words are not looked at ([TRC-MODE-08]).
            return Ok(block);
        }
        self.plane = plane.unwrap_or(self.plane);
        match (dwell, vector) {
            (Some(dwell), None) => check_dwell(command, dwell)?,
            (_, Some(vector)) => self.vector_block(command, vector, &mut block)?,
            (None, None) => self.move_axes(command, compensation.map(|(code, _)| code), &mut block)?,
        }
        let shifts = self.profile.parameters.start_up_without_movement == StartUpWithoutMovement::Shift;
        self.started |= shifts && matches!(block.compensation, Some(Compensation::On(_)));
        Ok(block)
    }

    /// Start-up and cancel as this code chooses them.
    fn approach(&self, approach: Approach, given: &Given) -> Result<Approach, LineFault> {
        if self.profile.machine.approach_codes == ApproachCodes::NormKont {
            return Ok(approach);
        }
        let message = format!("profile {} has no {}", self.profile.name, given.code);
        Err(LineFault::new(Kind::AbsentCode, given.span.clone(), message).citing(clause::TRC_START_12))
    }

    /// An outer corner that these codes choose.
    fn corner(&self, codes: CornerCodes, corner: OuterCorner, given: &Given) -> Result<OuterCorner, LineFault> {
        if self.profile.machine.corner_codes == codes {
            return Ok(corner);
        }
        let message = format!("profile {} has no {}", self.profile.name, given.code);
        Err(LineFault::new(Kind::AbsentCode, given.span.clone(), message).citing(clause::TRC_CORNER_11))
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
