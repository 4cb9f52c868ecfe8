//! Blocks without movement, and junctions that are settled without a next element.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{StartUp, StartUpLost, ZeroLengthMove};
use radcomp_spec::{AlarmKind, Block, Movement, Segment};
use rug::Rational;

use super::pending::PendingKind;
use super::{Answer, Engine, Mode};
use crate::decision::Judgement;
use crate::geometry::Vector;
use crate::rules::dummy;
use crate::rules::look_ahead::Settled;

impl Engine {
    pub(super) fn does_not_move(
        &mut self,
        number: usize,
        block: &Block<Rational>,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if self.mode != Mode::Offset && self.starts_and_cancels(block) {
            if self.mode == Mode::Cancelling && self.code.is_none() {
                self.move_to_programmed_point(number, block.rapid, clause::TRC_CANCEL_03, judgement);
                return Ok(());
            }
            let starts =
                self.code.is_some() && self.shift.is_none() && self.parameters.start_up == StartUp::EntryNormal;
            if starts {
                return self.alarm(number, AlarmKind::EntryTooShort, judgement);
            }
        }
        if let (Some(given), Some(side)) = (self.given(block), self.side()) {
            self.give(given, (number, block.rapid), side, judgement)?;
            // [TRC-LOOK-08]
            return if block.stops_look_ahead { self.lose(clause::TRC_LOOK_03, judgement) } else { Ok(()) };
        }
        let unsettled = self.pending.is_some() || self.shift.is_some() || self.corner_arc.is_some();
        if let (Movement::Dummy { vector }, true, Some(side)) = (&block.movement, unsettled, self.side())
            && let Some(element) = dummy::element(&self.position, &Vector::read(vector, self.number))
        {
            return self.dummy(number, block.rapid, &element, side, judgement);
        }
        if self.shifts(block) {
            self.await_shift(number, block.rapid, judgement);
            return Ok(());
        }
        // [TRC-DUMMY-04] nothing is pending after a dummy block, and nothing is counted then.
        if unsettled {
            self.held.push(number, block.rapid);
            let too_many = self.parameters.non_moving_allowed.is_some_and(|most| self.held.count() > usize::from(most));
            if too_many || self.breaks_look_ahead(block) {
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

    /// [TRC-LOOK-07] whether a block, which has turned out not to move, is a straight move of length zero that may count as
    /// a start-up or a cancel block.
    pub(super) fn starts_and_cancels(&self, block: &Block<Rational>) -> bool {
        let straight = matches!(block.movement, Movement::Line { .. });
        straight && self.parameters.zero_length_move == ZeroLengthMove::StartsAndCancels
    }

    /// Whether a block without movement loses the look-ahead by itself: a straight move of length zero
    /// ([TRC-LOOK-07]), or a code that stops reading ahead ([TRC-LOOK-08]).
    fn breaks_look_ahead(&self, block: &Block<Rational>) -> bool {
        let zero_length = matches!(block.movement, Movement::Line { .. } | Movement::HeldVector { .. });
        block.stops_look_ahead || (zero_length && self.parameters.zero_length_move == ZeroLengthMove::BreaksLookAhead)
    }

    /// The next element is not found: look-ahead is lost ([TRC-LOOK-03]) or the program ends ([TRC-MODE-04]).
    pub(super) fn lose(&mut self, clause: Clause, judgement: &mut Judgement<'_>) -> Answer {
        self.drop_shift(judgement);
        self.drop_corner_arc(judgement);
        let Some(pending) = &self.pending else { return Ok(()) };
        let no_vector = pending.kind == PendingKind::StartUp && self.parameters.start_up_lost == StartUpLost::NoVector;
        let clause = if pending.starts_up() { clause::TRC_START_04 } else { clause };
        let end = if no_vector {
            self.mode = Mode::Cancel;
            self.start_up_side = None;
            self.element_side = None;
            pending.element.end.clone()
        } else {
            let normal = pending.element.last_arm().unit().toward(pending.side);
            self.settled = Some(Settled::Lost { normal });
            pending.own_normal()
        };
        self.end_pending(clause, end, judgement)?;
        self.execute_held(clause::TRC_LOOK_03, judgement);
        Ok(())
    }

    /// [TRC-MODE-05] the pending block ends on its own normal, which settles the junction.
    pub(super) fn settle_on_normal(&mut self, judgement: &mut Judgement<'_>) -> Answer {
        let Some(pending) = &self.pending else { return Ok(()) };
        let end = pending.own_normal();
        self.end_pending(clause::TRC_MODE_05, end, judgement)?;
        self.execute_held(clause::TRC_LOOK_02, judgement);
        self.settled = Some(Settled::ByCode);
        Ok(())
    }
}
