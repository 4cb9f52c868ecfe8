//! The last block that moves, and the blocks without movement held after it.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::PendingAtAlarm;
use radcomp_spec::{Alarm, Segment, Side};

use super::{Answer, Engine};
use crate::decision::{Judgement, Stop};
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::corner::next_owns;
use crate::rules::junction::{Junction, Refused, line_to};
use crate::rules::{arc, wedge};

/// The last block that moves, whose end vector is not settled.
#[derive(Clone, Debug)]
pub(crate) struct Pending {
    pub(crate) block: usize,
    pub(crate) rapid: bool,
    pub(crate) kind: PendingKind,
    pub(crate) element: Element,
    pub(crate) side: Side,
    /// The tool radius in force in the block: that of the vector at its end ([TRC-MODE-11]).
    pub(crate) radius: Real,
    /// The direction of the imaginary line that its code gives it, if it is a start-up block ([TRC-START-11]).
    pub(crate) imaginary: Option<Vector>,
    /// How the tool fits inside it, if it is an arc.
    pub(crate) fit: arc::Fit,
    /// The moves before its own move that it owns. They are made when the block is: an alarm at the block stops them
    /// too ([TRC-MODE-06]), but with `pending-at-alarm` = `lost` ([TRC-MODE-10]).
    pub(crate) lead_in: LeadIn,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PendingKind {
    /// A start-up block of type A or B, which is no compensated element.
    StartUp,
    /// A start-up block that counts as compensated from its end on ([TRC-START-07], [TRC-START-09]).
    Entry,
    /// A block of offset mode.
    Offset,
}

impl Pending {
    /// The vector at right angles to the block at its end.
    pub(crate) fn own_normal(&self) -> Vector {
        self.element.last_arm().normal(self.side, &self.radius)
    }

    /// Whether it is the start-up block.
    pub(crate) fn starts_up(&self) -> bool {
        self.kind != PendingKind::Offset
    }
}

/// Moves, and the clause of the junction that made them.
#[derive(Clone, Debug)]
pub(crate) struct LeadIn {
    pub(crate) clause: Clause,
    pub(crate) moves: Vec<Segment<Real>>,
}

impl LeadIn {
    /// A block that starts where the one before it ends.
    pub(crate) fn none() -> Self {
        LeadIn { clause: clause::TRC_CORNER_12, moves: Vec::new() }
    }
}

/// Blocks without movement that wait for a junction, in runs of consecutive blocks of one traverse rate.
#[derive(Clone, Debug, Default)]
pub(super) struct Held {
    runs: Vec<Run>,
    count: usize,
}

#[derive(Clone, Copy, Debug)]
struct Run {
    first: usize,
    last: usize,
    rapid: bool,
}

impl Held {
    pub(super) fn push(&mut self, block: usize, rapid: bool) {
        self.count += 1;
        match self.runs.last_mut() {
            Some(run) if run.rapid == rapid && run.last + 1 == block => run.last = block,
            _ => self.runs.push(Run { first: block, last: block, rapid }),
        }
    }

    /// How many blocks are held.
    pub(super) fn count(&self) -> usize {
        self.count
    }
}

impl Engine {
    /// Ends the pending block at a junction, and executes the blocks held. Answers the moves that the next block owns
    /// ([TRC-CORNER-12]); the tool is taken to stand behind them.
    pub(super) fn pass(&mut self, junction: Junction, judgement: &mut Judgement<'_>) -> Result<LeadIn, Stop> {
        let Some((block, rapid)) = self.pending.as_ref().map(|pending| (pending.block, pending.rapid)) else {
            return Err(Stop::Contradiction);
        };
        let Junction { clause, first, moves, approach } = junction;
        self.end_pending(clause, first, judgement)?;
        let mut left = if next_owns(self.parameters.corner_owner) {
            moves
        } else {
            self.corner_moves(clause, moves, block, rapid, judgement);
            Vec::new()
        };
        left.extend(approach);
        self.execute_held(clause::TRC_LOOK_02, judgement);
        if let Some(last) = left.last() {
            self.stand_at_end_of(last);
        }
        Ok(LeadIn { clause, moves: left })
    }

    pub(super) fn corner_moves(
        &mut self,
        clause: Clause,
        moves: Vec<Segment<Real>>,
        block: usize,
        rapid: bool,
        judgement: &mut Judgement<'_>,
    ) {
        for segment in moves {
            self.emit(block, rapid, clause, false, segment, judgement);
        }
    }

    /// Makes the pending block's own move to its end vector.
    pub(super) fn end_pending(&mut self, clause: Clause, end: Vector, judgement: &mut Judgement<'_>) -> Answer {
        let Some(pending) = self.pending.take() else { return Ok(()) };
        let Pending { block, rapid, kind, element, side, radius, imaginary: _, fit, lead_in } = pending;
        let at_centre = fit == arc::Fit::Point;
        let whole_circle = kind == PendingKind::Offset
            && !at_centre
            && arc::whole_turn(&element, side, &radius, (&self.tool, &end), judgement);
        if kind == PendingKind::Offset || (kind == PendingKind::Entry && element.is_arc()) {
            let reading = core::mem::replace(&mut judgement.block, block);
            let exempt = whole_circle || at_centre;
            let looked_at = wedge::forward(&element, &self.tool, &end, exempt, &self.parameters, judgement);
            judgement.block = reading;
            if let Err(kind) = looked_at {
                // [TRC-MODE-10]
                if self.parameters.pending_at_alarm == PendingAtAlarm::Lost {
                    self.corner_moves(lead_in.clause, lead_in.moves, block, rapid, judgement);
                }
                return Err(Stop::Alarm(Alarm { block, kind }));
            }
        }
        self.corner_moves(lead_in.clause, lead_in.moves, block, rapid, judgement);
        // [TRC-ARC-08] the own move of an arc at whose centre the tool stands has no length.
        let segment = if at_centre { line_to(&end) } else { own_move(&element, &end, whole_circle) };
        self.emit(block, rapid, clause, true, segment, judgement);
        Ok(())
    }

    pub(super) fn execute_held(&mut self, clause: Clause, judgement: &mut Judgement<'_>) {
        for Run { first, last, rapid } in core::mem::take(&mut self.held).runs {
            for block in first..=last {
                self.emit(block, rapid, clause, false, Segment::Hold, judgement);
            }
        }
    }

    /// The alarm of a junction that has no vectors.
    pub(super) fn refuse(&mut self, block: usize, refused: Refused, judgement: &mut Judgement<'_>) -> Stop {
        match refused {
            Refused::Contradiction => Stop::Contradiction,
            Refused::Alarm(kind) => match self.alarm(block, kind, judgement) {
                Err(stop) => stop,
                Ok(()) => Stop::Contradiction,
            },
        }
    }
}

/// The move of an element's block to a vector.
pub(super) fn own_move(element: &Element, end: &Vector, whole_circle: bool) -> Segment<Real> {
    match &element.shape {
        Shape::Line { .. } => line_to(end),
        Shape::Arc { centre, sense, full, entry, .. } => {
            let centre = entry.as_deref().map_or(centre, |entry| &entry.centre);
            Segment::Arc {
                end: [end.a.clone(), end.b.clone()],
                centre: [centre.a.clone(), centre.b.clone()],
                direction: *sense,
                full: whole_circle && *full,
            }
        }
    }
}
