//! Into offset mode and out of it: blocks of cancel mode, start-up and cancel.

use radcomp_spec::parameters::{
    Cancel, CancelVector, CancelWithoutMovement, StartUp, StartUpArc, StartUpWithoutMovement, ZeroLengthMove,
};
use radcomp_spec::{Alarm, AlarmKind, Side, clause};

use super::{Mode, Start, Window};
use crate::geometry::{Begin, End, Event, Geometry, Kind, Meeting};

impl Window {
    /// A block of cancel mode with G40 in force.
    #[inline(never)]
    pub(super) fn follow<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        if event.vector_code {
            return self.fault(block, AlarmKind::VectorCodeOutsideMode, geometry);
        }
        self.release(geometry);
        let cancels = self.mode == Mode::Cancelling;
        match event.kind {
            Kind::Arc if cancels => return self.fault(block, AlarmKind::ArcAtCancel, geometry),
            Kind::Line | Kind::Arc => {
                geometry.follow(if cancels { clause::TRC_CANCEL_03 } else { clause::TRC_MODE_01 });
                (self.mode, self.lost) = (Mode::Cancel, false);
            }
            _ if cancels && self.counts_as_move(event) => {
                geometry.come_back(clause::TRC_CANCEL_03);
                (self.mode, self.lost) = (Mode::Cancel, false);
            }
            _ => self.stand(block, event, geometry),
        }
        Ok(())
    }

    /// A block of cancel mode with a side in force.
    #[inline(never)]
    pub(super) fn start_up<G: Geometry>(
        &mut self,
        block: usize,
        event: Event,
        side: Side,
        g: &mut G,
    ) -> Result<(), Alarm> {
        let start = match event.kind {
            // [TRC-VEC-01]
            _ if event.vector_code => return self.fault(block, AlarmKind::VectorCodeOutsideMode, g),
            Kind::Line | Kind::Arc | Kind::Dummy if self.shift_waits() => {
                self.mode = Mode::Offset;
                return self.compensate(block, event, side, g);
            }
            Kind::Line if self.gives_vector(event) => return self.start_at_vector(block, event, side, g),
            Kind::Arc if self.policy.arc == StartUpArc::Alarm => {
                return self.fault(block, AlarmKind::ArcAtStartUp, g);
            }
            // [TRC-START-09]
            Kind::Arc if self.mode == Mode::Cancelling => return self.fault(block, AlarmKind::ArcAtCancel, g),
            Kind::Arc => Start::EntryArc,
            Kind::Line if self.policy.start_up == StartUp::EntryNormal => Start::Entry,
            Kind::Line => Start::Block,
            // [TRC-LOOK-07]: an entry without length is too short for every tool.
            _ if self.policy.start_up == StartUp::EntryNormal && self.counts_as_move(event) && !self.shift_waits() => {
                return self.fault(block, AlarmKind::EntryTooShort, g);
            }
            _ => {
                self.start_without_movement(block, event, side, g);
                return Ok(());
            }
        };
        if start != Start::Block
            && let Err(kind) = g.enter(side)
        {
            return self.fault(block, kind, g);
        }
        (self.mode, self.side, self.first) = (Mode::Offset, side, true);
        self.await_end(block, start, event.rapid);
        g.begin(Begin::StartUp, side);
        self.stop_behind(event, g)
    }

    /// A start-up block that gives the vector at its end. [TRC-START-10]
    fn start_at_vector<G: Geometry>(&mut self, block: usize, event: Event, side: Side, g: &mut G) -> Result<(), Alarm> {
        (self.mode, self.side, self.first) = (Mode::Offset, side, true);
        self.await_end(block, Start::Block, event.rapid);
        g.begin(Begin::StartUp, side);
        self.settle(End::Vector(side, clause::TRC_START_10), clause::TRC_LOOK_02, g)
    }

    /// A block of cancel mode without movement, a side being in force: it may start up itself. [TRC-START-08]
    fn start_without_movement<G: Geometry>(&mut self, block: usize, event: Event, side: Side, geometry: &mut G) {
        let shifts = self.policy.shift_in == StartUpWithoutMovement::Shift && event.code.is_some() && !event.stops;
        if shifts {
            self.release(geometry);
            (self.side, self.first) = (side, true);
            self.await_end(block, Start::Shift, event.rapid);
            geometry.begin(Begin::Shift, side);
        } else if self.shift_waits() && self.may_wait(event) {
            self.held.push(event.rapid);
        } else {
            self.release(geometry);
            self.stand(block, event, geometry);
        }
    }

    /// It is a straight move of length zero, which counts as a block that moves where it starts or cancels. [TRC-LOOK-07]
    fn counts_as_move(&self, event: Event) -> bool {
        event.zero_length && self.policy.zero_length_move == ZeroLengthMove::StartsAndCancels
    }

    /// A block of the offset mode with G40 in it. [TRC-CANCEL-01]
    #[inline(never)]
    pub(super) fn cancel<G: Geometry>(&mut self, block: usize, event: Event, geometry: &mut G) -> Result<(), Alarm> {
        if event.vector_code {
            return self.fault(block, AlarmKind::VectorCodeOutsideMode, geometry);
        }
        if event.kind == Kind::Arc {
            return self.fault(block, AlarmKind::ArcAtCancel, geometry);
        }
        // A corner arc that waits makes none. [TRC-VEC-03]
        self.release(geometry);
        let moves = event.kind == Kind::Line;
        let start_up = self.pending.is_some_and(|pending| pending.start != Start::No);
        let meeting = if event.vector && self.policy.cancel_vector == CancelVector::ImaginaryLine {
            Some(Meeting::CancelLine)
        } else {
            (moves && self.policy.cancel == Cancel::TypeB).then_some(Meeting::Cancel)
        };
        if let Some(meeting) = meeting.filter(|_| self.pending.is_some() && !start_up) {
            match geometry.junction(meeting, self.side) {
                Ok(junction) => self.settle(End::Junction(junction), clause::TRC_LOOK_02, geometry)?,
                Err(kind) => return self.fault(block, kind, geometry),
            }
            geometry.corner_moves();
        } else {
            let clause = if start_up { clause::TRC_START_05 } else { clause::TRC_CANCEL_01 };
            self.settle(End::Normal(clause), clause::TRC_LOOK_02, geometry)?;
        }
        (self.mode, self.lost) = (Mode::Cancel, false);
        if moves {
            geometry.follow(clause::TRC_CANCEL_02);
        } else if self.counts_as_move(event) && !event.vector {
            geometry.come_back(clause::TRC_CANCEL_02);
        } else if self.policy.shift_out == CancelWithoutMovement::Shift {
            geometry.retreat();
        } else {
            self.mode = Mode::Cancelling;
            geometry.hold(block, event.rapid, clause::TRC_CANCEL_03);
        }
        Ok(())
    }
}
