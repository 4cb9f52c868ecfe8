//! Outer corners: [TRC-CORNER-06] to [TRC-CORNER-10], [TRC-CORNER-13], [TRC-CORNER-14], [TRC-CORNER-17] and
//! [TRC-CORNER-18].

use core::cmp::Ordering;

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::{ArcExtension, ArcOnRapid};
use radcomp_spec::{DecisionKind, Direction, OuterCorner, Segment, Side};

use super::corner::{mitre, not_below, right_angle};
use super::inner::{Turning, common_point};
use super::junction::{Junction, Refused, Setting, line_to};
use super::mode;
use crate::decision::Judgement;
use crate::element::Arm;
use crate::geometry::{Vector, larger};
use crate::number::Real;

/// How an outer corner is passed.
pub(crate) enum Outer {
    /// In straight lines through these vectors.
    Intersection { clause: Clause, vectors: Vec<Vector> },
    /// From the first vector in one move, an arc or its chord.
    Arc { clause: Clause, first: Vector, moves: Vec<Segment<Real>> },
}

impl Outer {
    /// The junction of offset mode.
    pub(crate) fn junction(self) -> Junction {
        match self {
            Outer::Intersection { clause, vectors } => Junction::through(clause, vectors),
            Outer::Arc { clause, first, moves } => Junction { clause, first, moves, approach: None },
        }
    }

    /// The junction of type B, with a normal put before or behind the vectors ([TRC-START-06], [TRC-CANCEL-05]). A
    /// corner by an arc starts and ends on the normals as it is.
    pub(crate) fn junction_of_type_b(self, clause: Clause, before: Option<Vector>, behind: Option<Vector>) -> Junction {
        match self {
            Outer::Intersection { vectors, .. } => {
                Junction::through(clause, before.into_iter().chain(vectors).chain(behind).collect())
            }
            Outer::Arc { first, moves, .. } => Junction { clause, first, moves, approach: None },
        }
    }

    /// [TRC-CORNER-18]
    pub(crate) fn without_small_vectors(
        self,
        second_is_arc: bool,
        setting: Setting<'_>,
        judgement: &mut Judgement<'_>,
    ) -> Outer {
        let limit = setting.parameters.small_vector_limit;
        match self {
            Outer::Intersection { clause, vectors } if limit.numerator > 0 => {
                let limit = mode::ratio(limit);
                let last = vectors.len().saturating_sub(1);
                let mut kept: Vec<Vector> = Vec::with_capacity(vectors.len());
                for (place, vector) in vectors.into_iter().enumerate() {
                    let normal_of_arc = second_is_arc && place == last;
                    let small = kept
                        .last()
                        .is_some_and(|before| !normal_of_arc && is_small(&vector.minus(before), &limit, judgement));
                    if !small {
                        kept.push(vector);
                    }
                }
                Outer::Intersection { clause, vectors: kept }
            }
            other => other,
        }
    }
}

/// Whether two vectors differ by at most the limit in each coordinate.
fn is_small(difference: &Vector, limit: &Real, judgement: &mut Judgement<'_>) -> bool {
    let margin = larger(&difference.a.abs(), &difference.b.abs()) - limit;
    judgement.decide(DecisionKind::SmallVector, &margin, margin.clone()) != Ordering::Greater
}

/// An outer corner of two arms.
pub(crate) fn outer(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    reversal: bool,
    judgement: &mut Judgement<'_>,
) -> Result<Outer, Refused> {
    let limit = setting.parameters.corner_limit_cosine;
    let by_arc = match setting.outer_corner {
        OuterCorner::Arc => true,
        OuterCorner::Intersection => false,
        // [TRC-CORNER-13]
        OuterCorner::LimitAngle => {
            reversal || not_below(before, after, limit, DecisionKind::LimitAngle, judgement) == Ordering::Less
        }
    };
    if by_arc {
        return Ok(arc_corner(before, after, side, setting));
    }
    let with_arc = before.circle.is_some() || after.circle.is_some();
    if with_arc && setting.parameters.arc_extension == ArcExtension::Curve {
        // [TRC-CORNER-14]
        let vector = common_point(before, after, side, setting.radius, Turning::Away, judgement)?;
        return Ok(Outer::Intersection { clause: clause::TRC_CORNER_14, vectors: vec![vector] });
    }
    by_intersection(before, after, side, setting, reversal, judgement)
}

/// [TRC-CORNER-06] obtuse, [TRC-CORNER-08] acute, [TRC-CORNER-13] acute but not squared off, [TRC-CORNER-07] with the
/// normals of arcs.
fn by_intersection(
    before: &Arm,
    after: &Arm,
    side: Side,
    setting: Setting<'_>,
    reversal: bool,
    judgement: &mut Judgement<'_>,
) -> Result<Outer, Refused> {
    let radius = setting.radius;
    let may_square_off = setting.outer_corner != OuterCorner::LimitAngle;
    let squared_off = may_square_off && (reversal || right_angle(before, after, judgement) == Ordering::Less);
    let (arc_before, arc_after) = (before.circle.is_some(), after.circle.is_some());
    let mut vectors = Vec::with_capacity(4);
    if arc_before {
        vectors.push(before.normal(side, radius));
    }
    if squared_off {
        vectors.push(before.normal(side, radius).plus(&before.advance(radius)));
        vectors.push(after.normal(side, radius).minus(&after.advance(radius)));
    } else {
        vectors.push(mitre(before, after, side, radius).ok_or(Refused::Contradiction)?);
    }
    if arc_after {
        vectors.push(after.normal(side, radius));
    }
    let clause = if reversal {
        clause::TRC_CORNER_09
    } else if squared_off {
        clause::TRC_CORNER_08
    } else if !may_square_off && before.tangent.dot(&after.tangent).sign() == Ordering::Less {
        // The clause alone depends on this sign, not the path.
        clause::TRC_CORNER_13
    } else if arc_before || arc_after {
        clause::TRC_CORNER_07
    } else {
        clause::TRC_CORNER_06
    };
    Ok(Outer::Intersection { clause, vectors })
}

/// [TRC-CORNER-10], and the chord of [TRC-CORNER-17].
fn arc_corner(before: &Arm, after: &Arm, side: Side, setting: Setting<'_>) -> Outer {
    let (first, last) = (before.normal(side, setting.radius), after.normal(side, setting.radius));
    let chord = setting.owner_rapid && setting.parameters.arc_on_rapid == ArcOnRapid::Line;
    let clause = if chord { clause::TRC_CORNER_17 } else { clause::TRC_CORNER_10 };
    let moves = if first == last {
        Vec::new()
    } else if chord {
        vec![line_to(&last)]
    } else {
        let direction = match side {
            Side::Left => Direction::Clockwise,
            Side::Right => Direction::Counterclockwise,
        };
        vec![Segment::Arc {
            end: [last.a.clone(), last.b.clone()],
            centre: [before.point.a.clone(), before.point.b.clone()],
            direction,
            full: false,
        }]
    };
    Outer::Arc { clause, first, moves }
}
