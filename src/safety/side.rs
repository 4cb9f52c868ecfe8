//! On which side of a wall a piece of path runs.

use radcomp_spec::Side;

use super::contour::{Corner, Front, Joint, Wall};
use super::distance::{farthest_from_point, point_to_piece};
use super::interval::{Spot, cross, dot, minus};
use super::piece::{Certainty, Hull, Piece, Shape, hull_in_sector};

/// Where a piece of path stands, as far as one wall can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Standing {
    /// No point of the piece has its nearest contour point on this wall.
    Elsewhere,
    /// Every point whose nearest contour point is on this wall is on the tool's side of it.
    Free,
    /// Every such point is in the material.
    Material,
    /// Some may be here and some there.
    Mixed,
}

impl Standing {
    /// What two walls, or two parts of one, say together.
    pub(crate) fn and(self, other: Standing) -> Standing {
        match (self, other) {
            (Standing::Elsewhere, standing) | (standing, Standing::Elsewhere) => standing,
            (Standing::Free, Standing::Free) => Standing::Free,
            (Standing::Material, Standing::Material) => Standing::Material,
            _ => Standing::Mixed,
        }
    }
}

/// Where a piece of path with its hull stands, no point of which is farther from the contour than `reach`.
pub(crate) fn standing(path: &Piece, hull: &Hull, wall: &Wall, reach: f64) -> Standing {
    let (inner, ends) = match &wall.piece.shape {
        Shape::Line => beside_line(hull, wall),
        Shape::Arc { centre, radius, rays } => {
            let seen = hull_in_sector(rays, centre, hull);
            let inside = farthest_from_point(path, hull, centre) < radius.low;
            let outside = point_to_piece(centre, path).low > radius.high;
            let inner = match (seen, wall.front) {
                (Certainty::No, _) => Standing::Elsewhere,
                (_, Front::Inside) if inside => Standing::Free,
                (_, Front::Inside) if outside => Standing::Material,
                (_, Front::Outside) if outside => Standing::Free,
                (_, Front::Outside) if inside => Standing::Material,
                _ => Standing::Mixed,
            };
            (inner, [seen != Certainty::Yes; 2])
        }
    };
    let mut standing = inner;
    for ((joint, end), may_be_nearest) in wall.joints.iter().zip([&wall.piece.a, &wall.piece.b]).zip(ends) {
        if may_be_nearest && point_to_piece(end, path).low <= reach {
            standing = standing.and(at_corner(joint, end, hull));
        }
    }
    standing
}

/// What the inside of a line says, and whether its ends may be nearest to a point.
fn beside_line(hull: &Hull, wall: &Wall) -> (Standing, [bool; 2]) {
    let (a, b) = (&wall.piece.a, &wall.piece.b);
    let w = minus(b, a);
    let (mut before, mut beyond, mut any_before, mut any_beyond) = (true, true, false, false);
    let (mut front, mut back) = (true, true);
    for point in hull.points() {
        let from_a = minus(point, a);
        let (along, rest) = (dot(&from_a, &w), dot(&minus(b, point), &w));
        before &= along.is_negative();
        beyond &= rest.is_negative();
        any_before |= along.low < 0.0;
        any_beyond |= rest.low < 0.0;
        let left = cross(&w, &from_a);
        let toward = if wall.front == Front::Left { left } else { -left };
        front &= toward.is_positive();
        back &= toward.is_negative();
    }
    let inner = match (before || beyond, front, back) {
        (true, ..) => Standing::Elsewhere,
        (_, true, _) => Standing::Free,
        (_, _, true) => Standing::Material,
        _ => Standing::Mixed,
    };
    (inner, [any_before, any_beyond])
}

/// What a corner says of the points of a hull that are nearest to it.
///
/// Such a point lies in the corner's normal cone: not before the corner along the element before it, and not after it
/// along the element behind it.
fn at_corner(joint: &Joint, corner: &Spot, hull: &Hull) -> Standing {
    match joint.corner {
        Corner::Open => return Standing::Free,
        Corner::Smooth => return Standing::Elsewhere,
        Corner::Outer | Corner::Inner | Corner::Unknown => {}
    }
    let [u1, u2] = &joint.tangents;
    let (mut before, mut after, mut in_front) = (true, true, true);
    for point in hull.points() {
        let v = minus(point, corner);
        before &= dot(&v, u1).is_negative();
        after &= dot(&v, u2).is_positive();
        let left = [cross(u1, &v), cross(u2, &v)];
        in_front &= match joint.side {
            Side::Left => left.iter().all(|left| left.is_positive()),
            Side::Right => left.iter().all(|left| left.is_negative()),
        };
    }
    if before || after {
        Standing::Elsewhere
    } else if joint.corner == Corner::Inner {
        Standing::Material
    } else if in_front || joint.corner == Corner::Outer {
        Standing::Free
    } else {
        Standing::Mixed
    }
}

/// Whether a piece lies wholly within a distance of a point.
pub(crate) fn is_about(path: &Piece, point: &Spot, reach: f64) -> bool {
    farthest_from_point(path, &path.hull(), point) <= reach
}
