//! Elements of offset mode: blocks that move, and dummy blocks.

use radcomp_spec::{AlarmKind, Segment, Side, clause};

use super::pending::{LeadIn, Pending, PendingKind};
use super::{Answer, Engine, Moving};
use crate::decision::{Judgement, Stop};
use crate::element::Element;
use crate::rules::junction;
use crate::rules::look_ahead::{self, Settled};
use crate::rules::{arc, side_change, start_up};

impl Engine {
    /// A block that moves in offset mode.
    pub(super) fn compensated(&mut self, block: Moving, side: Side, judgement: &mut Judgement<'_>) -> Answer {
        let Moving { number, rapid, element } = block;
        if let Err(kind) = self.side_permitted(side) {
            return self.alarm(number, kind, judgement);
        }
        let fit = match arc::tool_fits(&element, side, &self.offset.radius, self.parameters.equal_radius, judgement) {
            Ok(fit) => fit,
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        let lead_in = self.reach(number, rapid, &element, side, judgement)?;
        self.element_read(side);
        self.position = element.end.clone();
        let kind = PendingKind::Offset;
        self.pending = Some(Pending { block: number, rapid, kind, element, side, fit, lead_in });
        Ok(())
    }

    /// [TRC-SIDE-01], [TRC-SIDE-04]
    fn side_permitted(&self, side: Side) -> Result<(), AlarmKind> {
        side_change::permitted(&self.parameters, side, self.element_side, self.start_up_side)
    }

    fn element_read(&mut self, side: Side) {
        self.start_up_side = None;
        self.element_side = Some(side);
    }

    /// Brings the tool to where the next element starts; answers the moves that the next block owns.
    fn reach(
        &mut self,
        number: usize,
        rapid: bool,
        next: &Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Result<LeadIn, Stop> {
        if self.shift.is_some() {
            self.settle_shift(next, side, judgement);
            return Ok(LeadIn::none());
        }
        if let Some(pending) = &self.pending {
            let setting = self.setting(rapid);
            let junction = match pending.kind {
                PendingKind::StartUp => start_up::junction(&pending.element, next, side, setting, judgement),
                PendingKind::Entry | PendingKind::Offset => {
                    junction::between(&pending.element, pending.side, next, side, setting, judgement)
                }
            };
            return match junction {
                Ok(junction) => self.pass(junction, judgement),
                Err(refused) => Err(self.refuse(number, refused, judgement)),
            };
        }
        if let Some(settled) = self.settled.take() {
            look_ahead::advise(&settled, next, side, &self.offset.radius, judgement);
        }
        let resumed = look_ahead::resume(&self.tool, next, side, &self.offset.radius, judgement);
        if let Some(last) = resumed.moves.last() {
            self.stand_at_end_of(last);
        }
        Ok(LeadIn { clause: resumed.clause, moves: resumed.moves })
    }

    /// [TRC-DUMMY-02] a dummy block whose junction is not settled.
    pub(super) fn dummy(
        &mut self,
        number: usize,
        rapid: bool,
        element: &Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        if let Err(kind) = self.side_permitted(side) {
            return self.alarm(number, kind, judgement);
        }
        let LeadIn { clause, moves } = self.reach(number, rapid, element, side, judgement)?;
        self.corner_moves(clause, moves, number, rapid, judgement);
        self.emit(number, rapid, clause::TRC_DUMMY_02, false, Segment::Hold, judgement);
        self.element_read(side);
        self.settled = Some(Settled::Dummy { direction: element.first_arm().unit() });
        Ok(())
    }
}
