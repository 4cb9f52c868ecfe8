//! Interference of vectors: `spec/clauses/13-interference.md`.

use core::cmp::Ordering;

use radcomp_spec::parameters::InterferenceBoundary;
use radcomp_spec::{DecisionKind, Side};

use super::corner::displacement;
use super::inner::{CircleCircle, LineCircle};
use super::junction::Refused;
use super::side_change::{nearer, two};
use super::wedge::arc_margin;
use crate::decision::Judgement;
use crate::element::{Arm, Element, Shape};
use crate::geometry::{Vector, signed};
use crate::number::Real;

/// The programmed end of a block, and a vector there.
pub(crate) type At<'a> = (&'a Vector, &'a Vector);

/// [TRC-INT-02] whether a vector interferes with a later one; `only` is the block between them if there is no other.
pub(crate) fn interfere(
    (from, vector): At<'_>,
    (to, later): At<'_>,
    only: Option<&Element>,
    boundary: InterferenceBoundary,
    judgement: &mut Judgement<'_>,
) -> bool {
    let way = to.minus(from);
    let answer = match only.map(|element| (element, &element.shape)) {
        Some((_, Shape::Arc { full: true, .. })) => return false,
        Some((_, Shape::Arc { centre, .. })) if centre == vector || centre == later => return false,
        Some((element, Shape::Arc { .. })) => {
            let (exact, margin) = arc_margin(element, vector, later);
            judgement.settle(DecisionKind::ArcInterference, exact, margin)
        }
        // A line that moves has a length.
        Some((_, Shape::Line { length, .. })) => forward(&way, length, &later.minus(vector), judgement),
        None => {
            let length = way.length();
            let apart = judgement.decide(DecisionKind::InterferenceApart, &way.length_squared(), length.clone());
            if apart != Ordering::Greater {
                return false;
            }
            forward(&way, &length, &later.minus(vector), judgement)
        }
    };
    answer == Ordering::Less || (answer == Ordering::Equal && boundary == InterferenceBoundary::Inclusive)
}

/// The sign of dot(D, D').
fn forward(way: &Vector, length: &Real, of_vectors: &Vector, judgement: &mut Judgement<'_>) -> Ordering {
    let dot = way.dot(of_vectors);
    let margin = dot.checked_div(length).unwrap_or_else(Real::zero);
    judgement.decide(DecisionKind::LineInterference, &dot, margin)
}

/// What [TRC-INT-03] leaves of the vectors at the two ends of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Left {
    /// How many of those at its start, counted from the first one.
    pub(crate) at_start: usize,
    /// How many of those at its end are removed, counted from the first one.
    pub(crate) removed_at_end: usize,
}

/// [TRC-INT-03] looks at one block by itself, whose vectors are given in the order in which the tool passes them; none
/// if the first and the last of them interfere.
pub(crate) fn remove(
    element: &Element,
    starts: &[Vector],
    ends: &[Vector],
    boundary: InterferenceBoundary,
    judgement: &mut Judgement<'_>,
) -> Option<Left> {
    let mut left = Left { at_start: starts.len(), removed_at_end: 0 };
    let (outermost, last) = (starts.len().max(ends.len()), ends.len().saturating_sub(1));
    for place in 0..outermost {
        // Where only the last one of a side is left, it stands in each further pair.
        let (at_start, at_end) = (starts.len().saturating_sub(place + 1), place.min(last));
        let (Some(vector), Some(later)) = (starts.get(at_start), ends.get(at_end)) else { break };
        if !interfere((&element.start, vector), (&element.end, later), Some(element), boundary, judgement) {
            break;
        }
        if (at_start, at_end) == (0, last) {
            return None;
        }
        left = Left { at_start: at_start.max(1), removed_at_end: (at_end + 1).min(last) };
    }
    Some(left)
}

/// [TRC-INT-05] the common point of the offset curves of two blocks between which others are left out, each a whole line
/// or circle; none where the path turns by more than 90°, and where no one point is the nearest to the end of the first
/// block.
pub(crate) fn avoidance(
    before: &Element,
    after: &Element,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Option<Vector>, Refused> {
    let (before, after) = (before.last_arm(), after.first_arm());
    let cosine = before.tangent.dot(&after.tangent);
    let margin = displacement(&cosine, &before, &after);
    if judgement.decide(DecisionKind::AvoidanceTurn, &cosine, margin) == Ordering::Less {
        return Ok(None);
    }
    let kind = DecisionKind::AvoidanceMeets;
    let points = match (&before.circle, &after.circle) {
        (None, None) => return lines_meet(&before, &after, side, radius, judgement),
        (None, Some(circle)) => {
            let crossing = LineCircle::new(&before, side, circle, side, radius);
            two(crossing.meet(kind, judgement), |which| Some(crossing.point(which)))?
        }
        (Some(circle), None) => {
            let crossing = LineCircle::new(&after, side, circle, side, radius);
            two(crossing.meet(kind, judgement), |which| Some(crossing.point(which)))?
        }
        (Some(first), Some(second)) => {
            let crossing = CircleCircle::new(first, side, second, side, radius);
            two(crossing.meet(kind, judgement), |which| crossing.point(which))?
        }
    };
    Ok(nearer(points, &before.point, DecisionKind::NearerAvoidance, judgement))
}

/// `A + u1·cross(B - A, u2) / cross(u1, u2)`, A and B being points of the two offset lines; none where they are parallel.
fn lines_meet(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Option<Vector>, Refused> {
    let cross = before.tangent.cross(&after.tangent);
    let toward = signed(side, &cross);
    let margin = displacement(&toward, before, after);
    if judgement.decide(DecisionKind::AvoidanceParallel, &toward, margin) == Ordering::Equal {
        return Ok(None);
    }
    let (first, second) = (before.normal(side, radius), after.normal(side, radius));
    let along = second.minus(&first).cross(&after.tangent).checked_div(&cross).ok_or(Refused::Contradiction)?;
    Ok(Some(first.along(&before.tangent, &along)))
}
