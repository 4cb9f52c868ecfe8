//! The engine: blocks in, settled path elements out.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{Parameters, StartUpLost};
use radcomp_spec::{Alarm, AlarmKind, Block, Compensation, DecisionKind, Movement, OuterCorner, Segment, Side, Step};
use rug::Rational;

use crate::decision::{Judgement, Sink, Stop};
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::corner::next_owns;
use crate::rules::junction::{self, Junction, Refused, Setting, line_to};
use crate::rules::look_ahead::{self, Settled};
use crate::rules::{arc, cancel, dummy, mode, side_change, start_up, wedge};

/// The reference model: reads blocks one at a time and hands out each path element as soon as it is settled.
///
/// Its memory is bounded: one block that moves and the blocks without movement after it are held
/// ([TRC-LOOK-02]). The tool stands at (0, 0) when a program starts.
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
    /// The side of the compensation code in force.
    code: Option<Side>,
    radius: Real,
    outer_corner: OuterCorner,
    mode: Mode,
    pending: Option<Pending>,
    /// Blocks without movement since the pending one: number and rapid traverse.
    held: Vec<(usize, bool)>,
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
    /// From the start-up block's reading to the block with G40.
    Offset,
    /// G40 has been read in a block that does not move ([TRC-CANCEL-03]).
    Cancelling,
}

/// The last block that moves, whose end vector is not settled.
#[derive(Clone, Debug)]
pub(crate) struct Pending {
    pub(crate) block: usize,
    pub(crate) rapid: bool,
    pub(crate) kind: PendingKind,
    pub(crate) element: Element,
    pub(crate) side: Side,
    /// The corner moves before its own move that it owns, with their clause. They are made when the block is:
    /// an alarm at the block stops them too ([TRC-MODE-06]).
    lead_in: Option<LeadIn>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PendingKind {
    StartUp,
    Offset,
}

impl Pending {
    /// The vector at right angles to the block at its end.
    pub(crate) fn own_normal(&self, radius: &Real) -> Vector {
        self.element.last_arm().normal(self.side, radius)
    }
}

/// Corner moves and the clause that made them.
type LeadIn = (Clause, Vec<Segment<Real>>);

/// How the junction after the pending block came about.
struct Ending {
    clause: Clause,
    end: Vector,
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
            radius: Real::zero(),
            outer_corner: parameters.outer_corner,
            mode: Mode::Cancel,
            pending: None,
            held: Vec::new(),
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
        if !mode::in_range(block) {
            return self.alarm(number, AlarmKind::OutOfRange, judgement);
        }
        let element = match self.programmed(block, judgement) {
            Ok(element) => element,
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        let cancels = block.compensation == Some(Compensation::Off);
        if let Some(radius) = &block.radius {
            let radius = (self.number)(radius);
            // [TRC-MODE-03]
            if self.mode == Mode::Offset && !cancels && radius != self.radius {
                return self.alarm(number, AlarmKind::OffsetChangedInMode, judgement);
            }
            // The pending block ends with the radius that it was read with.
            if self.mode == Mode::Offset && radius != self.radius {
                return self.cancel_then(number, block, element, Some(radius), judgement);
            }
            self.radius = radius;
        }
        if self.mode == Mode::Offset && cancels {
            return self.cancel_then(number, block, element, None, judgement);
        }
        // [TRC-MODE-02] the last code before a block that moves counts; [TRC-MODE-05] the same one again changes nothing.
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
            Some(element) => self.moves(number, block.rapid, element, judgement),
            None => self.does_not_move(number, block, judgement),
        }
    }

    /// The element that a block moves along, or nothing ([TRC-LOOK-01]).
    fn programmed(&self, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Result<Option<Element>, AlarmKind> {
        match &block.movement {
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

    fn moves(&mut self, number: usize, rapid: bool, element: Element, judgement: &mut Judgement<'_>) -> Answer {
        match (self.mode, self.code) {
            (Mode::Offset, Some(side)) => self.compensated(number, rapid, element, side, judgement),
            (_, Some(side)) => self.start_up(number, rapid, element, side, judgement),
            (Mode::Cancel, None) => {
                self.uncompensated(number, rapid, &element, judgement);
                Ok(())
            }
            // In offset mode without a code the block cancels, which `read` has seen to.
            (Mode::Cancelling | Mode::Offset, None) => {
                self.cancel_move(number, rapid, element, clause::TRC_CANCEL_03, judgement)
            }
        }
    }

    /// [TRC-MODE-01]
    fn uncompensated(&mut self, number: usize, rapid: bool, element: &Element, judgement: &mut Judgement<'_>) {
        let segment = match &element.shape {
            Shape::Line { .. } => line_to(&element.end),
            Shape::Arc { .. } => arc_to(element, &element.end, true),
        };
        self.emit(number, rapid, clause::TRC_MODE_01, true, segment, judgement);
        self.position = element.end.clone();
    }

    /// [TRC-START-01]
    fn start_up(
        &mut self,
        number: usize,
        rapid: bool,
        element: Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        // [TRC-START-03]
        if matches!(element.shape, Shape::Arc { .. }) {
            return self.alarm(number, AlarmKind::ArcAtStartUp, judgement);
        }
        self.mode = Mode::Offset;
        self.settled = None;
        self.start_up_side = Some(side);
        self.element_side = Some(side);
        self.position = element.end.clone();
        self.pending = Some(Pending { block: number, rapid, kind: PendingKind::StartUp, element, side, lead_in: None });
        Ok(())
    }

    /// A block that moves in offset mode.
    fn compensated(
        &mut self,
        number: usize,
        rapid: bool,
        element: Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if let Err(kind) = side_change::permitted(&self.parameters, side, self.element_side, self.start_up_side) {
            return self.alarm(number, kind, judgement);
        }
        if let Err(kind) = arc::tool_fits(&element, side, &self.radius, judgement) {
            return self.alarm(number, kind, judgement);
        }
        let lead_in = if self.pending.is_some() {
            let junction = self.junction(number, &element, side, judgement)?;
            self.pass(junction, judgement)?
        } else {
            if let Some(settled) = self.settled.take() {
                look_ahead::advise(&settled, &element, side, &self.radius, judgement);
            }
            let resumed = look_ahead::resume(&self.tool, &element, side, &self.radius, judgement);
            self.stand_at_end_of(&resumed.moves);
            Some((resumed.clause, resumed.moves))
        };
        self.start_up_side = None;
        self.element_side = Some(side);
        self.position = element.end.clone();
        self.pending = Some(Pending { block: number, rapid, kind: PendingKind::Offset, element, side, lead_in });
        Ok(())
    }

    fn does_not_move(&mut self, number: usize, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Answer {
        if let (Movement::Dummy { vector }, Mode::Offset, Some(side), true) =
            (&block.movement, self.mode, self.code, self.pending.is_some())
            && let Some(element) = dummy::element(&self.position, &Vector::read(vector, self.number))
        {
            return self.dummy(number, block.rapid, &element, side, judgement);
        }
        // [TRC-DUMMY-04] nothing is pending after a dummy block, and nothing is counted then.
        if self.pending.is_some() {
            self.held.push((number, block.rapid));
            if self.held.len() > usize::from(self.parameters.non_moving_allowed) {
                return self.lose(clause::TRC_LOOK_03, judgement);
            }
            return Ok(());
        }
        let clause = match (&block.movement, &self.settled) {
            _ if self.mode != Mode::Offset => clause::TRC_LOOK_01,
            (Movement::Dummy { .. }, _) => clause::TRC_DUMMY_02,
            (_, Some(Settled::Lost { .. })) => clause::TRC_LOOK_03,
            _ => clause::TRC_LOOK_01,
        };
        self.emit(number, block.rapid, clause, false, Segment::Hold, judgement);
        Ok(())
    }

    /// [TRC-DUMMY-02]
    fn dummy(
        &mut self,
        number: usize,
        rapid: bool,
        element: &Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if let Err(kind) = side_change::permitted(&self.parameters, side, self.element_side, self.start_up_side) {
            return self.alarm(number, kind, judgement);
        }
        let junction = self.junction(number, element, side, judgement)?;
        if let Some((clause, moves)) = self.pass(junction, judgement)? {
            self.corner_moves(clause, &moves, number, rapid, judgement);
        }
        self.emit(number, rapid, clause::TRC_DUMMY_02, false, Segment::Hold, judgement);
        self.start_up_side = None;
        self.element_side = Some(side);
        self.settled = Some(Settled::Dummy { direction: element.first_arm().unit() });
        Ok(())
    }

    /// The junction of the pending block and the next element.
    fn junction(
        &mut self,
        number: usize,
        next: &Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Result<Junction, Stop> {
        let Some(pending) = &self.pending else { return Err(Stop::Contradiction) };
        let setting = Setting { parameters: &self.parameters, radius: &self.radius, outer_corner: self.outer_corner };
        let junction = match pending.kind {
            PendingKind::StartUp => Ok(start_up::junction(next, side, setting)),
            PendingKind::Offset => junction::between(&pending.element, pending.side, next, side, setting, judgement),
        };
        match junction {
            Ok(junction) => Ok(junction),
            Err(Refused::Contradiction) => Err(Stop::Contradiction),
            Err(Refused::Alarm(kind)) => Err(match self.alarm(number, kind, judgement) {
                Err(stop) => stop,
                Ok(()) => Stop::Contradiction,
            }),
        }
    }

    /// Ends the pending block at a junction, and executes the blocks held. Answers the corner moves if the next block
    /// owns them ([TRC-CORNER-12]); the tool is taken to stand behind them.
    fn pass(&mut self, junction: Junction, judgement: &mut Judgement<'_>) -> Result<Option<LeadIn>, Stop> {
        let Some((block, rapid)) = self.pending.as_ref().map(|pending| (pending.block, pending.rapid)) else {
            return Err(Stop::Contradiction);
        };
        self.end_pending(Ending { clause: junction.clause, end: junction.first }, judgement)?;
        if next_owns(self.parameters.corner_owner) {
            self.execute_held(clause::TRC_LOOK_02, judgement);
            self.stand_at_end_of(&junction.moves);
            Ok(Some((junction.clause, junction.moves)))
        } else {
            self.corner_moves(junction.clause, &junction.moves, block, rapid, judgement);
            self.execute_held(clause::TRC_LOOK_02, judgement);
            Ok(None)
        }
    }

    fn corner_moves(
        &mut self,
        clause: Clause,
        moves: &[Segment<Real>],
        block: usize,
        rapid: bool,
        judgement: &mut Judgement<'_>,
    ) {
        for segment in moves {
            self.emit(block, rapid, clause, false, segment.clone(), judgement);
        }
    }

    fn stand_at_end_of(&mut self, moves: &[Segment<Real>]) {
        for segment in moves {
            if let Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. } = segment {
                self.tool = Vector::new(a.clone(), b.clone());
            }
        }
    }

    /// Makes the pending block's own move to its end vector.
    fn end_pending(&mut self, ending: Ending, judgement: &mut Judgement<'_>) -> Answer {
        let Some(pending) = self.pending.take() else { return Ok(()) };
        let whole_circle = pending.kind == PendingKind::Offset
            && arc::whole_turn(&pending.element, pending.side, &self.radius, (&self.tool, &ending.end), judgement);
        if pending.kind == PendingKind::Offset {
            let reading = core::mem::replace(&mut judgement.block, pending.block);
            let looked_at =
                wedge::forward(&pending.element, &self.tool, &ending.end, whole_circle, &self.parameters, judgement);
            judgement.block = reading;
            if let Err(kind) = looked_at {
                return Err(Stop::Alarm(Alarm { block: pending.block, kind }));
            }
        }
        if let Some((clause, moves)) = &pending.lead_in {
            self.corner_moves(*clause, moves, pending.block, pending.rapid, judgement);
        }
        let segment = match &pending.element.shape {
            Shape::Line { .. } => line_to(&ending.end),
            Shape::Arc { .. } => arc_to(&pending.element, &ending.end, whole_circle),
        };
        self.emit(pending.block, pending.rapid, ending.clause, true, segment, judgement);
        Ok(())
    }

    fn execute_held(&mut self, clause: Clause, judgement: &mut Judgement<'_>) {
        for (block, rapid) in core::mem::take(&mut self.held) {
            self.emit(block, rapid, clause, false, Segment::Hold, judgement);
        }
    }

    /// The next element is not found: look-ahead is lost ([TRC-LOOK-03]) or the program ends ([TRC-MODE-04]).
    fn lose(&mut self, clause: Clause, judgement: &mut Judgement<'_>) -> Answer {
        let Some(pending) = &self.pending else { return Ok(()) };
        let start_up = pending.kind == PendingKind::StartUp;
        let unit = pending.element.last_arm().unit().toward(pending.side);
        let ending = if start_up && self.parameters.start_up_lost == StartUpLost::NoVector {
            self.mode = Mode::Cancel;
            self.start_up_side = None;
            self.element_side = None;
            Ending { clause: clause::TRC_START_04, end: pending.element.end.clone() }
        } else {
            self.settled = Some(Settled::Lost { normal: unit });
            let clause = if start_up { clause::TRC_START_04 } else { clause };
            Ending { clause, end: pending.own_normal(&self.radius) }
        };
        self.end_pending(ending, judgement)?;
        self.execute_held(clause::TRC_LOOK_03, judgement);
        Ok(())
    }

    /// A block with G40 in offset mode: [TRC-CANCEL-01], then [TRC-CANCEL-02] or [TRC-CANCEL-03].
    fn cancel_then(
        &mut self,
        number: usize,
        block: &Block<Rational>,
        element: Option<Element>,
        radius: Option<Real>,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if element.as_ref().is_some_and(|element| matches!(element.shape, Shape::Arc { .. })) {
            return self.alarm(number, AlarmKind::ArcAtCancel, judgement);
        }
        if let Some(pending) = &self.pending {
            let (clause, end) = cancel::end_before_cancel(pending, &self.radius, self.parameters.cancel);
            self.end_pending(Ending { clause, end }, judgement)?;
            self.execute_held(clause::TRC_LOOK_02, judgement);
        }
        self.code = None;
        self.mode = Mode::Cancelling;
        self.settled = None;
        self.start_up_side = None;
        self.element_side = None;
        if let Some(radius) = radius {
            self.radius = radius;
        }
        if let Some(corner) = block.corner {
            self.outer_corner = corner;
        }
        match element {
            Some(element) => self.cancel_move(number, block.rapid, element, clause::TRC_CANCEL_02, judgement),
            None => {
                self.emit(number, block.rapid, clause::TRC_CANCEL_03, false, Segment::Hold, judgement);
                Ok(())
            }
        }
    }

    /// [TRC-CANCEL-02]
    fn cancel_move(
        &mut self,
        number: usize,
        rapid: bool,
        element: Element,
        clause: Clause,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        // [TRC-CANCEL-04]
        if matches!(element.shape, Shape::Arc { .. }) {
            return self.alarm(number, AlarmKind::ArcAtCancel, judgement);
        }
        self.emit(number, rapid, clause, true, line_to(&element.end), judgement);
        self.position = element.end;
        self.mode = Mode::Cancel;
        Ok(())
    }

    /// [TRC-MODE-06] ends the pending block on its own normal and stops.
    fn alarm(&mut self, block: usize, kind: AlarmKind, judgement: &mut Judgement<'_>) -> Answer {
        if let Some(pending) = &self.pending {
            let end = pending.own_normal(&self.radius);
            self.end_pending(Ending { clause: clause::TRC_MODE_06, end }, judgement)?;
            self.execute_held(clause::TRC_LOOK_02, judgement);
        }
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
        self.stand_at_end_of(core::slice::from_ref(&segment));
        judgement.sink.step(Step { block, clause, rapid, main, segment });
    }
}

/// The move of an arc's block to a vector.
fn arc_to(element: &Element, end: &Vector, whole_circle: bool) -> Segment<Real> {
    match &element.shape {
        Shape::Line { .. } => line_to(end),
        Shape::Arc { centre, sense, full, .. } => Segment::Arc {
            end: [end.a.clone(), end.b.clone()],
            centre: [centre.a.clone(), centre.b.clone()],
            direction: *sense,
            full: whole_circle && *full,
        },
    }
}
