//! What a junction answers, and which rule it falls under.

use radcomp_spec::clause::Clause;
use radcomp_spec::parameters::Parameters;
use radcomp_spec::{AlarmKind, OuterCorner, Segment, Side};

use super::{corner, side_change};
use crate::decision::Judgement;
use crate::element::Element;
use crate::geometry::Vector;
use crate::number::Real;

/// The vectors of a junction, in the order in which the tool passes them.
#[derive(Clone, Debug)]
pub(crate) struct Junction {
    /// The rule that made it.
    pub(crate) clause: Clause,
    /// The vector that the element before ends on.
    pub(crate) first: Vector,
    /// The corner moves from there, none of zero length ([TRC-CORNER-12]).
    pub(crate) moves: Vec<Segment<Real>>,
    /// The straight move after them that the second block owns in any case ([TRC-SIDE-06]).
    pub(crate) approach: Option<Segment<Real>>,
}

/// Why a junction has no vectors.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Refused {
    /// An alarm at the second block.
    Alarm(AlarmKind),
    /// Decisions that no geometry satisfies.
    Contradiction,
}

/// What a junction depends on besides its two elements.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a> {
    pub(crate) parameters: &'a Parameters,
    pub(crate) radius: &'a Real,
    pub(crate) outer_corner: OuterCorner,
    /// The block that owns the corner moves runs at rapid rate.
    pub(crate) owner_rapid: bool,
}

impl Junction {
    /// A junction with one vector.
    pub(crate) fn single(clause: Clause, vector: Vector) -> Self {
        Junction { clause, first: vector, moves: Vec::new(), approach: None }
    }

    /// A junction whose vectors are joined by straight moves; moves of no length are not made ([TRC-CORNER-12]).
    pub(crate) fn through(clause: Clause, vectors: Vec<Vector>) -> Self {
        let mut vectors = vectors.into_iter();
        let first = vectors.next().unwrap_or_else(Vector::zero);
        let mut last = first.clone();
        let mut moves = Vec::new();
        for vector in vectors {
            if vector != last {
                moves.push(line_to(&vector));
                last = vector;
            }
        }
        Junction { clause, first, moves, approach: None }
    }
}

/// A straight move to a vector.
pub(crate) fn line_to(end: &Vector) -> Segment<Real> {
    Segment::Line { end: [end.a.clone(), end.b.clone()] }
}

/// The junction of two compensated elements.
pub(crate) fn between(
    before: &Element,
    side_before: Side,
    after: &Element,
    side_after: Side,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    if side_before == side_after {
        corner::corner(&before.last_arm(), &after.first_arm(), side_after, setting, judgement)
    } else {
        side_change::side_change(before, side_before, after, side_after, setting, judgement)
    }
}
