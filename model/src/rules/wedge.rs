//! Tool paths that run backwards: `spec/clauses/10-wedge.md`. The far intersection of [TRC-WEDGE-01] stands with the
//! inner corners, which make it.

use core::cmp::Ordering;

use radcomp_spec::parameters::{Parameters, ReversedPath};
use radcomp_spec::{AdvisoryKind, AlarmKind, DecisionKind};

use crate::decision::Judgement;
use crate::element::{Element, Shape};
use crate::geometry::{Vector, smaller};
use crate::number::{Real, within_bits};
use crate::sweep::{Sweep, differ_by_more_than_half_turn};

/// Looks at one compensated block when the centre's positions at its start and end are settled. An arc is exempt when
/// it is run as a full circle, and when the tool stands at its centre meanwhile ([TRC-ARC-08]).
pub(crate) fn forward(
    element: &Element,
    start: &Vector,
    end: &Vector,
    exempt: bool,
    parameters: &Parameters,
    judgement: &mut Judgement<'_>,
) -> Result<(), AlarmKind> {
    let (advisory, alarm, amount) = match &element.shape {
        Shape::Line { direction, length } => {
            // [TRC-WEDGE-02]
            let travel = end.minus(start).dot(direction);
            let margin = travel.checked_div(length).unwrap_or_else(Real::zero);
            if judgement.decide(DecisionKind::LineForward, &travel, margin.clone()) != Ordering::Less {
                return Ok(());
            }
            (AdvisoryKind::ReversedLine, AlarmKind::ReversedLine, margin.abs())
        }
        Shape::Arc { .. } if exempt => return Ok(()),
        Shape::Arc { .. } => {
            // [TRC-WEDGE-03]
            let (exact, margin) = arc_margin(element, start, end);
            if judgement.settle(DecisionKind::ArcForward, exact, margin) != Ordering::Less {
                return Ok(());
            }
            (AdvisoryKind::ReversedArc, AlarmKind::ReversedArc, end.minus(start).length())
        }
    };
    match parameters.reversed_path {
        ReversedPath::Alarm => Err(alarm),
        ReversedPath::Advisory => {
            judgement.advise(advisory, amount);
            Ok(())
        }
    }
}

/// The exact answer for an arc, and how far its nearest boundary lies: where the tool's start and end are one point,
/// where the two sweeps differ by exactly a half turn, or where the programmed end reaches the ray of the start, behind
/// which a sweep of nothing is one of a whole turn. The last is as long as the first for a tool without a radius, and of two
/// lengths that agree to [`ALIKE`] bits the first is told.
pub(super) fn arc_margin(element: &Element, start: &Vector, end: &Vector) -> (Ordering, Real) {
    let Shape::Arc { centre, sense, full, entry, .. } = &element.shape else {
        return (Ordering::Greater, Real::zero());
    };
    // [TRC-START-09] the tool's sweep is measured about the moved centre. [TRC-SIDE-08] T is less than a full turn.
    let tool_centre = entry.as_deref().map_or(centre, |entry| &entry.centre);
    let (from, to) = (start.minus(tool_centre), end.minus(tool_centre));
    let tool = Sweep::between(&from, &to, *sense);
    let to_end = element.end.minus(centre);
    let programmed = Sweep::between(&element.start.minus(centre), &to_end, *sense);
    let backwards = differ_by_more_than_half_turn(&tool, &programmed, *full);

    let reach = from.length();
    let g = &programmed.relative;
    let difference = Vector::new(tool.relative.dot(g), g.cross(&tool.relative)).opposite();
    let margin = smaller(off_axis(&tool.relative, &reach), off_axis(&difference, &reach));
    // The end of a full circle is its start, however the numbers are rounded.
    let margin = if *full { margin } else { smaller_or_alike(margin, off_axis(g, &to_end.length())) };
    if margin.is_zero() {
        (if backwards { Ordering::Less } else { Ordering::Equal }, margin)
    } else if backwards {
        (Ordering::Less, -margin)
    } else {
        (Ordering::Greater, margin)
    }
}

/// Lengths that differ by less than 2 to the minus this are told as one: that they are equal takes exact numbers seconds.
const ALIKE: i64 = 4096;

/// The smaller of two numbers, or the first of two that are alike.
fn smaller_or_alike(x: Real, y: Real) -> Real {
    if within_bits(ALIKE, || y.cmp(&x)) == Some(Ordering::Less) { y } else { x }
}

/// The distance of a direction from the positive first axis at radius `reach`; at most `reach`.
fn off_axis(direction: &Vector, reach: &Real) -> Real {
    if direction.a.sign() != Ordering::Greater {
        return reach.clone();
    }
    let sine = direction.b.abs().checked_div(&direction.length()).unwrap_or_else(Real::zero);
    &sine * reach
}

#[cfg(test)]
mod tests {
    use radcomp_spec::Direction;
    use radcomp_spec::profile::Profile;

    use super::*;
    use crate::decision::Sink;
    use crate::element::EntryArc;

    struct Silent;

    impl Sink for Silent {}

    fn point(a: (i64, i64), b: (i64, i64)) -> Vector {
        Vector::new(Real::rational(a.into()), Real::rational(b.into()))
    }

    /// An entry from (-14/5, -2/5) to (0, 1) about (0, -5/2), for an arc about (0, -10). From there to (0, -6) the tool
    /// sweeps 233° about the moved centre, but no more than the program, 16°, about the programmed one.
    #[test]
    fn an_entry_sweeps_about_its_moved_centre() {
        let (start, end) = (point((-14, 5), (-2, 5)), point((0, 1), (0, 1)));
        let radius = Real::integer(10);
        let entry = EntryArc {
            start: start.clone(),
            centre: point((0, 1), (-5, 2)),
            radius: Real::rational((7, 2).into()),
            end: point((0, 1), (1, 1)),
        };
        let shape = Shape::Arc {
            centre: point((0, 1), (-10, 1)),
            sense: Direction::Clockwise,
            start_radius: radius.clone(),
            end_radius: radius,
            full: false,
            entry: Some(Box::new(entry)),
        };
        let element = Element { start: start.clone(), end, shape };
        let mut parameters = Profile::builtin("seed-mill").unwrap().parameters;
        parameters.reversed_path = ReversedPath::Alarm;
        let judgement = &mut Judgement { sink: &mut Silent, block: 0 };
        let mut looked_at = |to: Vector| forward(&element, &start, &to, false, &parameters, judgement);
        assert_eq!(looked_at(point((0, 1), (-6, 1))), Err(AlarmKind::ReversedArc));
        assert_eq!(looked_at(point((0, 1), (1, 1))), Ok(()));
    }
}
