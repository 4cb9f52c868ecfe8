//! Blocks that give or hold a vector: `spec/clauses/12-vectors.md`.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::SideCodeVector;
use radcomp_spec::{AlarmKind, Block, Compensation, Movement, Segment, Side};
use rug::Rational;

use super::pending::LeadIn;
use super::{Answer, CornerArc, Engine, Mode, Moving};
use crate::decision::{Judgement, Stop};
use crate::element::{Arm, Element};
use crate::geometry::Vector;
use crate::rules::junction::line_to;
use crate::rules::look_ahead::Settled;
use crate::rules::vector;

/// What a vector block without a move of the program asks for.
pub(super) enum Given {
    /// G39: a corner arc, to a direction or to the next element.
    Corner(Option<Arm>),
    /// G38 with I, J, K, and what counts as it: a new vector.
    New(Arm),
}

/// Whether a block is a vector block ([TRC-VEC-01]).
pub(super) fn is_vector_block(block: &Block<Rational>) -> bool {
    matches!(block.movement, Movement::HeldVector { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. })
}

impl Engine {
    /// What a block without movement gives, in offset mode; a direction of length zero is none.
    pub(super) fn given(&self, block: &Block<Rational>) -> Option<Given> {
        if self.mode != Mode::Offset {
            return None;
        }
        let along = |vector| Arm::imaginary(&self.position, &Vector::read(vector, self.number));
        match &block.movement {
            Movement::CornerArc { vector: None } => Some(Given::Corner(None)),
            Movement::CornerArc { vector: Some(vector) } => along(vector).map(|arm| Given::Corner(Some(arm))),
            Movement::NewVector { vector } => along(vector).map(Given::New),
            // [TRC-VEC-06] without movement.
            Movement::None | Movement::Line { .. } => self.beside(block).and_then(along).map(Given::New),
            Movement::Dummy { .. } | Movement::Arc { .. } | Movement::HeldVector { .. } => None,
        }
    }

    /// The words beside the code of a side, where they stand for a vector at right angles.
    fn beside<'b>(&self, block: &'b Block<Rational>) -> Option<&'b [Rational; 2]> {
        let right_angles = self.parameters.side_code_vector == SideCodeVector::RightAngles;
        let on = matches!(block.compensation, Some(Compensation::On(_)));
        block.vector.as_ref().filter(|_| right_angles && on)
    }

    /// A vector block without a move of the program.
    pub(super) fn give(
        &mut self,
        given: Given,
        (number, rapid): (usize, bool),
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        // [TRC-VEC-03]
        self.drop_corner_arc(judgement);
        if self.pending.is_some()
            && let Err(kind) = self.side_permitted(side)
        {
            return self.alarm(number, kind, judgement);
        }
        match given {
            Given::Corner(direction) => self.corner(direction, (number, rapid), side, judgement),
            Given::New(along) => self.new_vector(&along, (number, rapid), side, judgement),
        }
    }

    /// [TRC-VEC-02], [TRC-VEC-03]
    fn corner(
        &mut self,
        direction: Option<Arm>,
        (block, rapid): (usize, bool),
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        let clause = if direction.is_some() { clause::TRC_VEC_02 } else { clause::TRC_VEC_03 };
        let Some(pending) = &self.pending else {
            self.emit(block, rapid, clause, false, Segment::Hold, judgement);
            return Ok(());
        };
        let (before, end) = ((pending.element.last_arm(), pending.side), pending.own_normal());
        let arc = CornerArc { block, rapid, side, before, radius: pending.radius.clone() };
        self.settle_by_code(clause, end, side, judgement)?;
        match direction {
            Some(direction) => self.corner_move(arc, clause, &direction, judgement)?,
            None => self.corner_arc = Some(arc),
        }
        Ok(())
    }

    /// [TRC-VEC-05]
    fn new_vector(
        &mut self,
        along: &Arm,
        (block, rapid): (usize, bool),
        side: Side,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        let vector = match &self.pending {
            Some(pending) => {
                let vector = along.normal(side, &pending.radius);
                let end = if pending.element.is_arc() { pending.own_normal() } else { vector.clone() };
                self.settle_by_code(clause::TRC_VEC_05, end, side, judgement)?;
                vector
            }
            None => along.normal(side, &self.offset.radius),
        };
        self.settled = Some(Settled::ByCode);
        let moves = vector != self.tool;
        let segment = if moves { line_to(&vector) } else { Segment::Hold };
        self.emit(block, rapid, clause::TRC_VEC_05, moves, segment, judgement);
        Ok(())
    }

    /// Ends the pending block, and executes the blocks held.
    fn settle_by_code(&mut self, clause: Clause, end: Vector, side: Side, judgement: &mut Judgement<'_>) -> Answer {
        self.end_pending(clause, end, judgement)?;
        self.execute_held(clause::TRC_LOOK_02, judgement);
        self.element_read(side);
        self.settled = Some(Settled::ByCode);
        Ok(())
    }

    /// The own move of a corner arc.
    fn corner_move(
        &mut self,
        arc: CornerArc,
        clause: Clause,
        after: &Arm,
        judgement: &mut Judgement<'_>,
    ) -> Result<(), Stop> {
        let CornerArc { block, rapid, side, before: (before, side_before), radius } = arc;
        let reading = judgement.block;
        let segment = if radius.is_zero() {
            None
        } else {
            vector::corner_arc((&before, side_before), after, side, &radius, judgement)
                .map_err(|refused| self.refuse(reading, refused, judgement))?
        };
        let moves = segment.is_some();
        self.emit(block, rapid, clause, moves, segment.unwrap_or(Segment::Hold), judgement);
        Ok(())
    }

    /// The next element after a corner arc that waits for it ([TRC-VEC-03]).
    pub(super) fn settle_corner_arc(&mut self, next: &Element, judgement: &mut Judgement<'_>) -> Answer {
        let Some(arc) = self.corner_arc.take() else { return Ok(()) };
        self.corner_move(arc, clause::TRC_VEC_03, &next.first_arm(), judgement)?;
        self.execute_held(clause::TRC_LOOK_02, judgement);
        Ok(())
    }

    /// There is no corner arc: the block and those behind it are executed where the tool stands.
    pub(super) fn drop_corner_arc(&mut self, judgement: &mut Judgement<'_>) {
        let Some(CornerArc { block, rapid, .. }) = self.corner_arc.take() else { return };
        self.emit(block, rapid, clause::TRC_VEC_03, false, Segment::Hold, judgement);
        self.execute_held(clause::TRC_LOOK_01, judgement);
    }

    /// [TRC-VEC-04] a move of G38: the vector at its end is the one at its start.
    pub(super) fn held_vector(&mut self, block: Moving, side: Side, judgement: &mut Judgement<'_>) -> Answer {
        let Moving { number, rapid, element, .. } = block;
        if let Err(kind) = self.side_permitted(side) {
            return self.alarm(number, kind, judgement);
        }
        let LeadIn { clause, moves, .. } = self.reach((number, rapid), &element, side, None, judgement)?;
        self.corner_moves(clause, moves, number, rapid, judgement);
        self.element_read(side);
        let end = self.tool.minus(&element.start).plus(&element.end);
        self.emit(number, rapid, clause::TRC_VEC_04, true, line_to(&end), judgement);
        self.position = element.end;
        self.settled = Some(Settled::ByCode);
        Ok(())
    }

    /// [TRC-VEC-01] a vector block outside offset mode.
    pub(super) fn outside_mode(&mut self, number: usize, judgement: &mut Judgement<'_>) -> Answer {
        self.alarm(number, AlarmKind::VectorCodeOutsideMode, judgement)
    }
}
