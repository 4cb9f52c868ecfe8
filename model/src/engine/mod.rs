//! The engine: blocks in, settled path elements out.

mod cancel;
mod offset;
mod own_move;
mod pending;
mod read;
mod rows;
mod start_up;
mod vector;
mod without_movement;

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{Parameters, PendingAtAlarm};
use radcomp_spec::{Alarm, AlarmKind, Block, OuterCorner, Segment, Side, Step};
use rug::Rational;

use crate::decision::{Judgement, Sink, Stop};
use crate::element::{Arm, Element};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::corner::next_owns;
use crate::rules::junction::Setting;
use crate::rules::look_ahead::Settled;
use crate::rules::mode::Offset;

pub(crate) use pending::Pending;
use pending::{Held, LeadIn};
use rows::Rows;

/// The reference model: reads blocks one at a time and hands out each path element as soon as it is settled.
///
/// Its memory is bounded: one block that moves and the blocks without movement after it are held ([TRC-LOOK-02]), and as
/// many blocks that move as are compared with each other ([TRC-INT-04]). Where a profile allows any number of blocks
/// without movement, they are held as runs of one traverse rate; but between blocks that are compared they are held one
/// by one.
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
    /// The corner arc whose next element is not yet read; nothing is pending then.
    corner_arc: Option<CornerArc>,
    /// Blocks without movement since the pending one, the start-up block without movement, or the corner arc.
    held: Held,
    settled: Option<Settled>,
    /// Side of the element before.
    element_side: Option<Side>,
    /// Side of the start-up block, until the first element after it has been read.
    start_up_side: Option<Side>,
    /// The block being read holds G40, and the start-up block has been read ([TRC-MODE-10]).
    reading_cancel: bool,
    rows: Rows,
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
#[derive(Clone, Debug)]
struct Shift {
    block: usize,
    rapid: bool,
    /// The tool radius in force in the block ([TRC-MODE-11]).
    radius: Real,
}

/// G39 without a direction ([TRC-VEC-03]).
#[derive(Clone, Debug)]
struct CornerArc {
    block: usize,
    rapid: bool,
    side: Side,
    /// The end of the element before, on whose normal the tool stands, with its side and its tool radius.
    before: (Arm, Side),
    radius: Real,
}

/// A block that moves, as the engine deals with it.
struct Moving {
    number: usize,
    rapid: bool,
    element: Element,
    end: End,
}

/// What the vector at the end of a block that moves comes from.
enum End {
    /// The junction with the next element.
    Junction,
    /// The vector at its start ([TRC-VEC-04]).
    Held,
    /// The words I, J, K beside the code of a side ([TRC-START-10], [TRC-START-11], [TRC-VEC-06]).
    Beside(Vector),
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
            corner_arc: None,
            held: Held::default(),
            settled: None,
            element_side: None,
            start_up_side: None,
            reading_cancel: false,
            rows: Rows::new(parameters),
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

    /// The side in force: that of the code, exchanged by a negative radius ([TRC-SIDE-07]).
    fn side(&self) -> Option<Side> {
        self.code.map(|code| self.offset.side(code))
    }

    /// What a junction depends on besides its elements; `next_rapid` is the traverse of the block after it.
    fn setting(&self, next_rapid: bool) -> Setting<'_> {
        let previous_rapid = self.pending.as_ref().is_some_and(|pending| pending.rapid);
        Setting {
            parameters: &self.parameters,
            // [TRC-MODE-11] the value of the element before.
            radius: self.pending.as_ref().map_or(&self.offset.radius, |pending| &pending.radius),
            outer_corner: self.outer_corner,
            owner_rapid: if next_owns(self.parameters.corner_owner) { next_rapid } else { previous_rapid },
        }
    }

    /// [TRC-MODE-06] ends the pending block on its own normal and stops; [TRC-MODE-10] or loses it, but for the moves
    /// before its own.
    fn alarm(&mut self, block: usize, kind: AlarmKind, judgement: &mut Judgement<'_>) -> Answer {
        let lost = self.parameters.pending_at_alarm == PendingAtAlarm::Lost && !self.reading_cancel;
        if lost {
            let left_out = self.rows.end(judgement)?;
            if let Some(pending) = self.pending.take().filter(|_| !left_out) {
                let LeadIn { clause, moves, .. } = pending.lead_in;
                self.corner_moves(clause, moves, pending.block, pending.rapid, judgement);
            }
            return Err(Stop::Alarm(Alarm { block, kind }));
        }
        if let Some(pending) = &self.pending {
            let end = pending.own_normal();
            self.end_pending(clause::TRC_MODE_06, end, judgement)?;
            self.execute_held(clause::TRC_LOOK_02, judgement);
        }
        self.drop_shift(judgement);
        self.drop_corner_arc(judgement);
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
        self.rows.step(Step { block, clause, rapid, main, segment }, judgement);
    }

    fn stand_at_end_of(&mut self, segment: &Segment<Real>) {
        if let Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. } = segment {
            self.tool = Vector::new(a.clone(), b.clone());
        }
    }
}
