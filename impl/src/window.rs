//! The look-ahead: which block is pending, how many blocks without movement wait behind it, and what each block read
//! does to them. No number of the geometry is seen here: answers and effects are a [`Geometry`]'s.
//!
//! At most one element is pending, the last one that moved under compensation, its end vector not yet known; behind
//! it wait at most [`MOST_NON_MOVING`] blocks without movement, of which only the count and the rapid flags are kept,
//! for they follow the pending block without a gap. [TRC-LOOK-02]

use radcomp_spec::parameters::{MOST_NON_MOVING, SideChange, SideChangeAfterStartUp, StartUpLost};
use radcomp_spec::{Alarm, AlarmKind, Clause, Compensation, Parameters, Side, clause};

use crate::geometry::{Begin, End, Event, Geometry, Kind, Meeting};

/// The modes of compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    /// [TRC-MODE-01]
    Cancel,
    /// From the start-up block read to the block with G40.
    Offset,
    /// A block with G40 has not moved: the next move cancels. [TRC-CANCEL-03]
    Cancelling,
}

/// The pending element, and the blocks without movement behind it.
#[derive(Clone, Copy, Debug)]
struct Pending {
    block: usize,
    start_up: bool,
    held: u8,
    rapid: u8,
}

/// The look-ahead.
#[derive(Clone, Debug)]
pub struct Window {
    start_up_lost: StartUpLost,
    side_change: SideChange,
    after_start_up: SideChangeAfterStartUp,
    allowed: u8,
    mode: Mode,
    /// The side that the codes ask for. [TRC-MODE-02]
    asked: Option<Side>,
    /// The side of the element before, once the start-up block has been read.
    side: Side,
    /// No element has followed the start-up block yet. [TRC-SIDE-04]
    first: bool,
    /// The present run of blocks without movement has lost the look-ahead.
    lost: bool,
    pending: Option<Pending>,
}

impl Window {
    /// The look-ahead at the start of a program: cancel mode, nothing pending.
    #[must_use]
    pub fn new(parameters: &Parameters) -> Self {
        Window {
            start_up_lost: parameters.start_up_lost,
            side_change: parameters.side_change,
            after_start_up: parameters.side_change_after_start_up,
            allowed: parameters.non_moving_allowed.min(MOST_NON_MOVING),
            mode: Mode::Cancel,
            asked: None,
            side: Side::Left,
            first: false,
            lost: false,
            pending: None,
        }
    }

    /// How many blocks are held: the pending one and those behind it.
    #[must_use]
    pub fn held(&self) -> usize {
        self.pending.map_or(0, |pending| 1 + usize::from(pending.held))
    }

    /// Reads a block whose own form is sound. The checks come in the order of [TRC-MODE-06].
    ///
    /// # Errors
    /// The first alarm in the order of blocks. The window is not to be used after it.
    #[inline(always)]
    pub fn read<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        let off = event.code == Some(Compensation::Off);
        if event.other_radius && self.mode == Mode::Offset && !off {
            return self.fault(block, AlarmKind::OffsetChangedInMode, geometry);
        }
        match event.code {
            Some(Compensation::Off) => self.asked = None,
            Some(Compensation::On(side)) => self.asked = Some(side),
            None => {}
        }
        match (self.mode, self.asked) {
            (Mode::Offset, Some(side)) => self.compensate(block, event, side, geometry),
            (Mode::Offset, None) => self.cancel(block, event, geometry),
            (Mode::Cancel | Mode::Cancelling, Some(side)) => self.start_up(block, event, side, geometry),
            (Mode::Cancel | Mode::Cancelling, None) => self.follow(block, event, geometry),
        }
    }

    /// Raises an alarm at the block read: the pending element ends on its normal. [TRC-MODE-06]
    ///
    /// # Errors
    /// This alarm, or the one that ending the pending element raises at its block.
    #[cold]
    pub fn fault<G: Geometry>(&mut self, block: usize, kind: AlarmKind, geometry: &mut G) -> Result<(), Alarm> {
        self.settle(End::Normal(clause::TRC_MODE_06), clause::TRC_LOOK_02, geometry)?;
        Err(Alarm { block, kind })
    }

    /// Ends the program. [TRC-MODE-04]
    ///
    /// # Errors
    /// An alarm at the pending block.
    pub fn finish<G: Geometry>(&mut self, geometry: &mut G) -> Result<(), Alarm> {
        self.lose(clause::TRC_MODE_04, geometry)
    }

    #[inline(never)]
    fn follow<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        let cancels = self.mode == Mode::Cancelling;
        match event.kind {
            Kind::Still | Kind::Dummy => self.stand(block, event, geometry),
            Kind::Arc if cancels => return self.fault(block, AlarmKind::ArcAtCancel, geometry),
            Kind::Line | Kind::Arc => {
                geometry.follow(if cancels { clause::TRC_CANCEL_03 } else { clause::TRC_MODE_01 });
                (self.mode, self.lost) = (Mode::Cancel, false);
            }
        }
        Ok(())
    }

    #[inline(never)]
    fn start_up<G: Geometry>(&mut self, block: usize, event: Event, side: Side, g: &mut G) -> Result<(), Alarm> {
        match event.kind {
            Kind::Still | Kind::Dummy => self.stand(block, event, g),
            Kind::Arc => return self.fault(block, AlarmKind::ArcAtStartUp, g),
            Kind::Line => {
                (self.mode, self.side, self.first) = (Mode::Offset, side, true);
                self.await_end(block, true);
                g.begin(Begin::StartUp, side);
            }
        }
        Ok(())
    }

    /// A block of the offset mode with G40 in it. [TRC-CANCEL-01]
    #[inline(never)]
    fn cancel<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        if event.kind == Kind::Arc {
            return self.fault(block, AlarmKind::ArcAtCancel, geometry);
        }
        let start_up = self.pending.is_some_and(|pending| pending.start_up);
        let clause = if start_up { clause::TRC_START_05 } else { clause::TRC_CANCEL_01 };
        self.settle(End::Normal(clause), clause::TRC_LOOK_02, geometry)?;
        self.lost = false;
        if event.kind == Kind::Line {
            self.mode = Mode::Cancel;
            geometry.follow(clause::TRC_CANCEL_02);
        } else {
            self.mode = Mode::Cancelling;
            geometry.hold(block, event.rapid, clause::TRC_CANCEL_03);
        }
        Ok(())
    }

    /// A block of the offset mode.
    #[inline(always)]
    fn compensate<G: Geometry>(&mut self, block: usize, event: Event, side: Side, g: &mut G) -> Result<(), Alarm> {
        match event.kind {
            Kind::Still => self.wait(block, event, g),
            // [TRC-DUMMY-02]: the junction is settled already.
            Kind::Dummy if self.pending.is_none() => {
                g.hold(block, event.rapid, clause::TRC_DUMMY_02);
                Ok(())
            }
            Kind::Dummy => {
                self.meet(block, side, g)?;
                g.dummy();
                g.hold(block, event.rapid, clause::TRC_DUMMY_02);
                Ok(())
            }
            Kind::Line | Kind::Arc => {
                if event.kind == Kind::Arc && self.side_fault(side).is_none() && !g.tool_fits(side) {
                    return self.fault(block, AlarmKind::RadiusTooSmall, g);
                }
                let begin = if self.pending.is_some() { Begin::Junction } else { Begin::Settled };
                self.meet(block, side, g)?;
                self.await_end(block, false);
                g.begin(begin, side);
                Ok(())
            }
        }
    }

    /// Settles the junction before an element on this side, if that is not done yet.
    #[inline(always)]
    fn meet<G: Geometry>(&mut self, block: usize, side: Side, geometry: &mut G) -> Result<(), Alarm> {
        if let Some(kind) = self.side_fault(side) {
            return self.fault(block, kind, geometry);
        }
        if let Some(pending) = self.pending {
            let meeting = match (pending.start_up, side == self.side) {
                (true, _) => Meeting::StartUp,
                (false, true) => Meeting::Corner,
                (false, false) => Meeting::SideChange,
            };
            match geometry.junction(meeting, side) {
                Ok(junction) => self.settle(End::Junction(junction), clause::TRC_LOOK_02, geometry)?,
                Err(kind) => return self.fault(block, kind, geometry),
            }
        }
        (self.side, self.first, self.lost) = (side, false, false);
        Ok(())
    }

    /// [TRC-SIDE-01], [TRC-SIDE-04]
    #[inline(always)]
    fn side_fault(&self, side: Side) -> Option<AlarmKind> {
        if side == self.side {
            None
        } else if self.side_change == SideChange::Forbidden {
            Some(AlarmKind::SideChangeForbidden)
        } else if self.first && self.after_start_up == SideChangeAfterStartUp::Alarm {
            Some(AlarmKind::SideChangeAfterStartUp)
        } else {
            None
        }
    }

    /// A block without movement in offset mode.
    #[inline(never)]
    fn wait<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        match &mut self.pending {
            // [TRC-DUMMY-04]: nothing is pending, so nothing is counted, once a dummy block has settled the junction.
            Some(pending) if pending.held < self.allowed => {
                pending.rapid |= u8::from(event.rapid).wrapping_shl(u32::from(pending.held));
                pending.held += 1;
                return Ok(());
            }
            Some(_) => {
                self.lose(clause::TRC_LOOK_03, geometry)?;
                self.lost = true;
            }
            None => {}
        }
        self.stand(block, event, geometry);
        Ok(())
    }

    /// A block without movement that nothing waits for.
    fn stand<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) {
        let clause = if self.lost { clause::TRC_LOOK_03 } else { clause::TRC_LOOK_01 };
        geometry.hold(block, event.rapid, clause);
    }

    /// Ends the pending element without a next one; the clause is that of an element behind the start-up.
    /// [TRC-LOOK-03], [TRC-START-04]
    fn lose<G: Geometry>(&mut self, clause: Clause, geometry: &mut G) -> Result<(), Alarm> {
        let start_up = self.pending.is_some_and(|pending| pending.start_up);
        let end = match (start_up, self.start_up_lost) {
            (false, _) => End::Normal(clause),
            (true, StartUpLost::Normal) => End::Normal(clause::TRC_START_04),
            (true, StartUpLost::NoVector) => {
                self.mode = Mode::Cancel;
                End::Programmed(clause::TRC_START_04)
            }
        };
        self.settle(end, clause::TRC_LOOK_03, geometry)
    }

    fn await_end(&mut self, block: usize, start_up: bool) {
        self.lost = false;
        self.pending = Some(Pending { block, start_up, held: 0, rapid: 0 });
    }

    /// Emits the pending element and the blocks without movement behind it, these by the clause.
    #[inline(always)]
    fn settle<G: Geometry>(&mut self, end: End<G::Junction>, held: Clause, geometry: &mut G) -> Result<(), Alarm> {
        if let Some(pending) = self.pending.take() {
            geometry.settle(end, pending.start_up).map_err(|kind| Alarm { block: pending.block, kind })?;
            for behind in 0..pending.held {
                let rapid = pending.rapid.wrapping_shr(u32::from(behind)) & 1 == 1;
                geometry.hold(pending.block.wrapping_add(1 + usize::from(behind)), rapid, held);
            }
        }
        Ok(())
    }
}

/// One bit of [`Pending::rapid`] for each block held.
const _: () = assert!(MOST_NON_MOVING as u32 <= u8::BITS);
