//! The look-ahead: which block is pending, how many blocks without movement wait behind it, and what each block read
//! does to them. No number of the geometry is seen here: answers and effects are a [`Geometry`]'s.
//!
//! At most one element is pending, the last one that moved under compensation, its end vector not yet known, or a
//! start-up block without movement; behind it wait blocks without movement, of which only the count and the rates are
//! kept, for they follow the pending block without a gap. [TRC-LOOK-02]

mod ending;
mod transition;
mod vector;

use radcomp_spec::parameters::{
    Approach, Cancel, CancelVector, CancelWithoutMovement, OffsetChange, PendingAtAlarm, SameCode, SideChange,
    SideChangeAfterStartUp, SideCodeVector, StartUp, StartUpArc, StartUpLost, StartUpWithoutMovement, ZeroLengthMove,
};
use radcomp_spec::{Alarm, AlarmKind, Compensation, Parameters, Side, clause};

use crate::geometry::{Begin, End, Event, Geometry, Kind};
use crate::held::Held;

/// The modes of compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    /// [TRC-MODE-01]
    Cancel,
    /// From the start-up block read, or the element behind one without movement, to the block with G40.
    Offset,
    /// A block with G40 has not moved: the next move cancels. [TRC-CANCEL-03]
    Cancelling,
}

/// What the pending element has to do with start-up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Start {
    /// Nothing: another element came before.
    No,
    /// It is a start-up block of type A or B.
    Block,
    /// It is a straight entry move, and counts as compensated from its end on. [TRC-START-07]
    Entry,
    /// It is an arc as entry move, and counts as compensated. [TRC-START-09]
    EntryArc,
    /// It is a block without movement that may start up; cancel mode is in force until an element follows.
    /// [TRC-START-08]
    Shift,
    /// It is no element but a corner arc that waits for the next one. [TRC-VEC-03]
    CornerArc,
}

/// The pending element, or a block that waits in its place.
#[derive(Clone, Copy, Debug)]
struct Pending {
    block: usize,
    start: Start,
    rapid: bool,
}

/// What the profile says of the look-ahead.
#[derive(Clone, Copy, Debug)]
struct Policy {
    start_up: StartUp,
    start_up_lost: StartUpLost,
    arc: StartUpArc,
    shift_in: StartUpWithoutMovement,
    cancel: Cancel,
    shift_out: CancelWithoutMovement,
    same_code: SameCode,
    at_alarm: PendingAtAlarm,
    side_change: SideChange,
    after_start_up: SideChangeAfterStartUp,
    side_vector: SideCodeVector,
    cancel_vector: CancelVector,
    offset_change: OffsetChange,
    zero_length_move: ZeroLengthMove,
    /// Blocks without movement allowed between two moves.
    allowed: usize,
}

/// The look-ahead.
#[derive(Clone, Debug)]
pub struct Window {
    policy: Policy,
    mode: Mode,
    /// The side that the codes ask for. [TRC-MODE-02]
    asked: Option<Side>,
    /// The radius in force is negative. [TRC-SIDE-07]
    swapped: bool,
    /// The side of the element before, once the start-up block has been read.
    side: Side,
    /// No element has followed the start-up block yet. [TRC-SIDE-04]
    first: bool,
    /// The present run of blocks without movement has lost the look-ahead.
    lost: bool,
    pending: Option<Pending>,
    held: Held,
}

impl Window {
    /// NORM or KONT has been read: what it says of start-up and cancel. [TRC-START-12]
    pub fn approach(&mut self, approach: Approach) {
        (self.policy.start_up, self.policy.cancel) = match approach {
            Approach::Norm => (StartUp::TypeA, Cancel::TypeA),
            Approach::Kont => (StartUp::TypeB, Cancel::TypeB),
        };
    }

    /// The look-ahead at the start of a program: cancel mode, nothing pending.
    #[must_use]
    pub fn new(parameters: &Parameters) -> Self {
        let policy = Policy {
            start_up: parameters.start_up,
            start_up_lost: parameters.start_up_lost,
            arc: parameters.start_up_arc,
            shift_in: parameters.start_up_without_movement,
            cancel: parameters.cancel,
            shift_out: parameters.cancel_without_movement,
            same_code: parameters.same_code,
            at_alarm: parameters.pending_at_alarm,
            side_change: parameters.side_change,
            after_start_up: parameters.side_change_after_start_up,
            side_vector: parameters.side_code_vector,
            cancel_vector: parameters.cancel_vector,
            offset_change: parameters.offset_change,
            zero_length_move: parameters.zero_length_move,
            allowed: parameters.non_moving_allowed.map_or(usize::MAX, usize::from),
        };
        Window {
            policy,
            mode: Mode::Cancel,
            asked: None,
            swapped: false,
            side: Side::Left,
            first: false,
            lost: false,
            pending: None,
            held: Held::none(),
        }
    }

    /// How many blocks are held: the pending one and those behind it.
    #[must_use]
    pub fn held(&self) -> usize {
        self.pending.map_or(0, |_| self.held.count().saturating_add(1))
    }

    /// Reads a block whose own form is sound. The checks come in the order of [TRC-MODE-06].
    ///
    /// # Errors
    /// The first alarm in the order of blocks. The window is not to be used after it.
    #[inline(always)]
    pub fn read<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        if event.code.is_some() || event.other_radius || event.not_in_mode.is_some() {
            self.read_codes(block, event, geometry)?;
        }
        self.swapped = event.swapped;
        match (self.mode, self.side_in_force()) {
            (Mode::Offset, Some(side)) => self.compensate(block, event, side, geometry),
            (Mode::Offset, None) => self.cancel(block, event, geometry),
            (Mode::Cancel | Mode::Cancelling, Some(side)) => self.start_up(block, event, side, geometry),
            (Mode::Cancel | Mode::Cancelling, None) => self.follow(block, event, geometry),
        }
    }

    /// Raises the alarm of a block's own form: numbers out of range come before what its codes raise, an arc that does not
    /// exist behind it. [TRC-MODE-06]
    ///
    /// # Errors
    /// This alarm, one of its codes, or the one that ending the pending element raises at its block.
    #[cold]
    pub fn refuse<G: Geometry>(
        &mut self,
        block: usize,
        event: Event,
        kind: AlarmKind,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        if kind != AlarmKind::OutOfRange {
            self.read_codes(block, event, geometry)?;
        } else if event.code == Some(Compensation::Off) {
            self.asked = None;
        }
        self.fault(block, kind, geometry)
    }

    /// The side in force. [TRC-SIDE-07]
    #[inline(always)]
    fn side_in_force(&self) -> Option<Side> {
        self.asked.map(|side| if self.swapped { side.other() } else { side })
    }

    /// The codes of a block, and the radius that it puts in force. [TRC-MODE-05], [TRC-SIDE-01], [TRC-MODE-03],
    /// [TRC-MODE-08]
    #[inline(never)]
    fn read_codes<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        let off = event.code == Some(Compensation::Off);
        match event.code {
            Some(Compensation::On(side)) if self.asked == Some(side) => self.same_code(block, geometry)?,
            Some(Compensation::On(_)) if self.asked.is_some() && self.policy.side_change == SideChange::Forbidden => {
                return self.fault(block, AlarmKind::SideChangeForbidden, geometry);
            }
            Some(Compensation::On(side)) => self.asked = Some(side),
            Some(Compensation::Off) => self.asked = None,
            None => {}
        }
        // The last of several blocks that start up without movement is the start-up block. [TRC-START-08]
        let starts_again = self.shift_waits() && event.kind == Kind::Still && event.code.is_some();
        let in_mode = self.mode == Mode::Offset || self.shift_waits() && !starts_again;
        if event.other_radius && in_mode && !off && self.policy.offset_change == OffsetChange::Alarm {
            return self.fault(block, AlarmKind::OffsetChangedInMode, geometry);
        }
        match event.not_in_mode {
            Some(kind) => self.fault(block, kind, geometry),
            None => Ok(()),
        }
    }

    /// The code in force, given again. [TRC-MODE-05]
    fn same_code<G: Geometry>(&mut self, block: usize, geometry: &mut G) -> Result<(), Alarm> {
        match self.policy.same_code {
            SameCode::Alarm => self.fault(block, AlarmKind::SameCode, geometry),
            // A corner arc that waits has ended the element before it. [TRC-VEC-03]
            SameCode::Normal if self.mode == Mode::Offset && !self.corner_waits() => {
                self.settle(End::Normal(clause::TRC_MODE_05), clause::TRC_LOOK_02, geometry)
            }
            SameCode::Normal | SameCode::Ordinary => Ok(()),
        }
    }

    /// A block of the offset mode.
    #[inline(always)]
    fn compensate<G: Geometry>(&mut self, block: usize, event: Event, side: Side, g: &mut G) -> Result<(), Alarm> {
        match event.kind {
            Kind::NewVector | Kind::CornerArc | Kind::CornerToNext => self.vector_block(block, event, side, g),
            // [TRC-VEC-06]
            Kind::Still if self.gives_vector(event) => self.vector_block(block, event, side, g),
            Kind::Still => self.wait(block, event, g),
            Kind::HeldVector => self.hold_vector(block, event, side, g),
            Kind::Line if self.gives_vector(event) => self.move_to_vector(block, event, side, g),
            // [TRC-DUMMY-02]: the junction is settled already.
            Kind::Dummy if self.pending.is_none() => {
                g.hold(block, event.rapid, clause::TRC_DUMMY_02);
                Ok(())
            }
            Kind::Dummy => {
                let joins = self.joins();
                self.meet(block, side, g)?;
                if joins {
                    g.corner_moves();
                }
                g.hold(block, event.rapid, clause::TRC_DUMMY_02);
                Ok(())
            }
            Kind::Line | Kind::Arc => {
                if event.kind == Kind::Arc
                    && self.side_fault(side).is_none()
                    && let Some(kind) = g.arc_fault(side, self.joins())
                {
                    return self.fault(block, kind, g);
                }
                let begin = if self.joins() { Begin::Junction } else { Begin::Settled };
                self.meet(block, side, g)?;
                self.await_end(block, Start::No, event.rapid);
                g.begin(begin, side);
                self.stop_behind(event, g)
            }
        }
    }
}
