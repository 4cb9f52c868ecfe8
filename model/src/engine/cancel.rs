//! Blocks with G40 in offset mode, and cancel blocks.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::CancelWithoutMovement;
use radcomp_spec::{AlarmKind, Block, Segment};
use rug::Rational;

use super::pending::LeadIn;
use super::{Answer, End, Engine, Mode, Moving};
use crate::decision::Judgement;
use crate::element::Element;
use crate::geometry::Vector;
use crate::rules::cancel;
use crate::rules::junction::line_to;
use crate::rules::mode::Offset;

impl Engine {
    /// A block with G40 in offset mode: the junction before it, then [TRC-CANCEL-02], [TRC-CANCEL-03] or
    /// [TRC-CANCEL-06].
    pub(super) fn cancel(
        &mut self,
        number: usize,
        block: &Block<Rational>,
        element: Option<Element>,
        offset: Option<Offset>,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if element.as_ref().is_some_and(Element::is_arc) {
            return self.alarm(number, AlarmKind::ArcAtCancel, judgement);
        }
        // [TRC-START-12], [TRC-CORNER-11] before the junction with this block is formed.
        if let Some(approach) = block.approach {
            self.parameters.approach(approach);
        }
        if let Some(corner) = block.corner {
            self.outer_corner = corner;
        }
        self.drop_corner_arc(judgement);
        let mut lead_in = LeadIn::none();
        if let Some(pending) = &self.pending {
            let imaginary = block.vector.as_ref().map(|vector| Vector::read(vector, self.number));
            let setting = self.setting(block.rapid);
            lead_in = match cancel::junction(pending, element.as_ref(), imaginary.as_ref(), setting, judgement) {
                Ok(junction) => self.pass(junction, judgement)?,
                Err(refused) => return Err(self.refuse(number, refused, judgement)),
            };
        }
        self.code = None;
        self.mode = Mode::Cancelling;
        self.settled = None;
        self.start_up_side = None;
        self.element_side = None;
        // The pending block has ended with the radius that it was read with.
        if let Some(offset) = offset {
            self.offset = offset;
        }
        let Some(element) = element else {
            if block.vector.is_none() && self.starts_and_cancels(block) {
                self.move_to_programmed_point(number, block.rapid, clause::TRC_CANCEL_02, judgement);
            } else {
                self.cancel_without_movement(number, block.rapid, judgement);
            }
            return Ok(());
        };
        self.corner_moves(lead_in.clause, lead_in.moves, number, block.rapid, judgement);
        let moving = Moving { number, rapid: block.rapid, element, end: End::Junction };
        self.cancel_move(moving, clause::TRC_CANCEL_02, judgement)
    }

    /// [TRC-CANCEL-02], or [TRC-CANCEL-03] after a G40 without movement.
    pub(super) fn cancel_move(&mut self, block: Moving, clause: Clause, judgement: &mut Judgement<'_>) -> Answer {
        let Moving { number, rapid, element, .. } = block;
        // [TRC-CANCEL-04]
        if element.is_arc() {
            return self.alarm(number, AlarmKind::ArcAtCancel, judgement);
        }
        self.position = element.end;
        self.move_to_programmed_point(number, rapid, clause, judgement);
        Ok(())
    }

    /// The own move of a cancel block, one without length included ([TRC-LOOK-07]).
    pub(super) fn move_to_programmed_point(
        &mut self,
        number: usize,
        rapid: bool,
        clause: Clause,
        judgement: &mut Judgement<'_>,
    ) {
        let end = line_to(&self.position);
        self.emit(number, rapid, clause, true, end, judgement);
        self.mode = Mode::Cancel;
    }

    /// [TRC-CANCEL-03]; [TRC-CANCEL-06] the tool moves to the programmed point at once.
    fn cancel_without_movement(&mut self, number: usize, rapid: bool, judgement: &mut Judgement<'_>) {
        match self.parameters.cancel_without_movement {
            CancelWithoutMovement::None => {
                self.emit(number, rapid, clause::TRC_CANCEL_03, false, Segment::Hold, judgement);
            }
            CancelWithoutMovement::Shift => {
                self.mode = Mode::Cancel;
                if self.tool == self.position {
                    self.emit(number, rapid, clause::TRC_LOOK_01, false, Segment::Hold, judgement);
                } else {
                    let shift = line_to(&self.position);
                    self.emit(number, rapid, clause::TRC_CANCEL_06, true, shift, judgement);
                }
            }
        }
    }
}
