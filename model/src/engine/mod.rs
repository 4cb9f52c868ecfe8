//! The engine: blocks in, settled path elements out.

mod cancel;
mod offset;
mod pending;
mod start_up;
mod without_movement;

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{Parameters, SameCode};
use radcomp_spec::{Alarm, AlarmKind, Block, Compensation, DecisionKind, Movement, OuterCorner, Segment, Side, Step};
use rug::Rational;

use crate::decision::{Judgement, Sink, Stop};
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::arc;
use crate::rules::corner::next_owns;
use crate::rules::junction::Setting;
use crate::rules::look_ahead::Settled;
use crate::rules::mode::{self, Offset};

use pending::Held;
pub(crate) use pending::Pending;

/// The reference model: reads blocks one at a time and hands out each path element as soon as it is settled.
///
/// Its memory is bounded: one block that moves and the blocks without movement after it are held
/// ([TRC-LOOK-02]). Where a profile allows any number of those, they are held as runs of one traverse rate.
/// The tool stands at (0, 0) when a program starts.
///
/// # Exactness
///
/// Coordinates are rationals and every answer is an exact number; nothing is rounded.
#[derive(Clone, Debug)]
pub struct Engine {
    parameters: Parameters,
    /// What is made of a number of the program.
    number: fn(&Rational) -> Real,
    next_block: usize,
    /// Where the program stands.
    position: Vector,
    /// Where the tool's centre stands.
    tool: Vector,
    /// The side of the compensation code in force; a negative radius does not change it.
    code: Option<Side>,
    offset: Offset,
    outer_corner: OuterCorner,
    mode: Mode,
    pending: Option<Pending>,
    /// The start-up block without movement whose next element is not yet read; nothing is pending then.
    shift: Option<Shift>,
    /// Blocks without movement since the pending one, or since the start-up block without movement.
    held: Held,
    settled: Option<Settled>,
    /// Side of the element before.
    element_side: Option<Side>,
    /// Side of the start-up block, until the first element after it has been read.
    start_up_side: Option<Side>,
    stopped: Option<Stop>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    /// Cancel mode ([TRC-MODE-01]).
    Cancel,
    /// From the start-up block's reading to the block with G40. With a start-up block without movement it begins when
    /// the next element is read ([TRC-START-08]).
    Offset,
    /// G40 has been read in a block that does not move ([TRC-CANCEL-03]).
    Cancelling,
}

/// A start-up block without movement ([TRC-START-08]).
#[derive(Clone, Copy, Debug)]
struct Shift {
    block: usize,
    rapid: bool,
}

/// A block that moves, as the engine deals with it.
struct Moving {
    number: usize,
    rapid: bool,
    element: Element,
}

type Answer = Result<(), Stop>;

impl Engine {
    /// An engine in cancel mode, with the tool at (0, 0) and radius 0.
    pub fn new(parameters: &Parameters) -> Self {
        Engine {
            parameters: *parameters,
            number: |value| Real::from(value),
            next_block: 0,
            position: Vector::zero(),
            tool: Vector::zero(),
            code: None,
            offset: Offset::none(),
            outer_corner: parameters.outer_corner,
            mode: Mode::Cancel,
            pending: None,
            shift: None,
            held: Held::default(),
            settled: None,
            element_side: None,
            start_up_side: None,
            stopped: None,
        }
    }

    /// An engine that remembers which numbers of its answers come from the program, so that
    /// [`Real::reach`] can tell what a change of the program makes of them. Slower: no step is folded.
    pub fn on_inputs(parameters: &Parameters) -> Self {
        Engine { number: Real::input, ..Engine::new(parameters) }
    }

    /// Reads the next block.
    ///
    /// # Errors
    ///
    /// The alarm that ends the path, at this block or an earlier one; every later call answers the same.
    pub fn push(&mut self, block: &Block<Rational>, sink: &mut dyn Sink) -> Result<(), Stop> {
        if let Some(stop) = self.stopped {
            return Err(stop);
        }
        let number = self.next_block;
        self.next_block += 1;
        let result = self.read(number, block, &mut Judgement { sink, block: number });
        self.remember(result)
    }

    /// The program ends ([TRC-MODE-04]).
    ///
    /// # Errors
    ///
    /// As [`Engine::push`].
    pub fn finish(&mut self, sink: &mut dyn Sink) -> Result<(), Stop> {
        if let Some(stop) = self.stopped {
            return Err(stop);
        }
        let block = self.next_block.saturating_sub(1);
        let result = self.lose(clause::TRC_MODE_04, &mut Judgement { sink, block });
        self.remember(result)
    }

    fn remember(&mut self, result: Answer) -> Answer {
        if let Err(stop) = result {
            self.stopped = Some(stop);
        }
        result
    }

    /// [TRC-MODE-06] the order of the checks.
    fn read(&mut self, number: usize, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Answer {
        if !mode::in_range(block, self.parameters.negative_radius) {
            return self.alarm(number, AlarmKind::OutOfRange, judgement);
        }
        let element = match self.programmed(block, judgement) {
            Ok(element) => element,
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        let cancels = block.compensation == Some(Compensation::Off);
        let offset = block.radius.as_ref().map(|radius| Offset::read(radius, self.number));
        if let Some(offset) = &offset
            && self.radius_is_fixed(block, element.is_some())
            && offset.radius != self.offset.radius
        {
            return self.alarm(number, AlarmKind::OffsetChangedInMode, judgement);
        }
        // [TRC-MODE-08]
        if let Some(kind) = block.not_in_mode {
            return self.alarm(number, kind, judgement);
        }
        // [TRC-MODE-05]
        if mode::same_code(block, self.code) {
            match self.parameters.same_code {
                SameCode::Ordinary => {}
                SameCode::Normal => self.settle_on_normal(judgement)?,
                SameCode::Alarm => return self.alarm(number, AlarmKind::SameCode, judgement),
            }
        }
        if self.mode == Mode::Offset && cancels {
            return self.cancel(number, block, element, offset, judgement);
        }
        if cancels {
            self.drop_shift(judgement);
        }
        if let Some(offset) = offset {
            self.offset = offset;
        }
        // [TRC-MODE-02] the last code before a block that moves counts.
        match block.compensation {
            Some(Compensation::Off) => self.code = None,
            Some(Compensation::On(side)) => self.code = Some(side),
            None => {}
        }
        // [TRC-CORNER-11] before the junction with this block is formed.
        if let Some(corner) = block.corner {
            self.outer_corner = corner;
        }
        match element {
            Some(element) => {
                self.moves(Moving { number, rapid: block.rapid, element }, judgement)?;
                // [TRC-LOOK-08] the block moves first.
                if block.stops_look_ahead { self.lose(clause::TRC_LOOK_03, judgement) } else { Ok(()) }
            }
            None => self.does_not_move(number, block, judgement),
        }
    }

    /// The element that a block moves along, or nothing ([TRC-LOOK-01]). Words of axes outside the plane are in no
    /// block ([TRC-MODE-09]).
    fn programmed(&self, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Result<Option<Element>, AlarmKind> {
        match &block.movement {
            _ if block.not_in_mode.is_some() => Ok(None),
            Movement::None | Movement::Dummy { .. } => Ok(None),
            Movement::Line { end } => {
                let element = Element::line(self.position.clone(), Vector::read(end, self.number));
                let Shape::Line { direction, length } = &element.shape else { return Ok(None) };
                let squared = direction.length_squared();
                let moves = judgement.decide(DecisionKind::Moves, &squared, length.clone()).is_gt();
                Ok(moves.then_some(element))
            }
            Movement::Arc { end, centre, direction } => {
                let words = arc::Words::read(end, centre, *direction, self.number);
                arc::programmed(&self.position, words, &self.parameters, judgement).map(Some)
            }
        }
    }

    fn moves(&mut self, block: Moving, judgement: &mut Judgement<'_>) -> Answer {
        match (self.mode, self.side()) {
            (Mode::Offset, Some(side)) => self.compensated(block, side, judgement),
            (_, Some(side)) if self.shift.is_some() => self.compensated(block, side, judgement),
            (_, Some(side)) => self.start_up(block, side, judgement),
            (Mode::Cancel, None) => {
                self.uncompensated(block, judgement);
                Ok(())
            }
            // In offset mode without a code the block cancels, which `read` has seen to.
            (Mode::Cancelling | Mode::Offset, None) => self.cancel_move(block, clause::TRC_CANCEL_03, judgement),
        }
    }

    /// [TRC-MODE-01]
    fn uncompensated(&mut self, block: Moving, judgement: &mut Judgement<'_>) {
        let segment = pending::own_move(&block.element, &block.element.end, true);
        self.emit(block.number, block.rapid, clause::TRC_MODE_01, true, segment, judgement);
        self.position = block.element.end;
    }

    /// [TRC-MODE-03] whether a radius of another magnitude would raise the alarm at this block: the start-up block has
    /// been read, and the block neither cancels nor is another start-up block without movement in its place.
    fn radius_is_fixed(&self, block: &Block<Rational>, moves: bool) -> bool {
        let replaces_shift = !moves && !matches!(block.movement, Movement::Dummy { .. }) && self.shifts(block);
        let started = self.mode == Mode::Offset || (self.shift.is_some() && !replaces_shift);
        started && block.compensation != Some(Compensation::Off)
    }

    /// The side in force: that of the code, exchanged by a negative radius ([TRC-SIDE-07]).
    fn side(&self) -> Option<Side> {
        self.code.map(|code| self.offset.side(code))
    }

    /// What a junction depends on besides its elements; `next_rapid` is the traverse of the block after it.
    fn setting(&self, next_rapid: bool) -> Setting<'_> {
        let previous_rapid = self.pending.as_ref().is_some_and(|pending| pending.rapid);
        Setting {
            parameters: &self.parameters,
            radius: &self.offset.radius,
            outer_corner: self.outer_corner,
            owner_rapid: if next_owns(self.parameters.corner_owner) { next_rapid } else { previous_rapid },
        }
    }

    /// [TRC-MODE-06] ends the pending block on its own normal and stops.
    fn alarm(&mut self, block: usize, kind: AlarmKind, judgement: &mut Judgement<'_>) -> Answer {
        if let Some(pending) = &self.pending {
            let end = pending.own_normal(&self.offset.radius);
            self.end_pending(clause::TRC_MODE_06, end, judgement)?;
            self.execute_held(clause::TRC_LOOK_02, judgement);
        }
        self.drop_shift(judgement);
        Err(Stop::Alarm(Alarm { block, kind }))
    }

    fn emit(
        &mut self,
        block: usize,
        rapid: bool,
        clause: Clause,
        main: bool,
        segment: Segment<Real>,
        judgement: &mut Judgement<'_>,
    ) {
        self.stand_at_end_of(&segment);
        judgement.sink.step(Step { block, clause, rapid, main, segment });
    }

    fn stand_at_end_of(&mut self, segment: &Segment<Real>) {
        if let Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. } = segment {
            self.tool = Vector::new(a.clone(), b.clone());
        }
    }
}
