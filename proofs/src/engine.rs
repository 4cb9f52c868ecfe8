//! The whole engine on arbitrary blocks and bit patterns: no panic, no coordinate that is not finite, every block's own
//! step once and in order, and nothing at all after an alarm. [TRC-MODE-06], [TRC-MODE-07]

use radcomp_impl::{Engine, Sink};
use radcomp_spec::parameters::*;
use radcomp_spec::{
    Alarm, AlarmKind, Block, Centre, Compensation, Direction, Movement, Parameters, Segment, Side, Step,
};

use crate::{Choice, reached};

/// Watches the path.
#[derive(Clone, Debug, Default)]
struct Ledger {
    /// The block whose own step comes next.
    next: usize,
    /// Steps in all.
    steps: usize,
}

impl Sink for Ledger {
    fn step(&mut self, step: Step<f64>) {
        assert!(is_finite(&step.segment), "a coordinate is finite");
        self.steps += 1;
        if step.main || step.segment == Segment::Hold {
            assert!(step.block == self.next, "the own steps of blocks come in order, none lost and none twice");
            self.next += 1;
        } else {
            // A corner's moves belong to the block behind it, or to the one before, whose own step came last.
            assert!(step.block == self.next || step.block + 1 == self.next, "corner moves come at their block");
        }
    }
}

fn is_finite(segment: &Segment<f64>) -> bool {
    let finite = |point: &[f64; 2]| point[0].is_finite() && point[1].is_finite();
    match segment {
        Segment::Line { end } => finite(end),
        Segment::Arc { end, centre, .. } => finite(end) && finite(centre),
        Segment::Hold => true,
    }
}

/// Any parameters.
pub fn parameters(choice: &mut impl Choice) -> Parameters {
    // The least cosine or limit means that there is none, where a profile may say so.
    let cosines = [NONE, Ratio { numerator: 3, denominator: 5 }, Ratio { numerator: 1, denominator: 1 }];
    Parameters {
        start_up: choice.of(&[StartUp::TypeA, StartUp::TypeB, StartUp::EntryNormal]),
        start_up_b: choice.of(&[StartUpB::ViaNormal, StartUpB::Direct]),
        outer_corner: choice.of(&[OuterCorner::Intersection, OuterCorner::Arc, OuterCorner::LimitAngle]),
        reversal: choice.of(&[Reversal::Outer, Reversal::Alarm]),
        side_change: choice.of(&[
            SideChange::IntersectionWithin,
            SideChange::Intersection,
            SideChange::Crossing,
            SideChange::TwoNormals,
            SideChange::Forbidden,
        ]),
        corner_owner: choice.of(&[CornerOwner::Next, CornerOwner::Previous]),
        reversed_path: choice.of(&[ReversedPath::Advisory, ReversedPath::Alarm]),
        corner_limit_cosine: choice.of(&cosines),
        arc_extension: choice.of(&[ArcExtension::Tangent, ArcExtension::Curve]),
        smallest_corner_cosine: choice.of(&cosines),
        straight_band_cosine: choice.of(&cosines),
        arc_on_rapid: choice.of(&[ArcOnRapid::Arc, ArcOnRapid::Line]),
        small_vector_limit: choice.of(&cosines),
        negative_radius: choice.of(&[NegativeRadius::Alarm, NegativeRadius::SwapsSides]),
        equal_radius: choice.of(&[EqualRadius::Alarm, EqualRadius::DegeneratePoint]),
        zero_length_move: choice.of(&[
            ZeroLengthMove::NoMovement,
            ZeroLengthMove::BreaksLookAhead,
            ZeroLengthMove::StartsAndCancels,
        ]),
        pending_at_alarm: choice.of(&[PendingAtAlarm::Ended, PendingAtAlarm::Lost]),
        side_code_vector: choice.of(&[
            SideCodeVector::RightAngles,
            SideCodeVector::ImaginaryLine,
            SideCodeVector::ImaginaryPoint,
        ]),
        cancel_vector: choice.of(&[CancelVector::Refused, CancelVector::ImaginaryLine]),
        offset_change: choice.of(&[OffsetChange::Alarm, OffsetChange::EndOfBlock]),
        chord_tolerance: choice.of(&cosines),
        centre_tolerance: choice.of(&cosines),
        interference: choice.of(&[
            Interference::Off,
            Interference::RemoveVectors,
            Interference::Alarm,
            Interference::Avoid,
        ]),
        interference_blocks: choice.of(&[
            InterferenceBlocks::Three,
            InterferenceBlocks::Five,
            InterferenceBlocks::Eight,
        ]),
        interference_boundary: choice.of(&[InterferenceBoundary::Strict, InterferenceBoundary::Inclusive]),
        ..crate::look_ahead::parameters(choice, MOST_NON_MOVING)
    }
}

const NONE: Ratio = Ratio { numerator: 0, denominator: 1 };

/// The parameters of every harness whose subject is not the parameters.
#[must_use]
pub fn plain() -> Parameters {
    Parameters {
        start_up: StartUp::TypeA,
        start_up_b: StartUpB::ViaNormal,
        start_up_lost: StartUpLost::Normal,
        start_up_without_movement: StartUpWithoutMovement::None,
        start_up_arc: StartUpArc::Alarm,
        cancel: Cancel::TypeA,
        cancel_without_movement: CancelWithoutMovement::None,
        outer_corner: OuterCorner::Intersection,
        reversal: Reversal::Outer,
        side_change: SideChange::IntersectionWithin,
        side_change_after_start_up: SideChangeAfterStartUp::Allowed,
        non_moving_allowed: Some(2),
        corner_owner: CornerOwner::Next,
        reversed_path: ReversedPath::Alarm,
        arc_end_tolerance: Ratio { numerator: 1, denominator: 100 },
        far_intersection: Ratio { numerator: 5, denominator: 1 },
        corner_limit_cosine: NONE,
        arc_extension: ArcExtension::Tangent,
        smallest_corner_cosine: NONE,
        straight_band_cosine: NONE,
        arc_on_rapid: ArcOnRapid::Arc,
        small_vector_limit: NONE,
        same_code: SameCode::Ordinary,
        negative_radius: NegativeRadius::Alarm,
        equal_radius: EqualRadius::Alarm,
        zero_length_move: ZeroLengthMove::NoMovement,
        pending_at_alarm: PendingAtAlarm::Ended,
        side_code_vector: SideCodeVector::Refused,
        cancel_vector: CancelVector::Refused,
        offset_change: OffsetChange::Alarm,
        chord_tolerance: NONE,
        centre_tolerance: NONE,
        interference: Interference::Off,
        interference_blocks: InterferenceBlocks::Three,
        interference_boundary: InterferenceBoundary::Strict,
    }
}

/// Any movement of one of the first `kinds` kinds: none, line, dummy block, arc.
fn movement(choice: &mut impl Choice, kinds: u8) -> Movement<f64> {
    let kind = choice.below(kinds);
    if kind == 0 {
        return Movement::None;
    }
    let end = [choice.number(), choice.number()];
    match kind {
        1 => Movement::Line { end },
        2 => Movement::Dummy { vector: end },
        _ => {
            let by_radius = choice.flag();
            let centre = if by_radius {
                Centre::Radius(choice.number())
            } else {
                Centre::FromStart([choice.number(), choice.number()])
            };
            Movement::Arc { end, centre, direction: choice.of(&[Direction::Clockwise, Direction::Counterclockwise]) }
        }
    }
}

/// Any block whose movement is of one of the first `kinds` kinds.
pub fn block(choice: &mut impl Choice, kinds: u8) -> Block<f64> {
    let (left, right) = (Compensation::On(Side::Left), Compensation::On(Side::Right));
    Block {
        movement: movement(choice, kinds),
        rapid: choice.flag(),
        compensation: choice.of(&[None, Some(left), Some(right), Some(Compensation::Off)]),
        vector: None,
        radius: if choice.flag() { Some(choice.number()) } else { None },
        corner: choice.of(&[
            None,
            Some(OuterCorner::Intersection),
            Some(OuterCorner::Arc),
            Some(OuterCorner::LimitAngle),
        ]),
        approach: None,
        stops_look_ahead: choice.flag(),
        not_in_mode: choice.of(&[None, Some(AlarmKind::ToolChangeInMode)]),
    }
}

/// A block with few choices that may give a vector: a straight move, a vector block, or none, and a code.
fn given_block(choice: &mut impl Choice) -> Block<f64> {
    let (left, right) = (Compensation::On(Side::Left), Compensation::On(Side::Right));
    let kind = choice.below(6);
    let point = if matches!(kind, 0 | 5) { [0.0; 2] } else { [choice.number(), choice.number()] };
    let movement = match kind {
        0 => Movement::None,
        1 => Movement::Line { end: point },
        2 => Movement::HeldVector { end: point },
        3 => Movement::NewVector { vector: point },
        4 => Movement::CornerArc { vector: Some(point) },
        _ => Movement::CornerArc { vector: None },
    };
    let compensation = choice.of(&[None, Some(right), Some(left), Some(Compensation::Off)]);
    let beside = compensation.is_some() && kind < 2 && choice.flag();
    Block { compensation, vector: beside.then(|| [choice.number(), choice.number()]), ..Block::moving(movement) }
}

/// A block with few choices, for longer programs: a movement, and a code.
fn short_block(choice: &mut impl Choice, kinds: u8) -> Block<f64> {
    let (left, right) = (Compensation::On(Side::Left), Compensation::On(Side::Right));
    Block {
        compensation: choice.of(&[None, Some(right), Some(left), Some(Compensation::Off)]),
        ..Block::moving(movement(choice, kinds))
    }
}

/// An engine, and what it has said.
#[derive(Debug)]
struct Trial {
    engine: Engine,
    ledger: Ledger,
    blocks: usize,
    /// Blocks that wait for their end are lost in an alarm ([TRC-MODE-10]).
    loses: bool,
}

impl Trial {
    fn new(parameters: &Parameters) -> Trial {
        let loses = parameters.pending_at_alarm == PendingAtAlarm::Lost;
        Trial { engine: Engine::new(parameters), ledger: Ledger::default(), blocks: 0, loses }
    }

    fn push(&mut self, block: &Block<f64>) -> Result<(), Alarm> {
        let result = self.engine.push(block, &mut self.ledger);
        match result {
            Ok(()) => self.blocks += 1,
            Err(alarm) => {
                assert!(alarm.block <= self.blocks && self.stops_at(alarm.block), "an alarm stops at its block");
            }
        }
        result
    }

    /// Whether every block before this one has been emitted, but those that are lost.
    fn stops_at(&self, block: usize) -> bool {
        self.ledger.next == block || self.loses && self.ledger.next < block
    }

    /// After an alarm every call answers it again, and nothing is emitted.
    fn stays_stopped(&mut self, alarm: Alarm, block: &Block<f64>) {
        let steps = self.ledger.steps;
        assert!(self.engine.push(block, &mut self.ledger) == Err(alarm), "an alarm stays");
        assert!(self.engine.finish(&mut self.ledger) == Err(alarm), "an alarm stays at the end");
        assert!(self.ledger.steps == steps, "nothing is emitted after an alarm");
    }

    fn finish(&mut self) {
        match self.engine.finish(&mut self.ledger) {
            Ok(()) => assert!(self.ledger.next == self.blocks, "every block is emitted at the end"),
            Err(alarm) => {
                assert!(alarm.block < self.blocks && self.stops_at(alarm.block), "an alarm stops at its block");
            }
        }
    }
}

/// Harness: one block of any kind and bit pattern, and the end of the program.
pub fn one_block(choice: &mut impl Choice, kinds: u8) {
    let mut trial = Trial::new(&plain());
    match trial.push(&block(choice, kinds)) {
        Ok(()) => {
            reached!(choice, "a block is taken");
            trial.finish();
        }
        Err(alarm) => {
            reached!(choice, "a block is refused");
            trial.stays_stopped(alarm, &Block::empty());
        }
    }
}

/// Harness: up to `blocks` blocks behind a start-up code and a radius.
pub fn programs(choice: &mut impl Choice, parameters: &Parameters, blocks: u8, kinds: u8) {
    programs_of(choice, parameters, blocks, |choice| short_block(choice, kinds));
}

/// Harness: the same with blocks that give vectors.
pub fn programs_with_vectors(choice: &mut impl Choice, parameters: &Parameters, blocks: u8) {
    programs_of(choice, parameters, blocks, given_block);
}

fn programs_of<C: Choice>(choice: &mut C, parameters: &Parameters, blocks: u8, block: impl Fn(&mut C) -> Block<f64>) {
    let mut trial = Trial::new(parameters);
    let side = choice.of(&[Side::Left, Side::Right]);
    let radius = choice.of(&[1.0, 0.0]);
    let start = Block { radius: Some(radius), compensation: Some(Compensation::On(side)), ..Block::empty() };
    let mut result = trial.push(&start);
    for _ in 0..blocks {
        if result.is_ok() {
            result = trial.push(&block(choice));
        }
    }
    if trial.ledger.steps > trial.ledger.next {
        reached!(choice, "a corner move");
    }
    match result {
        Ok(()) => {
            reached!(choice, "an end without alarm");
            trial.finish();
        }
        Err(alarm) => {
            reached!(choice, "an alarm");
            trial.stays_stopped(alarm, &start);
        }
    }
}

/// Harness: the state after any alarm, with any block behind it.
pub fn after_an_alarm(choice: &mut impl Choice, kinds: u8) {
    let mut trial = Trial::new(&plain());
    if let Err(alarm) = trial.push(&block(choice, kinds)) {
        reached!(choice, "an alarm");
        trial.stays_stopped(alarm, &block(choice, kinds));
    }
}
