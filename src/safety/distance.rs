//! Distances in closed form, rounded outward: of a point and a piece, and of two pieces.

use super::interval::{Interval, Spot, cross, distance, dot, length, middle, minus, plus, spot, times};
use super::piece::{Certainty, Hull, Piece, Shape, hull_in_sector, in_sector};

/// The distance of a point from a piece.
pub(crate) fn point_to_piece(q: &Spot, piece: &Piece) -> Interval {
    let to_a = minus(q, &piece.a);
    let ends = length(&to_a).min(distance(q, &piece.b));
    match &piece.shape {
        Shape::Line => {
            let w = minus(&piece.b, &piece.a);
            let squared = dot(&w, &w);
            if !squared.is_positive() {
                let low = ends.low - squared.root().high;
                return Interval::between(low.next_down().max(0.0), ends.high);
            }
            let along = dot(&to_a, &w);
            let rest = squared - along;
            if along.is_negative() {
                return length(&to_a);
            }
            if rest.is_negative() {
                return distance(q, &piece.b);
            }
            let off = cross(&w, &to_a).abs().over(squared.root());
            if along.low >= 0.0 && rest.low >= 0.0 { off } else { Interval::between(off.low, ends.high) }
        }
        Shape::Arc { centre, radius, rays } => {
            let from_centre = minus(q, centre);
            let off = (length(&from_centre) - *radius).abs();
            match in_sector(rays, &from_centre) {
                Certainty::Yes => off,
                Certainty::No => ends,
                Certainty::Maybe => Interval::between(off.low, ends.high),
            }
        }
    }
}

/// The point of a piece nearest to another point, to within rounding.
pub(crate) fn nearest_on(piece: &Piece, q: [f64; 2]) -> [f64; 2] {
    let (a, b) = (middle(&piece.a), middle(&piece.b));
    let apart = |p: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
    let end = if apart(a) <= apart(b) { a } else { b };
    match &piece.shape {
        Shape::Line => {
            let w = [b[0] - a[0], b[1] - a[1]];
            let along = ((q[0] - a[0]) * w[0] + (q[1] - a[1]) * w[1]) / (w[0] * w[0] + w[1] * w[1]);
            if along > 0.0 && along < 1.0 { [a[0] + along * w[0], a[1] + along * w[1]] } else { end }
        }
        Shape::Arc { centre, radius, rays } => {
            let c = middle(centre);
            let v = [q[0] - c[0], q[1] - c[1]];
            let factor = radius.middle() / v[0].hypot(v[1]);
            match in_sector(rays, &spot(v)) {
                Certainty::Yes if factor.is_finite() => [c[0] + v[0] * factor, c[1] + v[1] * factor],
                _ => end,
            }
        }
    }
}

/// The least distance of two pieces: a proved lower bound, and about where on the first piece it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// The pieces are nowhere nearer to each other.
    pub(crate) low: f64,
    /// A point of the first piece, to within rounding, that is as near as any.
    pub(crate) at: [f64; 2],
}

impl Gap {
    fn offer(&mut self, low: f64, at: [f64; 2]) {
        if low < self.low {
            *self = Gap { low: low.max(0.0), at };
        }
    }
}

/// The least distance of two pieces.
///
/// It is 0 where they meet; else it lies at an end of one of them, at the foot of an arc's centre on a line, or on the
/// line of two centres. A candidate that rounding does not exclude counts.
pub(crate) fn gap(path: &Piece, wall: &Piece) -> Gap {
    let mut gap = Gap { low: f64::INFINITY, at: middle(&path.a) };
    for end in [&path.a, &path.b] {
        gap.offer(point_to_piece(end, wall).low, middle(end));
    }
    for end in [&wall.a, &wall.b] {
        gap.offer(point_to_piece(end, path).low, nearest_on(path, middle(end)));
    }
    match (&path.shape, &wall.shape) {
        (Shape::Line, Shape::Line) => lines(path, wall, &mut gap),
        (Shape::Line, Shape::Arc { .. }) => line_and_arc(path, wall, |_, at| nearest_on(path, at), &mut gap),
        (Shape::Arc { .. }, Shape::Line) => line_and_arc(wall, path, |at, _| nearest_on(path, at), &mut gap),
        (Shape::Arc { .. }, Shape::Arc { .. }) => arcs(path, wall, &mut gap),
    }
    gap
}

/// Two lines have an interior candidate only where they cross.
fn lines(path: &Piece, wall: &Piece, gap: &mut Gap) {
    let (v, w) = (minus(&path.b, &path.a), minus(&wall.b, &wall.a));
    let across = |w: &Spot, from: &Spot, of: &Piece| [&of.a, &of.b].map(|end| cross(w, &minus(end, from)));
    let apart = |[x, y]: [Interval; 2]| (x.is_positive() && y.is_positive()) || (x.is_negative() && y.is_negative());
    let sides = across(&w, &wall.a, path);
    if apart(sides) || apart(across(&v, &path.a, wall)) || box_gap(&path.extent(), &wall.extent()) > 0.0 {
        return;
    }
    let fraction = sides[0].middle() / (sides[0].middle() - sides[1].middle());
    let fraction = if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.5 };
    gap.offer(0.0, middle(&plus(&path.a, &times(&v, Interval::of(fraction)))));
}

/// A line and an arc; `place` turns a point near the line and one near the arc into one of the path.
fn line_and_arc(line: &Piece, arc: &Piece, place: impl Fn([f64; 2], [f64; 2]) -> [f64; 2], gap: &mut Gap) {
    let Shape::Arc { centre, radius, rays } = &arc.shape else { return };
    let w = minus(&line.b, &line.a);
    let squared = dot(&w, &w);
    if !squared.is_positive() {
        return;
    }
    let to_foot = dot(&minus(centre, &line.a), &w).over(squared);
    let foot = plus(&line.a, &times(&w, to_foot));
    let ray = minus(&foot, centre);
    let height = cross(&w, &minus(centre, &line.a)).abs().over(squared.root());
    let on_line = |fraction: Interval| fraction.high >= 0.0 && fraction.low <= 1.0;
    let outside = height - *radius;
    if outside.high >= 0.0 && on_line(to_foot) && in_sector(rays, &ray) != Certainty::No {
        gap.offer(outside.low, place(middle(&foot), middle(&foot)));
    }
    let rest = radius.square() - height.square();
    if rest.high < 0.0 {
        return;
    }
    let half = rest.root().over(squared.root());
    for fraction in [to_foot - half, to_foot + half] {
        let meet = plus(&line.a, &times(&w, fraction));
        if on_line(fraction) && in_sector(rays, &minus(&meet, centre)) != Certainty::No {
            gap.offer(0.0, place(middle(&meet), middle(&meet)));
        }
    }
}

/// Two arcs: where they meet, or on the line of their centres.
fn arcs(path: &Piece, wall: &Piece, gap: &mut Gap) {
    let (Shape::Arc { centre: c1, radius: r1, rays: s1 }, Shape::Arc { centre: c2, radius: r2, rays: s2 }) =
        (&path.shape, &wall.shape)
    else {
        return;
    };
    let between = minus(c2, c1);
    let apart = length(&between);
    let at = |ray: &Spot| nearest_on(path, middle(&plus(c1, &times(ray, *r1))));
    if apart.low < 1e-12 * (r1.high + r2.high) || apart.high > 2.0 * apart.low {
        // Nearly concentric: the direction between the centres is lost, but hardly matters where both arcs reach.
        let mine = s1.iter().find(|ray| in_sector(s2, ray) != Certainty::No);
        if let Some(ray) = mine.or_else(|| s2.iter().find(|ray| in_sector(s1, ray) != Certainty::No)) {
            gap.offer(((*r1 - *r2).abs() - apart).low, at(ray));
        }
        return;
    }
    let unit = times(&between, Interval::of(1.0).over(apart));
    let back = [-unit[0], -unit[1]];
    let mut offer = |low: Interval, first: &Spot, second: &Spot| {
        if low.high >= 0.0 && in_sector(s1, first) != Certainty::No && in_sector(s2, second) != Certainty::No {
            gap.offer(low.low, at(first));
        }
    };
    offer(apart - *r1 - *r2, &unit, &back);
    offer(*r2 - *r1 - apart, &back, &back);
    offer(*r1 - *r2 - apart, &unit, &unit);
    // The circles meet where the distance along the line of centres is a, and h to either side.
    let a = (r1.square() - r2.square() + apart.square()).over(apart + apart);
    let rest = r1.square() - a.square();
    if rest.high < 0.0 {
        return;
    }
    for h in [rest.root(), -rest.root()] {
        let meet = plus(&times(&unit, a), &times(&[-unit[1], unit[0]], h));
        if in_sector(s1, &meet) != Certainty::No && in_sector(s2, &minus(&meet, &between)) != Certainty::No {
            gap.offer(0.0, nearest_on(path, middle(&plus(c1, &meet))));
        }
    }
}

/// An upper bound of the distance of any point of the first piece from the second.
pub(crate) fn farthest(path: &Piece, hull: &Hull, wall: &Piece) -> f64 {
    let mut bound = farthest_from_point(path, hull, &wall.a).min(farthest_from_point(path, hull, &wall.b));
    match &wall.shape {
        // The distance from a convex set is greatest at a corner of the hull.
        Shape::Line => {
            let corners = hull.points().iter().map(|corner| point_to_piece(corner, wall).high);
            bound = bound.min(corners.fold(0.0, f64::max));
        }
        Shape::Arc { centre, radius, rays } => {
            if hull_in_sector(rays, centre, hull) == Certainty::Yes {
                let beyond = Interval::of(farthest_from_point(path, hull, centre)) - *radius;
                let within = *radius - point_to_piece(centre, path);
                bound = bound.min(beyond.high.max(within.high));
            }
        }
    }
    bound
}

/// An upper bound of the distance of any point of a piece from a point.
pub(crate) fn farthest_from_point(piece: &Piece, hull: &Hull, point: &Spot) -> f64 {
    let corners = hull.points().iter().map(|corner| distance(corner, point).high);
    let bound = corners.fold(0.0, f64::max);
    match &piece.shape {
        Shape::Line => bound,
        Shape::Arc { centre, radius, .. } => bound.min((distance(centre, point) + *radius).high),
    }
}

/// A lower bound of the distance of two boxes.
pub(crate) fn box_gap(one: &[[f64; 2]; 2], other: &[[f64; 2]; 2]) -> f64 {
    let gaps = [0, 1].map(|axis| {
        let gap = (one[0][axis] - other[1][axis]).max(other[0][axis] - one[1][axis]);
        if gap > 0.0 { gap.next_down() } else { 0.0 }
    });
    // The root of the sum of squares rounds by less than this.
    if gaps[0] > 0.0 && gaps[1] > 0.0 { gaps[0].hypot(gaps[1]) * (1.0 - 1e-15) } else { gaps[0].max(gaps[1]) }
}
