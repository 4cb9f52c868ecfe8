//! Inner corners, and the common points of offset curves: [TRC-CORNER-03], [TRC-CORNER-04], [TRC-CORNER-05].

use core::cmp::Ordering;

use radcomp_spec::clause;
use radcomp_spec::{AlarmKind, DecisionKind, Direction, Side};

use super::corner::mitre;
use super::junction::{Junction, Refused};
use crate::decision::Judgement;
use crate::element::{Arm, Circle};
use crate::geometry::{Vector, signed, smaller};
use crate::number::Real;

/// The vector of an inner corner.
pub(crate) fn inner(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    if before.circle.is_none() && after.circle.is_none() {
        let vector = mitre(before, after, side, radius).ok_or(Refused::Contradiction)?;
        return Ok(Junction::single(clause::TRC_CORNER_03, vector));
    }
    let vector = common_point(before, after, side, radius, Turning::Toward, judgement)?;
    Ok(Junction::single(clause::TRC_CORNER_04, vector))
}

/// Which of the common points of two offset curves: the one at which the path turns to the tool's side
/// ([TRC-CORNER-04]), or away from it ([TRC-CORNER-14]).
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Turning {
    /// σ·cross(t1, t2) > 0.
    Toward,
    /// σ·cross(t1, t2) < 0.
    Away,
}

impl Turning {
    fn sign(self) -> i8 {
        match self {
            Turning::Toward => 1,
            Turning::Away => -1,
        }
    }

    fn decision(self) -> DecisionKind {
        match self {
            Turning::Toward => DecisionKind::OffsetsMeet,
            Turning::Away => DecisionKind::ExtensionsMeet,
        }
    }
}

/// The common point of two offset curves, of which one at least is a circle. Curves that touch meet; those that do not
/// raise the alarm of [TRC-CORNER-05].
pub(crate) fn common_point(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    turning: Turning,
    judgement: &mut Judgement<'_>,
) -> Result<Vector, Refused> {
    let point = common_point_if_any(before, after, side, radius, (turning, turning.decision()), judgement)?;
    point.ok_or(Refused::Alarm(AlarmKind::NoIntersection))
}

/// The same, with the decision that asks whether the curves meet; none if they do not.
pub(crate) fn common_point_if_any(
    before: &Arm,
    after: &Arm,
    side: Side,
    radius: &Real,
    (turning, decision): (Turning, DecisionKind),
    judgement: &mut Judgement<'_>,
) -> Result<Option<Vector>, Refused> {
    let sign = turning.sign() * side_sign(side);
    match (&before.circle, &after.circle) {
        (None, None) => Err(Refused::Contradiction),
        (None, Some(circle)) => {
            let crossing = LineCircle::new(before, side, circle, side, radius);
            if crossing.meet(decision, judgement) == Ordering::Less {
                return Ok(None);
            }
            // F + σ·δ·√(R'² - h²)·u1, and the other point when the path turns away.
            Ok(Some(crossing.point(sign * sense_sign(circle.sense) > 0)))
        }
        (Some(circle), None) => {
            let crossing = LineCircle::new(after, side, circle, side, radius);
            if crossing.meet(decision, judgement) == Ordering::Less {
                return Ok(None);
            }
            // F - σ·δ·√(R'² - h²)·u2, and the other point when the path turns away.
            Ok(Some(crossing.point(sign * sense_sign(circle.sense) < 0)))
        }
        (Some(first), Some(second)) => {
            let crossing = CircleCircle::new(first, side, second, side, radius);
            if crossing.meet(decision, judgement) == Ordering::Less {
                return Ok(None);
            }
            // C1 + a·e + σ·δ1·δ2·√(R1'² - a²)·perp(e), and the other point when the path turns away.
            let left = sign * sense_sign(first.sense) * sense_sign(second.sense) > 0;
            crossing.point(left).map(Some).ok_or(Refused::Contradiction)
        }
    }
}

fn side_sign(side: Side) -> i8 {
    match side {
        Side::Left => 1,
        Side::Right => -1,
    }
}

fn sense_sign(sense: Direction) -> i8 {
    match sense {
        Direction::Counterclockwise => 1,
        Direction::Clockwise => -1,
    }
}

/// The common points of an offset line and an offset circle.
pub(crate) struct LineCircle {
    foot: Vector,
    unit: Vector,
    /// `R'² - h²`.
    discriminant: Real,
    /// `R' - |h|`.
    overlap: Real,
}

impl LineCircle {
    pub(crate) fn new(line: &Arm, line_side: Side, circle: &Circle, circle_side: Side, radius: &Real) -> Self {
        let unit = line.unit();
        // The distance of the centre from the offset line, positive to the left of it.
        let distance = unit.cross(&circle.centre.minus(&line.point)) - signed(line_side, radius);
        let offset_radius = circle.offset_radius(circle_side, radius);
        LineCircle {
            foot: circle.centre.along(&unit.perp(), &-&distance),
            discriminant: offset_radius.square() - distance.square(),
            overlap: &offset_radius - &distance.abs(),
            unit,
        }
    }

    pub(crate) fn meet(&self, kind: DecisionKind, judgement: &mut Judgement<'_>) -> Ordering {
        judgement.decide(kind, &self.discriminant, self.overlap.clone())
    }

    /// The point before the foot of the perpendicular, or the one after it.
    pub(crate) fn point(&self, forward: bool) -> Vector {
        let half_chord = self.discriminant.sqrt_or_zero();
        let along = if forward { half_chord } else { -half_chord };
        self.foot.along(&self.unit, &along)
    }
}

/// The common points of two offset circles.
pub(crate) struct CircleCircle {
    first_centre: Vector,
    /// From the first centre to the second.
    axis: Vector,
    distance_squared: Real,
    first_squared: Real,
    second_squared: Real,
    /// `min(R1' + R2' - D, D - |R1' - R2'|)`.
    overlap: Real,
}

impl CircleCircle {
    pub(crate) fn new(first: &Circle, first_side: Side, second: &Circle, second_side: Side, radius: &Real) -> Self {
        let (r1, r2) = (first.offset_radius(first_side, radius), second.offset_radius(second_side, radius));
        let axis = second.centre.minus(&first.centre);
        let distance = axis.length();
        CircleCircle {
            first_centre: first.centre.clone(),
            distance_squared: axis.length_squared(),
            first_squared: r1.square(),
            second_squared: r2.square(),
            overlap: smaller(&(&r1 + &r2) - &distance, &distance - &(&r1 - &r2).abs()),
            axis,
        }
    }

    /// Whether the circles meet; concentric circles do not.
    pub(crate) fn meet(&self, kind: DecisionKind, judgement: &mut Judgement<'_>) -> Ordering {
        let apart = judgement.decide(DecisionKind::CentresApart, &self.distance_squared, self.axis.length());
        if apart != Ordering::Greater {
            return Ordering::Less;
        }
        judgement.decide(kind, &self.overlap, self.overlap.clone())
    }

    /// The point left of the axis from the first centre to the second, or the one right of it. None when the centres
    /// are one point.
    pub(crate) fn point(&self, left: bool) -> Option<Vector> {
        // a / D, and the distance from the axis / D.
        let sum = &self.first_squared - &self.second_squared + &self.distance_squared;
        let along = sum.checked_div(&(&self.distance_squared * &Real::integer(2)))?;
        let off = (self.first_squared.checked_div(&self.distance_squared)? - along.square()).sqrt_or_zero();
        let off = if left { off } else { -off };
        Some(self.first_centre.along(&self.axis, &along).along(&self.axis.perp(), &off))
    }
}
