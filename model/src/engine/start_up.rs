//! Start-up blocks, moving and not.

use radcomp_spec::parameters::{SideCodeVector, StartUp, StartUpArc, StartUpWithoutMovement};
use radcomp_spec::{AlarmKind, Block, Compensation, Segment, Side, clause};
use rug::Rational;

use super::pending::{LeadIn, Pending, PendingKind};
use super::{Answer, End, Engine, Mode, Moving, Shift};
use crate::decision::Judgement;
use crate::element::{Arm, Element};
use crate::geometry::Vector;
use crate::rules::junction::line_to;
use crate::rules::look_ahead::Settled;
use crate::rules::{arc, start_up};

impl Engine {
    /// [TRC-START-01]
    pub(super) fn start_up(&mut self, block: Moving, side: Side, judgement: &mut Judgement<'_>) -> Answer {
        let Moving { number, rapid, element, end: beside } = block;
        let end = element.end.clone();
        let (imaginary, at_right_angles) = self.beside_start_up(beside);
        if let Some(vector) = at_right_angles.and_then(|along| Arm::imaginary(&end, &along)) {
            let vector = vector.normal(side, &self.offset.radius);
            self.emit(number, rapid, clause::TRC_START_10, true, line_to(&vector), judgement);
            self.started(side, end);
            self.settled = Some(Settled::ByCode);
            return Ok(());
        }
        let (kind, element) = match self.entry(element, side, judgement) {
            Ok(entry) => entry,
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        self.started(side, end);
        let (fit, lead_in, radius) = (arc::Fit::Ordinary, LeadIn::none(), self.offset.radius.clone());
        self.pending = Some(Pending { block: number, rapid, kind, element, side, radius, imaginary, fit, lead_in });
        Ok(())
    }

    /// The start-up block has been read, and ends at this programmed point.
    fn started(&mut self, side: Side, end: Vector) {
        self.mode = Mode::Offset;
        self.settled = None;
        self.start_up_side = Some(side);
        self.element_side = Some(side);
        self.position = end;
    }

    /// What I, J, K beside the code give a start-up block: the direction of an imaginary line ([TRC-START-11]), or one to
    /// stand at right angles to ([TRC-START-10]).
    fn beside_start_up(&self, beside: End) -> (Option<Vector>, Option<Vector>) {
        let End::Beside(words) = beside else { return (None, None) };
        match self.parameters.side_code_vector {
            SideCodeVector::Refused => (None, None),
            SideCodeVector::RightAngles => (None, Some(words)),
            SideCodeVector::ImaginaryLine => (Some(words), None),
            SideCodeVector::ImaginaryPoint => (Some(words.opposite()), None),
        }
    }

    /// What a start-up block counts as.
    fn entry(
        &self,
        element: Element,
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Result<(PendingKind, Element), AlarmKind> {
        let radius = &self.offset.radius;
        if element.is_arc() {
            // [TRC-START-03], [TRC-START-09]
            if self.parameters.start_up_arc == StartUpArc::Alarm {
                return Err(AlarmKind::ArcAtStartUp);
            }
            if self.mode == Mode::Cancelling {
                return Err(AlarmKind::ArcAtCancel);
            }
            start_up::long_enough(&self.tool, &element.end, radius, judgement)?;
            arc::tool_fits(&element, side, radius, self.parameters.equal_radius, judgement)?;
            let element = start_up::entry_arc(element, &self.tool, side, radius, judgement)?;
            return Ok((PendingKind::Entry, element));
        }
        if self.parameters.start_up == StartUp::EntryNormal {
            start_up::long_enough(&element.start, &element.end, radius, judgement)?;
            return Ok((PendingKind::Entry, element));
        }
        Ok((PendingKind::StartUp, element))
    }

    /// Whether a block that does not move is itself a start-up block ([TRC-START-08]). One that stops reading ahead is
    /// not ([TRC-LOOK-08]).
    pub(super) fn shifts(&self, block: &Block<Rational>) -> bool {
        self.parameters.start_up_without_movement == StartUpWithoutMovement::Shift
            && self.mode != Mode::Offset
            && matches!(block.compensation, Some(Compensation::On(_)))
            && !block.stops_look_ahead
    }

    /// Waits for the next element; of several such blocks the last one starts up.
    pub(super) fn await_shift(&mut self, block: usize, rapid: bool, judgement: &mut Judgement<'_>) {
        self.drop_shift(judgement);
        self.shift = Some(Shift { block, rapid, radius: self.offset.radius.clone() });
        self.start_up_side = self.side();
        self.element_side = self.side();
    }

    /// The tool moves to the normal of the next element at once, and the blocks held are executed there.
    pub(super) fn settle_shift(&mut self, next: &Element, side: Side, judgement: &mut Judgement<'_>) {
        let Some(Shift { block, rapid, radius }) = self.shift.take() else { return };
        let vector = start_up::shift(next, side, &radius);
        self.emit(block, rapid, clause::TRC_START_08, true, line_to(&vector), judgement);
        self.execute_held(clause::TRC_LOOK_02, judgement);
        self.mode = Mode::Offset;
        self.settled = None;
    }

    /// There is no shift: the block and those after it are blocks without movement, and the code acts on the next block
    /// that moves.
    pub(super) fn drop_shift(&mut self, judgement: &mut Judgement<'_>) {
        let Some(Shift { block, rapid, .. }) = self.shift.take() else { return };
        self.start_up_side = None;
        self.element_side = None;
        self.emit(block, rapid, clause::TRC_LOOK_01, false, Segment::Hold, judgement);
        self.execute_held(clause::TRC_LOOK_01, judgement);
    }
}
