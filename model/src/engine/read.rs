//! One block after another: the checks in their order, and what a block does in the mode in force.

use radcomp_spec::clause;
use radcomp_spec::parameters::{OffsetChange, SameCode, SideChange};
use radcomp_spec::{AlarmKind, Block, Compensation, DecisionKind, Movement};
use rug::Rational;

use super::own_move::own_move;
use super::vector::is_vector_block;
use super::{Answer, End, Engine, Mode, Moving};
use crate::decision::Judgement;
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::rules::arc;
use crate::rules::mode::{self, Offset};

impl Engine {
    /// [TRC-MODE-06] the order of the checks.
    pub(super) fn read(&mut self, number: usize, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Answer {
        let cancels = block.compensation == Some(Compensation::Off);
        self.reading_cancel = cancels && (self.mode == Mode::Offset || self.shift.is_some());
        if !mode::in_range(block, self.parameters.negative_radius) {
            return self.alarm(number, AlarmKind::OutOfRange, judgement);
        }
        // [TRC-MODE-05]
        if mode::same_code(block, self.code) {
            match self.parameters.same_code {
                SameCode::Ordinary => {}
                SameCode::Normal => self.settle_on_normal(judgement)?,
                SameCode::Alarm => return self.alarm(number, AlarmKind::SameCode, judgement),
            }
        }
        // [TRC-SIDE-01]
        if mode::other_code(block, self.code) && self.parameters.side_change == SideChange::Forbidden {
            return self.alarm(number, AlarmKind::SideChangeForbidden, judgement);
        }
        let offset = block.radius.as_ref().map(|radius| Offset::read(radius, self.number));
        let line = self.line(block, judgement);
        if let Some(offset) = &offset
            && self.parameters.offset_change == OffsetChange::Alarm
            && self.radius_is_fixed(block, line.is_some())
            && offset.radius != self.offset.radius
        {
            return self.alarm(number, AlarmKind::OffsetChangedInMode, judgement);
        }
        // [TRC-MODE-08]
        if let Some(kind) = block.not_in_mode {
            return self.alarm(number, kind, judgement);
        }
        if is_vector_block(block) && (cancels || self.mode != Mode::Offset) {
            return self.outside_mode(number, judgement);
        }
        let element = match self.arc(block, judgement) {
            Ok(arc) => arc.or(line),
            Err(kind) => return self.alarm(number, kind, judgement),
        };
        if self.mode == Mode::Offset && cancels {
            return self.cancel(number, block, element, offset, judgement);
        }
        if cancels {
            self.drop_shift(judgement);
        }
        if let Some(offset) = offset {
            self.offset = offset;
        }
        // [TRC-MODE-02] the last code before a block that moves counts.
        match block.compensation {
            Some(Compensation::Off) => self.code = None,
            Some(Compensation::On(side)) => self.code = Some(side),
            None => {}
        }
        // [TRC-START-12], [TRC-CORNER-11] before the junction with this block is formed.
        if let Some(approach) = block.approach {
            self.parameters.approach(approach);
        }
        if let Some(corner) = block.corner {
            self.outer_corner = corner;
        }
        match element {
            Some(element) => {
                let end = self.end_of(block);
                self.moves(Moving { number, rapid: block.rapid, element, end }, judgement)?;
                // [TRC-LOOK-08] the block moves first.
                if block.stops_look_ahead { self.lose(clause::TRC_LOOK_03, judgement) } else { Ok(()) }
            }
            None => self.does_not_move(number, block, judgement),
        }
    }

    /// The straight element that a block moves along, or nothing ([TRC-LOOK-01]). Words of axes outside the plane are in
    /// no block ([TRC-MODE-09]).
    fn line(&self, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Option<Element> {
        let (Movement::Line { end } | Movement::HeldVector { end }, None) = (&block.movement, block.not_in_mode) else {
            return None;
        };
        let element = Element::line(self.position.clone(), Vector::read(end, self.number));
        let Shape::Line { direction, length } = &element.shape else { return None };
        let squared = direction.length_squared();
        judgement.decide(DecisionKind::Moves, &squared, length.clone()).is_gt().then_some(element)
    }

    /// The arc that a block moves along, or nothing.
    fn arc(&self, block: &Block<Rational>, judgement: &mut Judgement<'_>) -> Result<Option<Element>, AlarmKind> {
        let Movement::Arc { end, centre, direction } = &block.movement else { return Ok(None) };
        let words = arc::Words::read(end, centre, *direction, self.number);
        arc::programmed(&self.position, words, &self.parameters, judgement).map(Some)
    }

    /// What the vector at the end of a block that moves comes from.
    fn end_of(&self, block: &Block<Rational>) -> End {
        match (&block.movement, block.compensation, &block.vector) {
            (Movement::HeldVector { .. }, ..) => End::Held,
            (Movement::Line { .. }, Some(Compensation::On(_)), Some(vector)) => {
                End::Beside(Vector::read(vector, self.number))
            }
            _ => End::Junction,
        }
    }

    fn moves(&mut self, block: Moving, judgement: &mut Judgement<'_>) -> Answer {
        match (self.mode, self.side()) {
            (Mode::Offset, Some(side)) => self.compensated(block, side, judgement),
            (_, Some(side)) if self.shift.is_some() => self.compensated(block, side, judgement),
            (_, Some(side)) => self.start_up(block, side, judgement),
            (Mode::Cancel, None) => {
                self.uncompensated(block, judgement);
                Ok(())
            }
            // In offset mode without a code the block cancels, which `read` has seen to.
            (Mode::Cancelling | Mode::Offset, None) => self.cancel_move(block, clause::TRC_CANCEL_03, judgement),
        }
    }

    /// [TRC-MODE-01]
    fn uncompensated(&mut self, block: Moving, judgement: &mut Judgement<'_>) {
        let segment = own_move(&block.element, &block.element.end, true);
        self.emit(block.number, block.rapid, clause::TRC_MODE_01, true, segment, judgement);
        self.position = block.element.end;
    }

    /// [TRC-MODE-03] whether a radius of another magnitude would raise the alarm at this block: the start-up block has
    /// been read, and the block neither cancels nor is another start-up block without movement in its place.
    fn radius_is_fixed(&self, block: &Block<Rational>, straight: bool) -> bool {
        let moves = match block.movement {
            Movement::Dummy { .. } => true,
            Movement::Arc { .. } => block.not_in_mode.is_none(),
            _ => straight,
        };
        let replaces_shift = !moves && self.shifts(block);
        let started = self.mode == Mode::Offset || (self.shift.is_some() && !replaces_shift);
        started && block.compensation != Some(Compensation::Off)
    }
}
