//! Elements of offset mode: blocks that move, and dummy blocks.

use radcomp_spec::parameters::{EqualRadius, Interference, SideCodeVector};
use radcomp_spec::{AlarmKind, Segment, Side, clause};

use super::own_move::Onward;
use super::pending::{LeadIn, Pending, PendingKind};
use super::rows::Next;
use super::{Answer, End, Engine, Moving};
use crate::decision::{Judgement, Stop};
use crate::element::{Arm, Element, Shape};
use crate::geometry::larger;
use crate::rules::junction;
use crate::rules::look_ahead::{self, Settled};
use crate::rules::{arc, side_change, start_up};

impl Engine {
    /// A block that moves in offset mode.
    pub(super) fn compensated(&mut self, block: Moving, side: Side, judgement: &mut Judgement<'_>) -> Answer {
        if matches!(block.end, End::Held) {
            return self.held_vector(block, side, judgement);
        }
        let Moving { number, rapid, element, end } = block;
        if let Err(kind) = self.side_permitted(side) {
            return self.alarm(number, kind, judgement);
        }
        let fit = match self.fit(&element, side, judgement) {
            Ok(fit) => fit,
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        let compares = self.parameters.interference != Interference::Off;
        let row = compares.then(|| Next { element: element.clone(), fit });
        let lead_in = self.reach((number, rapid), &element, side, row, judgement)?;
        self.element_read(side);
        self.position = element.end.clone();
        let (kind, radius, imaginary) = (PendingKind::Offset, self.offset.radius.clone(), None);
        // [TRC-VEC-06]
        let given = match end {
            End::Beside(along) if self.parameters.side_code_vector == SideCodeVector::RightAngles => {
                Arm::imaginary(&element.end, &along).map(|along| along.normal(side, &radius))
            }
            _ => None,
        };
        self.pending = Some(Pending { block: number, rapid, kind, element, side, radius, imaginary, fit, lead_in });
        if let Some(vector) = given {
            self.end_pending(clause::TRC_VEC_06, vector, judgement)?;
            self.settled = Some(Settled::ByCode);
        }
        Ok(())
    }

    /// How the tool fits inside an arc, with the value of its block and with that of the junction before it
    /// ([TRC-ARC-05], [TRC-MODE-11]).
    fn fit(&self, element: &Element, side: Side, judgement: &mut Judgement<'_>) -> Result<arc::Fit, AlarmKind> {
        let own = &self.offset.radius;
        let shift = self.shift.as_ref().map(|shift| &shift.radius);
        let other = self.pending.as_ref().map(|pending| &pending.radius).or(shift).filter(|other| *other != own);
        let Some(other) = other else {
            return arc::tool_fits(element, side, own, self.parameters.equal_radius, judgement);
        };
        let fit = arc::tool_fits(element, side, &larger(own, other), EqualRadius::Alarm, judgement)?;
        match element.shape {
            Shape::Arc { full: true, .. } => Err(AlarmKind::OffsetChangedInMode),
            _ => Ok(fit),
        }
    }

    /// [TRC-SIDE-01], [TRC-SIDE-04]
    pub(super) fn side_permitted(&self, side: Side) -> Result<(), AlarmKind> {
        side_change::permitted(&self.parameters, side, self.element_side, self.start_up_side)
    }

    pub(super) fn element_read(&mut self, side: Side) {
        self.start_up_side = None;
        self.element_side = Some(side);
    }

    /// Brings the tool to where the next element starts; answers the moves that the next block owns. `row` is that element
    /// where its block may be joined to a row ([TRC-INT-01]).
    pub(super) fn reach(
        &mut self,
        (number, rapid): (usize, bool),
        next: &Element,
        side: Side,
        row: Option<Next>,
        judgement: &mut Judgement<'_>,
    ) -> Result<LeadIn, Stop> {
        if self.shift.is_some() {
            self.settle_shift(next, side, judgement);
            return Ok(LeadIn::none());
        }
        if let Some(pending) = &self.pending {
            let setting = self.setting(rapid);
            let junction = match pending.kind {
                PendingKind::StartUp => {
                    let before = (&pending.element, pending.imaginary.as_ref());
                    start_up::junction(before, next, side, setting, judgement)
                }
                PendingKind::Entry | PendingKind::Offset => {
                    junction::between(&pending.element, pending.side, next, side, setting, judgement)
                }
            };
            return match junction {
                Ok(junction) => {
                    let onward = match row {
                        _ if pending.kind != PendingKind::Offset || pending.side != side => Onward::Ends,
                        Some(next) if pending.radius == self.offset.radius => Onward::Joins(next),
                        _ => Onward::Corner,
                    };
                    self.pass(junction, onward, judgement)
                }
                Err(refused) => Err(self.refuse(number, refused, judgement)),
            };
        }
        self.settle_corner_arc(next, judgement)?;
        if let Some(settled) = self.settled.take() {
            look_ahead::advise(&settled, next, side, &self.offset.radius, judgement);
        }
        let resumed = look_ahead::resume(&self.tool, next, side, &self.offset.radius, judgement);
        if let Some(last) = resumed.moves.last() {
            self.stand_at_end_of(last);
        }
        Ok(LeadIn { clause: resumed.clause, moves: resumed.moves, corner: None })
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
        let LeadIn { clause, moves, .. } = self.reach((number, rapid), element, side, None, judgement)?;
        self.corner_moves(clause, moves, number, rapid, judgement);
        self.emit(number, rapid, clause::TRC_DUMMY_02, false, Segment::Hold, judgement);
        self.element_read(side);
        self.settled = Some(Settled::Dummy { direction: element.first_arm().unit() });
        Ok(())
    }
}
