//! Change of side in offset mode: `spec/clauses/05-side.md`.

use core::cmp::Ordering;

use radcomp_spec::clause;
use radcomp_spec::parameters::{Parameters, SideChange, SideChangeAfterStartUp};
use radcomp_spec::{AlarmKind, DecisionKind, Side};

use super::inner::{CircleCircle, LineCircle};
use super::junction::{Junction, Refused, Setting, line_to};
use crate::decision::Judgement;
use crate::element::{Arm, Element, Shape};
use crate::geometry::{Vector, larger, signed, smaller};
use crate::number::Real;
use crate::sweep::Sweep;

/// Whether an element may have its side: [TRC-SIDE-01], [TRC-SIDE-04].
///
/// `start_up` is the side of the start-up block when this is the first element after it, `before` the side of the
/// element before.
pub(crate) fn permitted(
    parameters: &Parameters,
    side: Side,
    before: Option<Side>,
    start_up: Option<Side>,
) -> Result<(), AlarmKind> {
    if before.is_some_and(|before| before != side) && parameters.side_change == SideChange::Forbidden {
        return Err(AlarmKind::SideChangeForbidden);
    }
    if start_up.is_some_and(|start_up| start_up != side)
        && parameters.side_change_after_start_up == SideChangeAfterStartUp::Alarm
    {
        return Err(AlarmKind::SideChangeAfterStartUp);
    }
    Ok(())
}

/// The junction at which the side changes.
pub(crate) fn side_change(
    before: &Element,
    side_before: Side,
    after: &Element,
    side_after: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    let (arm_before, arm_after) = (before.last_arm(), after.first_arm());
    let (normal_before, normal_after) =
        (arm_before.normal(side_before, setting.radius), arm_after.normal(side_after, setting.radius));
    let (clause, everywhere) = match setting.parameters.side_change {
        SideChange::IntersectionWithin => (clause::TRC_SIDE_02, false),
        // [TRC-SIDE-05] wherever the contact lies.
        SideChange::Intersection => (clause::TRC_SIDE_05, true),
        SideChange::Crossing => return Ok(crossing(normal_before, &normal_after, after)),
        SideChange::TwoNormals | SideChange::Forbidden => return Ok(two_normals(normal_before, normal_after)),
    };
    let mut counting = Vec::with_capacity(2);
    for point in contacts(&arm_before, side_before, &arm_after, side_after, setting.radius, judgement)? {
        if everywhere
            || (within(&point, before, side_before, setting.radius, judgement)
                && within(&point, after, side_after, setting.radius, judgement))
        {
            counting.push(point);
        }
    }
    Ok(match nearer(counting, &arm_before.point, DecisionKind::NearerContact, judgement) {
        Some(point) => Junction::single(clause, point),
        None => two_normals(normal_before, normal_after),
    })
}

/// [TRC-SIDE-03] the two normals, joined by a straight line.
fn two_normals(before: Vector, after: Vector) -> Junction {
    Junction::through(clause::TRC_SIDE_03, vec![before, after])
}

/// [TRC-SIDE-06] the old normal alone; an arc is approached from there.
fn crossing(normal_before: Vector, normal_after: &Vector, after: &Element) -> Junction {
    let approaches = after.is_arc() && normal_before != *normal_after;
    let approach = approaches.then(|| line_to(normal_after));
    Junction { clause: clause::TRC_SIDE_06, first: normal_before, moves: Vec::new(), approach }
}

/// The points where the tool touches both contours, each on its own side ([TRC-SIDE-02]): at most two.
fn contacts(
    before: &Arm,
    side_before: Side,
    after: &Arm,
    side_after: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Vec<Vector>, Refused> {
    let kind = DecisionKind::ContactExists;
    Ok(match (&before.circle, &after.circle) {
        (None, None) => line_line(before, side_before, after, radius, judgement)?,
        (None, Some(circle)) => {
            let crossing = LineCircle::new(before, side_before, circle, side_after, radius);
            two(crossing.meet(kind, judgement), |which| Some(crossing.point(which)))?
        }
        (Some(circle), None) => {
            let crossing = LineCircle::new(after, side_after, circle, side_before, radius);
            two(crossing.meet(kind, judgement), |which| Some(crossing.point(which)))?
        }
        (Some(first), Some(second)) => {
            let crossing = CircleCircle::new(first, side_before, second, side_after, radius);
            two(crossing.meet(kind, judgement), |which| crossing.point(which))?
        }
    })
}

/// Two points when curves cross, one when they touch.
pub(super) fn two(meet: Ordering, point: impl Fn(bool) -> Option<Vector>) -> Result<Vec<Vector>, Refused> {
    let one = |which| point(which).ok_or(Refused::Contradiction);
    Ok(match meet {
        Ordering::Less => Vec::new(),
        Ordering::Equal => vec![one(false)?],
        Ordering::Greater => vec![one(false)?, one(true)?],
    })
}

/// `P + σ1·r·(u1 + u2) / cross(u1, u2)`: at distance r from both lines, left of one and right of the other.
fn line_line(
    before: &Arm,
    side_before: Side,
    after: &Arm,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Vec<Vector>, Refused> {
    let cross = before.tangent.cross(&after.tangent);
    let margin = cross.checked_div(&larger(&before.length, &after.length)).unwrap_or_else(Real::zero);
    let signed_margin = signed(side_before, &margin);
    if judgement.decide(DecisionKind::Turn, &signed(side_before, &cross), signed_margin) == Ordering::Equal {
        return Ok(Vec::new());
    }
    let sum = before.tangent.times(&after.length).plus(&after.tangent.times(&before.length));
    let factor = signed(side_before, radius).checked_div(&cross).ok_or(Refused::Contradiction)?;
    Ok(vec![before.point.along(&sum, &factor)])
}

/// Whether the point lies no farther than r from the untrimmed offset element, measured on its offset curve's line or
/// from its nearer end.
fn within(point: &Vector, element: &Element, side: Side, radius: &Real, judgement: &mut Judgement<'_>) -> bool {
    let margin = match &element.shape {
        Shape::Line { length, .. } => {
            // How far the point lies beyond the start and beyond the end, along the line.
            let along = element.first_arm().unit().dot(&point.minus(&element.start));
            smaller(&along + radius, &(length + radius) - &along)
        }
        Shape::Arc { centre, sense, full, entry, .. } => {
            let inside = {
                let (centre, start, end) = match entry.as_deref() {
                    Some(entry) => (&entry.centre, &entry.start, &entry.end),
                    None => (centre, &element.start, &element.end),
                };
                let programmed = Sweep::between(&start.minus(centre), &end.minus(centre), *sense);
                let here = Sweep::between(&start.minus(centre), &point.minus(centre), *sense);
                let whole = *full && entry.is_none();
                whole || programmed.is_none() || here.compare(&programmed) != Ordering::Greater
            };
            if inside {
                radius.clone()
            } else {
                let from_end = |normal: &Vector| normal.minus(point).length();
                let from_start = match entry.as_deref() {
                    Some(entry) => from_end(&entry.start),
                    None => from_end(&element.first_arm().normal(side, radius)),
                };
                radius - &smaller(from_start, from_end(&element.last_arm().normal(side, radius)))
            }
        }
    };
    let margin = smaller(margin, radius.clone());
    judgement.decide(DecisionKind::ContactWithin, &margin, margin.clone()) != Ordering::Less
}

/// The one nearer to P; of two equally near ones, none ([TRC-SIDE-02], [TRC-INT-05]).
pub(super) fn nearer(
    mut points: Vec<Vector>,
    corner: &Vector,
    kind: DecisionKind,
    judgement: &mut Judgement<'_>,
) -> Option<Vector> {
    let second = points.pop()?;
    let Some(first) = points.pop() else { return Some(second) };
    let (to_first, to_second) = (first.minus(corner), second.minus(corner));
    let margin = to_second.length() - to_first.length();
    match judgement.decide(kind, &margin, margin.clone()) {
        Ordering::Greater => Some(first),
        Ordering::Less => Some(second),
        Ordering::Equal => None,
    }
}
