//! Which decisions a profile asks, as far as plain decimals lie on them.

use radcomp_spec::DecisionKind;
use radcomp_spec::parameters::{ArcExtension, Cancel, OuterCorner, Ratio, SideChange, StartUp, ZeroLengthMove};

use super::point::{Point, ratio};
use crate::generate::Reach;

/// Whether programs of whole thousandths of a millimetre lie exactly on a decision, under what a profile asks.
pub fn is_asked(kind: DecisionKind, reach: Reach) -> bool {
    let parameters = reach.parameters();
    let by_intersection = parameters.outer_corner == OuterCorner::Intersection;
    match kind {
        DecisionKind::Moves
        | DecisionKind::WholeTurn
        | DecisionKind::ToolFitsArc
        | DecisionKind::Turn
        | DecisionKind::OffsetsMeet
        | DecisionKind::LineForward
        | DecisionKind::ArcForward => true,
        // A distance of points in whole thousandths is a whole number of thousandths or irrational.
        DecisionKind::CentreDistance => thousandths(parameters.centre_tolerance).is_some(),
        DecisionKind::ChordFits => thousandths(parameters.chord_tolerance).is_some(),
        DecisionKind::HalfTurn => parameters.chord_tolerance.numerator > 0,
        // Two radii of points in whole thousandths differ by a fraction of one only if they are irrational, and then by no
        // rational number.
        DecisionKind::EndOnArc => thousandths(parameters.arc_end_tolerance).is_some(),
        DecisionKind::RightAngle => by_intersection,
        DecisionKind::CentresApart | DecisionKind::ContactExists | DecisionKind::NearerContact => asks_contacts(reach),
        DecisionKind::ContactWithin => parameters.side_change == SideChange::IntersectionWithin,
        DecisionKind::EntryLength => parameters.start_up == StartUp::EntryNormal || reach.starts_on_arcs(),
        DecisionKind::EntryArc => reach.starts_on_arcs(),
        DecisionKind::ImaginaryLineMet => reach.vectors_at_cancel(),
        DecisionKind::SmallestCorner => {
            let type_b = parameters.start_up == StartUp::TypeB || parameters.cancel == Cancel::TypeB;
            type_b && angle(parameters.smallest_corner_cosine).is_some()
        }
        DecisionKind::LimitAngle => {
            let limit = parameters.outer_corner == OuterCorner::LimitAngle;
            limit && (parameters.corner_limit_cosine.numerator == 0 || angle(parameters.corner_limit_cosine).is_some())
        }
        DecisionKind::ExtensionsMeet => parameters.arc_extension == ArcExtension::Curve && by_intersection,
        DecisionKind::StraightBand => angle(parameters.straight_band_cosine).is_some(),
        DecisionKind::SmallVector => {
            by_intersection && thousandths(parameters.small_vector_limit).is_some_and(|l| l > 0)
        }
        // Where any number of blocks without movement is allowed, only these break the look-ahead.
        DecisionKind::LineInForward => can_lose_look_ahead(reach) || reach.dummies(),
        DecisionKind::NearCorner => parameters.far_intersection == Ratio { numerator: 5, denominator: 1 },
    }
}

/// Changes of side look for a point that touches both contours ([TRC-SIDE-02], [TRC-SIDE-05]).
pub(super) fn asks_contacts(reach: Reach) -> bool {
    matches!(reach.parameters().side_change, SideChange::IntersectionWithin | SideChange::Intersection)
}

/// Something loses the look-ahead.
pub(super) fn can_lose_look_ahead(reach: Reach) -> bool {
    let zero_length = reach.parameters().zero_length_move == ZeroLengthMove::BreaksLookAhead;
    reach.non_moving_allowed().is_some() || reach.stops() || zero_length
}

/// A limit in whole thousandths of a millimetre, if it is one.
pub(super) fn thousandths(limit: Ratio) -> Option<i64> {
    let over = i64::from(limit.numerator) * 1000;
    let under = i64::from(limit.denominator);
    (over % under == 0).then(|| over / under)
}

/// The unit vector at the angle whose cosine is L, if L is not 0 and there are decimal vectors at that angle: the angle
/// between two of them has a rational tangent, √(1 - L²) / L, so 1 - L² has to be the square of a rational number.
pub(super) fn angle(cosine: Ratio) -> Option<Point> {
    let (over, under) = (i64::from(cosine.numerator), i64::from(cosine.denominator));
    let square = under * under - over * over;
    let root = u64::try_from(square).ok()?.isqrt() as i64;
    (over > 0 && root > 0 && root * root == square).then(|| Point::new(ratio(over, under), ratio(root, under)))
}
