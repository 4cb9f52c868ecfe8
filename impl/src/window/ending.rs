//! How the pending element ends: at a junction, without one, or in an alarm; and the blocks without movement behind it.

use radcomp_spec::parameters::{PendingAtAlarm, SideChange, SideChangeAfterStartUp, StartUpLost, ZeroLengthMove};
use radcomp_spec::{Alarm, AlarmKind, Clause, Side, clause};

use super::{Mode, Pending, Start, Window};
use crate::geometry::{End, Event, Geometry, Meeting, Part};
use crate::held::Held;

impl Window {
    /// Raises an alarm at the block read: the pending element ends on its normal, or is lost. [TRC-MODE-06],
    /// [TRC-MODE-10]
    ///
    /// # Errors
    /// This alarm, or the one that ending the pending element raises at its block.
    #[cold]
    pub(super) fn fault<G: Geometry>(&mut self, block: usize, kind: AlarmKind, geometry: &mut G) -> Result<(), Alarm> {
        // Where something pends and no side is asked for, it is this block's G40 that has ended it.
        if self.policy.at_alarm == PendingAtAlarm::Lost && self.asked.is_some() {
            self.lose_in_alarm(self.pending, geometry)?;
            return Err(Alarm { block, kind });
        }
        self.release(geometry);
        self.settle(End::Normal(clause::TRC_MODE_06), clause::TRC_LOOK_02, geometry)?;
        Err(Alarm { block, kind })
    }

    /// Makes what an element that is lost in an alarm owns of the junction before it; only one behind another owns any.
    /// [TRC-MODE-10]
    #[cold]
    fn lose_in_alarm<G: Geometry>(&self, pending: Option<Pending>, geometry: &mut G) -> Result<(), Alarm> {
        if self.policy.at_alarm == PendingAtAlarm::Lost && pending.is_some_and(|pending| pending.start == Start::No) {
            geometry.lose()?;
        }
        Ok(())
    }

    /// Ends the program. [TRC-MODE-04]
    ///
    /// # Errors
    /// An alarm at the pending block.
    pub fn finish<G: Geometry>(&mut self, geometry: &mut G) -> Result<(), Alarm> {
        self.lose(clause::TRC_MODE_04, geometry)
    }

    /// Settles the junction before an element on this side, if that is not done yet.
    #[inline(always)]
    pub(super) fn meet<G: Geometry>(&mut self, block: usize, side: Side, geometry: &mut G) -> Result<(), Alarm> {
        if let Some(kind) = self.side_fault(side) {
            return self.fault(block, kind, geometry);
        }
        if let Some(pending) = self.pending.filter(|_| self.joins()) {
            let junction = if side == self.side && matches!(pending.start, Start::No | Start::Entry | Start::EntryArc) {
                geometry.junction(Meeting::Corner, side)
            } else {
                rare_junction(pending.start, side, geometry)
            };
            match junction {
                Ok(junction) => self.settle(End::Junction(junction), clause::TRC_LOOK_02, geometry)?,
                Err(kind) => return self.fault(block, kind, geometry),
            }
        } else {
            self.end_corner_arc(geometry);
        }
        (self.side, self.first, self.lost) = (side, false, false);
        Ok(())
    }

    /// [TRC-SIDE-01], [TRC-SIDE-04]
    #[inline(always)]
    pub(super) fn side_fault(&self, side: Side) -> Option<AlarmKind> {
        if side == self.side {
            None
        } else if self.policy.side_change == SideChange::Forbidden {
            Some(AlarmKind::SideChangeForbidden)
        } else if self.first && self.policy.after_start_up == SideChangeAfterStartUp::Alarm {
            Some(AlarmKind::SideChangeAfterStartUp)
        } else {
            None
        }
    }

    /// A block without movement in offset mode.
    #[inline(never)]
    pub(super) fn wait<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        // [TRC-DUMMY-04]: nothing is pending, so nothing is counted, once a dummy block has settled the junction.
        if self.pending.is_some() {
            if self.may_wait(event) {
                self.held.push(event.rapid);
                return Ok(());
            }
            self.lose_at_once(geometry)?;
        }
        self.stand(block, event, geometry);
        Ok(())
    }

    /// Whether a block without movement may wait behind the pending element. [TRC-LOOK-02], [TRC-LOOK-07],
    /// [TRC-LOOK-08]
    pub(super) fn may_wait(&self, event: Event) -> bool {
        let breaks = event.zero_length && self.policy.zero_length_move == ZeroLengthMove::BreaksLookAhead;
        self.held.count() < self.policy.allowed && !breaks && !event.stops
    }

    /// A block without movement that nothing waits for.
    pub(super) fn stand<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) {
        let clause = if self.lost { clause::TRC_LOOK_03 } else { clause::TRC_LOOK_01 };
        geometry.hold(block, event.rapid, clause);
    }

    /// A block that has become the pending one loses the look-ahead behind it, if it stops reading ahead.
    /// [TRC-LOOK-08]
    #[inline(always)]
    pub(super) fn stop_behind<G: Geometry>(&mut self, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        if event.stops { self.lose_at_once(geometry) } else { Ok(()) }
    }

    #[cold]
    fn lose_at_once<G: Geometry>(&mut self, geometry: &mut G) -> Result<(), Alarm> {
        // Behind a corner arc there is no junction to lose. [TRC-VEC-03]
        let lost = self.joins();
        self.lose(clause::TRC_LOOK_03, geometry)?;
        self.lost = lost;
        Ok(())
    }

    /// Ends the pending element without a next one; the clause is that of an element behind the start-up.
    /// [TRC-LOOK-03], [TRC-START-04]
    fn lose<G: Geometry>(&mut self, clause: Clause, geometry: &mut G) -> Result<(), Alarm> {
        self.release(geometry);
        let Some(pending) = self.pending else { return Ok(()) };
        let end = match (pending.start, self.policy.start_up_lost) {
            (Start::No | Start::Shift | Start::CornerArc, _) => End::Normal(clause),
            (Start::Block, StartUpLost::Normal) | (Start::Entry | Start::EntryArc, _) => {
                End::Normal(clause::TRC_START_04)
            }
            (Start::Block, StartUpLost::NoVector) => {
                self.mode = Mode::Cancel;
                End::Programmed(clause::TRC_START_04)
            }
        };
        self.settle(end, clause::TRC_LOOK_03, geometry)
    }

    /// A start-up block without movement waits for its element. [TRC-START-08]
    pub(super) fn shift_waits(&self) -> bool {
        self.pending.is_some_and(|pending| pending.start == Start::Shift)
    }

    /// Makes a start-up block without movement or a corner arc, if one waits, a block that moves nothing.
    /// [TRC-START-08], [TRC-VEC-03]
    pub(super) fn release<G: Geometry>(&mut self, geometry: &mut G) {
        let waits = |start: Start| match start {
            Start::Shift => Some(clause::TRC_LOOK_01),
            Start::CornerArc => Some(clause::TRC_VEC_03),
            Start::No | Start::Block | Start::Entry | Start::EntryArc => None,
        };
        if let Some(pending) = self.pending
            && let Some(clause) = waits(pending.start)
        {
            self.pending = None;
            geometry.hold(pending.block, pending.rapid, clause);
            self.emit_held(pending.block, clause::TRC_LOOK_01, geometry);
        }
    }

    #[inline(always)]
    pub(super) fn await_end(&mut self, block: usize, start: Start, rapid: bool) {
        self.lost = false;
        self.pending = Some(Pending { block, start, rapid });
    }

    /// Emits the pending element and the blocks without movement behind it, these by the clause.
    #[inline(always)]
    pub(super) fn settle<G: Geometry>(
        &mut self,
        end: End<G::Junction>,
        held: Clause,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        if let Some(pending) = self.pending.take() {
            let part = match pending.start {
                Start::No | Start::CornerArc => Part::Contour,
                Start::EntryArc => Part::EntryArc,
                Start::Block | Start::Entry | Start::Shift => Part::StartUp,
            };
            if let Err(alarm) = geometry.settle(end, part) {
                // A block whose vectors interfere makes no move. [TRC-INT-03]
                if alarm.kind != AlarmKind::Interference {
                    self.lose_in_alarm(Some(pending), geometry)?;
                }
                return Err(alarm);
            }
            if self.held.count() > 0 {
                self.emit_held(pending.block, held, geometry);
            }
        }
        Ok(())
    }

    #[inline(never)]
    pub(super) fn emit_held<G: Geometry>(&mut self, before: usize, clause: Clause, geometry: &mut G) {
        let held = core::mem::replace(&mut self.held, Held::none());
        let mut block = before;
        for rapid in held.rapid() {
            block = block.wrapping_add(1);
            geometry.hold(block, rapid, clause);
        }
    }
}

/// Forms a junction that is no corner. Such junctions are rare, and their code stands apart.
#[inline(never)]
fn rare_junction<G: Geometry>(start: Start, side: Side, geometry: &mut G) -> Result<G::Junction, AlarmKind> {
    let meeting = match start {
        Start::Block => Meeting::StartUp,
        Start::Shift => Meeting::Shift,
        Start::No | Start::Entry | Start::EntryArc | Start::CornerArc => Meeting::SideChange,
    };
    geometry.junction(meeting, side)
}
