//! Programs for certification: random, but full of what decides something.
//!
//! Directions are axis-parallel, diagonal and Pythagorean, arcs have rational centres and ends exactly on them, tools
//! fit exactly as often as not, and every program comes three times: as made, and with one number moved by one least
//! increment down and up. One seed gives the same programs on every machine, each one independent of the others. Half of
//! them show a single feature ([`Shape`]).

mod codes;
mod contour;
mod dice;
mod features;
mod shape;
mod single;
mod step;
mod vectors;

use radcomp_spec::parameters::{
    ApproachCodes, CancelVector, CornerCodes, Dummy, InMode, NegativeRadius, OffsetChange, ReadAheadStop, SameCode,
    SideChange, SideCodeVector, StartUp, StartUpArc, ToolChange, VectorCodes,
};
use radcomp_spec::profile::{Machine, Profile};
use radcomp_spec::{AlarmKind, Block, OuterCorner, Parameters};
use rug::Rational;

use dice::Dice;
pub use shape::Shape;

/// What a profile lets programs hold, and what makes its own rules speak.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    machine: Machine,
    parameters: Parameters,
}

impl Reach {
    /// What a profile's programs may hold.
    pub fn of(profile: &Profile) -> Self {
        Reach { machine: profile.machine, parameters: profile.parameters }
    }

    /// The parameters of the profile.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Blocks without movement allowed between moves; none: any number.
    pub fn non_moving_allowed(&self) -> Option<u8> {
        self.parameters.non_moving_allowed
    }

    /// Dummy blocks exist.
    pub fn dummies(&self) -> bool {
        self.machine.dummy == Dummy::Ijk
    }

    /// M00 and M01 break the look-ahead ([TRC-LOOK-08]).
    pub fn stops(&self) -> bool {
        self.machine.read_ahead_stop == ReadAheadStop::BreaksLookAhead
    }

    /// The outer corners that codes choose ([TRC-CORNER-11]).
    pub fn corners(&self) -> &'static [OuterCorner] {
        match self.machine.corner_codes {
            CornerCodes::None => &[],
            CornerCodes::M96M97 => &[OuterCorner::Arc, OuterCorner::Intersection],
            CornerCodes::G450G451 => &[OuterCorner::Arc, OuterCorner::LimitAngle],
        }
    }

    /// NORM and KONT exist ([TRC-START-12]).
    fn approaches(&self) -> bool {
        self.machine.approach_codes == ApproachCodes::NormKont
    }

    /// The alarms of codes that are not for offset mode ([TRC-MODE-08]).
    fn not_in_mode(&self) -> Vec<AlarmKind> {
        let machine = &self.machine;
        let codes = [
            (machine.plane_change == InMode::Alarm, AlarmKind::PlaneChangeInMode),
            (machine.reference_return == InMode::Alarm, AlarmKind::ReferenceReturnInMode),
            (machine.machine_coordinates == InMode::Alarm, AlarmKind::MachineCoordinatesInMode),
            (machine.set_coordinates == InMode::Alarm, AlarmKind::SetCoordinatesInMode),
            (machine.tool_change == ToolChange::Alarm, AlarmKind::ToolChangeInMode),
            (machine.canned_cycle == InMode::Alarm, AlarmKind::CannedCycleInMode),
        ];
        codes.into_iter().filter_map(|(alarm, kind)| alarm.then_some(kind)).collect()
    }

    /// G38 and G39 exist ([TRC-VEC-01]).
    pub fn vector_codes(&self) -> bool {
        self.machine.vector_codes == VectorCodes::G38G39
    }

    /// I, J, K beside G41 and G42 mean something at start-up ([TRC-START-10], [TRC-START-11]).
    fn vectors_at_start_up(&self) -> bool {
        match self.parameters.side_code_vector {
            SideCodeVector::Refused => false,
            SideCodeVector::RightAngles => true,
            SideCodeVector::ImaginaryLine | SideCodeVector::ImaginaryPoint => {
                self.parameters.start_up != StartUp::EntryNormal
            }
        }
    }

    /// They mean something in mode ([TRC-VEC-06]).
    fn vectors_in_mode(&self) -> bool {
        self.parameters.side_code_vector == SideCodeVector::RightAngles
    }

    /// I, J, K beside G40 mean something ([TRC-CANCEL-08]).
    pub fn vectors_at_cancel(&self) -> bool {
        self.parameters.cancel_vector != CancelVector::Refused
    }

    /// The offset value may change in mode ([TRC-MODE-11]).
    fn changes_offset(&self) -> bool {
        self.parameters.offset_change == OffsetChange::EndOfBlock
    }

    /// An arc may start up ([TRC-START-09]).
    pub fn starts_on_arcs(&self) -> bool {
        self.parameters.start_up_arc == StartUpArc::MovedCentre
    }

    /// The entry move has to be longer than the radius ([TRC-START-07], [TRC-START-09]).
    fn asks_entry_length(&self) -> bool {
        self.parameters.start_up == StartUp::EntryNormal || self.starts_on_arcs()
    }

    /// A negative radius swaps the sides ([TRC-SIDE-07]).
    fn negative_radii(&self) -> bool {
        self.parameters.negative_radius == NegativeRadius::SwapsSides
    }

    /// One block in so many changes the side: few where that ends the program.
    fn side_change_one_in(&self) -> usize {
        if self.parameters.side_change == SideChange::Forbidden { 60 } else { 9 }
    }

    /// One block in so many gives the code in force again.
    fn same_code_one_in(&self) -> usize {
        match self.parameters.same_code {
            SameCode::Ordinary => 25,
            SameCode::Normal => 10,
            SameCode::Alarm => 60,
        }
    }
}

/// The program with this number in the sequence of a seed; about five blocks with a single feature, or ten.
pub fn program(seed: u64, number: u64, reach: Reach) -> Vec<Block<Rational>> {
    // Three programs in a row share what they are made of.
    let mut dice = Dice::new(seed, number / 3);
    let mut blocks = match Shape::of(number) {
        Shape::WholeProgram => whole(&mut dice, reach),
        shape => single::program(shape, &mut dice, reach),
    };
    match number % 3 {
        0 => {}
        1 => features::nudge(&mut blocks, &mut dice, -1),
        _ => features::nudge(&mut blocks, &mut dice, 1),
    }
    blocks
}

/// A program with everything that the profile has words for.
fn whole(dice: &mut Dice, reach: Reach) -> Vec<Block<Rational>> {
    let contour = contour::contour(dice, reach);
    let mut blocks = codes::with_codes(contour, dice, reach);
    vectors::give(&mut blocks, dice, reach);
    features::decorate(&mut blocks, 5, dice, reach);
    blocks
}

/// A number of thousandths of a millimetre.
fn thousandths(value: i64) -> Rational {
    Rational::from((value, 1000))
}
