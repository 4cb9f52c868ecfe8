//! Look-ahead: `spec/clauses/07-look-ahead.md`.

use core::cmp::Ordering;

use radcomp_spec::{AdvisoryKind, DecisionKind, Side};

use super::junction::{Junction, line_to};
use crate::decision::Judgement;
use crate::element::{Element, Shape};
use crate::geometry::Vector;
use crate::number::Real;
use radcomp_spec::clause;

/// A junction that was settled without the element after it.
#[derive(Clone, Debug)]
pub(crate) enum Settled {
    /// Look-ahead was lost: the tool stands on this unit normal ([TRC-LOOK-03]).
    Lost { normal: Vector },
    /// A dummy block stood for the next element, with this unit direction ([TRC-DUMMY-02]).
    Dummy { direction: Vector },
    /// A code of the program gave the vector ([TRC-MODE-05], [TRC-VEC-02] to [TRC-VEC-06], [TRC-START-10]).
    ByCode,
}

/// Where the element after a settled junction starts: a line where the tool stands ([TRC-LOOK-04]), an arc on its own
/// normal, to which the tool moves straight ([TRC-LOOK-05]).
pub(crate) fn resume(
    tool: &Vector,
    next: &Element,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Junction {
    match next.shape {
        Shape::Line { .. } => Junction::single(clause::TRC_LOOK_04, tool.clone()),
        Shape::Arc { .. } => {
            let normal = next.first_arm().normal(side, radius);
            let line_in = normal.minus(tool);
            let moves = if line_in.is_zero() { Vec::new() } else { vec![line_to(&normal)] };
            let along = line_in.dot(&next.first_arm().unit());
            if judgement.decide(DecisionKind::LineInForward, &along, along.clone()) == Ordering::Less {
                judgement.advise(AdvisoryKind::LineInBackwards, line_in.length());
            }
            Junction { clause: clause::TRC_LOOK_05, first: tool.clone(), moves, approach: None }
        }
    }
}

/// The warnings of [TRC-LOOK-06] and [TRC-DUMMY-03]: r·(1 - cosine) between what the tool stands on and what the next
/// block would have asked for.
pub(crate) fn advise(settled: &Settled, next: &Element, side: Side, radius: &Real, judgement: &mut Judgement<'_>) {
    let unit = next.first_arm().unit();
    let (kind, cosine) = match settled {
        Settled::Lost { normal } => (AdvisoryKind::LostLookAhead, normal.dot(&unit.toward(side))),
        Settled::ByCode => return,
        Settled::Dummy { direction } => (AdvisoryKind::DummyMismatch, direction.dot(&unit)),
    };
    let amount = radius * &(Real::one() - cosine);
    if amount.sign() != Ordering::Equal {
        judgement.advise(kind, amount);
    }
}
