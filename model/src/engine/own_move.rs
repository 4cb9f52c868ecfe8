//! The own move of a block that moves, once the vectors at both its ends are settled, and what is looked at then.

use radcomp_spec::clause;
use radcomp_spec::parameters::{Interference, PendingAtAlarm};
use radcomp_spec::{Alarm, AlarmKind, Segment, Step};

use super::pending::{Pending, PendingKind};
use super::rows::{Next, RowBlock};
use super::{Answer, Engine};
use crate::decision::{Judgement, Stop};
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use crate::rules::junction::{Junction, line_to};
use crate::rules::{arc, interference, wedge};

/// How a row goes on behind a block ([TRC-INT-01]).
pub(super) enum Onward {
    /// A corner joins the block to this one.
    Joins(Next),
    /// The row ends at a corner.
    Corner,
    /// The row ends without a corner.
    Ends,
}

impl Onward {
    /// The vectors at the block's end.
    fn vectors(&self, junction: &Junction) -> Vec<Vector> {
        match self {
            Onward::Joins(_) | Onward::Corner => vectors(&junction.first, &junction.moves),
            Onward::Ends => vec![junction.first.clone()],
        }
    }
}

/// The points that the tool passes at a corner.
fn vectors(first: &Vector, moves: &[Segment<Real>]) -> Vec<Vector> {
    let ends = moves.iter().filter_map(|segment| match segment {
        Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. } => Some(Vector::new(a.clone(), b.clone())),
        Segment::Hold => None,
    });
    core::iter::once(first.clone()).chain(ends).collect()
}

impl Engine {
    /// Makes a block's own move to a junction; answers what is left of that ([TRC-INT-03]).
    pub(super) fn end(
        &mut self,
        mut pending: Pending,
        mut junction: Junction,
        onward: &Onward,
        judgement: &mut Judgement<'_>,
    ) -> Result<Junction, Stop> {
        let at_centre = pending.fit == arc::Fit::Point;
        let whole_circle = pending.kind == PendingKind::Offset
            && !at_centre
            && arc::whole_turn(
                &pending.element,
                pending.side,
                &pending.radius,
                (&self.tool, &junction.first),
                judgement,
            );
        let exempt = whole_circle || at_centre;
        let reading = core::mem::replace(&mut judgement.block, pending.block);
        let removed = match self.parameters.interference {
            Interference::Off => self.looked_at(&mut pending, &junction.first, exempt, judgement).map(|()| false),
            Interference::RemoveVectors if pending.kind == PendingKind::Offset && !exempt => {
                self.without_vectors(&mut pending, &mut junction, onward, judgement)
            }
            Interference::RemoveVectors | Interference::Alarm | Interference::Avoid => Ok(false),
        };
        judgement.block = reading;
        let removed = removed?;
        // [TRC-ARC-08] the own move of an arc at whose centre the tool stands has no length.
        let segment = if at_centre || removed {
            line_to(&junction.first)
        } else {
            own_move(&pending.element, &junction.first, whole_circle)
        };
        let clause = if removed { clause::TRC_INT_03 } else { junction.clause };
        if self.rows.compares() && pending.kind == PendingKind::Offset {
            self.push_to_row(pending, &junction, onward, (segment, whole_circle));
        } else {
            let Pending { block, rapid, lead_in, .. } = pending;
            self.corner_moves(lead_in.clause, lead_in.moves, block, rapid, judgement);
            self.emit(block, rapid, clause, true, segment, judgement);
        }
        Ok(junction)
    }

    /// [TRC-WEDGE-02], [TRC-WEDGE-03]
    fn looked_at(
        &mut self,
        pending: &mut Pending,
        end: &Vector,
        exempt: bool,
        judgement: &mut Judgement<'_>,
    ) -> Answer {
        let Pending { block, rapid, kind, ref element, ref mut lead_in, .. } = *pending;
        if kind == PendingKind::StartUp || (kind == PendingKind::Entry && !element.is_arc()) {
            return Ok(());
        }
        wedge::forward(element, &self.tool, end, exempt, &self.parameters, judgement).map_err(|kind| {
            // [TRC-MODE-10]
            if self.parameters.pending_at_alarm == PendingAtAlarm::Lost {
                let moves = core::mem::take(&mut lead_in.moves);
                self.corner_moves(lead_in.clause, moves, block, rapid, judgement);
            }
            Stop::Alarm(Alarm { block, kind })
        })
    }

    /// [TRC-INT-03] removes vectors at both ends of the block; answers whether it has.
    fn without_vectors(
        &self,
        pending: &mut Pending,
        junction: &mut Junction,
        onward: &Onward,
        judgement: &mut Judgement<'_>,
    ) -> Result<bool, Stop> {
        let starts = match &pending.lead_in.corner {
            Some(first) => vectors(first, &pending.lead_in.moves),
            None => vec![self.tool.clone()],
        };
        let ends = onward.vectors(junction);
        let boundary = self.parameters.interference_boundary;
        let left = interference::remove(&pending.element, &starts, &ends, boundary, judgement)
            .ok_or(Stop::Alarm(Alarm { block: pending.block, kind: AlarmKind::Interference }))?;
        if left.at_start < starts.len() {
            pending.lead_in.moves.truncate(left.at_start.saturating_sub(1));
        }
        if let Some(first) = ends.get(left.removed_at_end)
            && left.removed_at_end > 0
        {
            junction.first = first.clone();
            junction.moves.drain(..left.removed_at_end);
        }
        Ok(left.at_start < starts.len() || left.removed_at_end > 0)
    }

    /// The block waits for those behind it ([TRC-INT-04]).
    fn push_to_row(
        &mut self,
        pending: Pending,
        junction: &Junction,
        onward: &Onward,
        (segment, whole_circle): (Segment<Real>, bool),
    ) {
        let Pending { block, rapid, element, side, radius, fit, lead_in, .. } = pending;
        let step = |clause, main, segment| Step { block, clause, rapid, main, segment };
        let start = self.tool.clone();
        self.stand_at_end_of(&segment);
        self.rows.push(RowBlock {
            element,
            side,
            radius,
            fit,
            whole_circle,
            start,
            vectors: onward.vectors(junction),
            lead_in: lead_in.moves.into_iter().map(|segment| step(lead_in.clause, false, segment)).collect(),
            own: step(junction.clause, true, segment),
            behind: Vec::new(),
        });
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
