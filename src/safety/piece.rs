//! Pieces of lines and arcs: straight, or circular by at most a quarter turn between known rays.

use std::cmp::Ordering;
use std::f64::consts::{FRAC_PI_2, TAU};

use rug::Rational;

use super::interval::{Interval, Spot, cross, distance, dot, hull, length, middle, minus, plus, spot, times};

/// A piece of a contour or of a path. The true piece lies inside what the intervals allow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// One end; of an arc the clockwise one.
    pub(crate) a: Spot,
    /// The other end.
    pub(crate) b: Spot,
    /// Its shape.
    pub(crate) shape: Shape,
}

/// The shape of a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// Straight.
    Line,
    /// Circular, from the ray of `a` counter-clockwise to the ray of `b`, a quarter turn at most.
    Arc {
        /// Centre.
        centre: Spot,
        /// Every radius that the arc has on its way ([TRC-ARC-04]).
        radius: Interval,
        /// Unit vectors from the centre to `a` and `b`.
        rays: [Spot; 2],
    },
}

/// A whole arc, before it is cut into pieces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    /// Start.
    pub(crate) start: Spot,
    /// End.
    pub(crate) end: Spot,
    /// Centre.
    pub(crate) centre: Spot,
    /// Counter-clockwise.
    pub(crate) ccw: bool,
    /// A whole turn.
    pub(crate) full: bool,
}

/// Whether something is so: certainly, perhaps, or certainly not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Certainty {
    Yes,
    Maybe,
    No,
}

const AXES: [[f64; 2]; 4] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];

/// Below this turn, and as near to a whole one, doubles do not tell nothing from everything.
const DELICATE: f64 = 1e-7;

impl Piece {
    /// A straight piece.
    pub(crate) fn line(a: Spot, b: Spot) -> Self {
        Piece { a, b, shape: Shape::Line }
    }

    /// A circular piece between two unit rays.
    fn arc(centre: Spot, radius: Interval, rays: [Spot; 2]) -> Self {
        let at = |ray: &Spot| plus(&centre, &times(ray, radius));
        Piece { a: at(&rays[0]), b: at(&rays[1]), shape: Shape::Arc { centre, radius, rays } }
    }

    /// The pieces of an arc in the order of travel, cut where it is farthest along an axis.
    pub(crate) fn of_turn(turn: &Turn) -> Vec<Piece> {
        let (from, to) = if turn.ccw { (&turn.start, &turn.end) } else { (&turn.end, &turn.start) };
        let arms = [minus(from, &turn.centre), minus(to, &turn.centre)];
        let lengths = arms.each_ref().map(length);
        let radius = lengths[0].hull(lengths[1]);
        if lengths.iter().any(|length| !length.is_positive()) {
            return vec![Piece::line(turn.start, turn.end)];
        }
        let rays = [0, 1].map(|k| times(&arms[k], Interval::of(1.0).over(lengths[k])));
        let angles = arms.each_ref().map(|arm| arm[1].middle().atan2(arm[0].middle()));
        let sweep = if turn.full { TAU } else { swept(angles[1] - angles[0], &arms, from, to, &turn.centre) };
        let mut cuts = vec![rays[0]];
        let first = (angles[0] / FRAC_PI_2).floor() as i64;
        for quarter in first..first + 6 {
            let beyond = quarter as f64 * FRAC_PI_2 - angles[0];
            if beyond > 1e-12 && beyond < sweep - 1e-12 {
                cuts.push(spot(AXES[quarter.rem_euclid(4) as usize]));
            }
        }
        cuts.push(rays[1]);
        let mut pieces: Vec<Piece> =
            cuts.windows(2).map(|pair| Piece::arc(turn.centre, radius, [pair[0], pair[1]])).collect();
        if let Some(piece) = pieces.first_mut() {
            piece.a = hull(&piece.a, from);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.b = hull(&piece.b, to);
        }
        if !turn.ccw {
            pieces.reverse();
        }
        pieces
    }

    /// Points whose convex hull holds the piece.
    pub(crate) fn hull(&self) -> Hull {
        match &self.shape {
            Shape::Line => Hull { points: [self.a, self.b, self.b], count: 2 },
            Shape::Arc { centre, radius, rays } => {
                // The two tangents at the ends meet at centre + R·(a + b)/(1 + a·b), for unit rays a and b.
                let factor = radius.over(Interval::of(1.0) + dot(&rays[0], &rays[1]));
                let top = plus(centre, &times(&plus(&rays[0], &rays[1]), factor));
                Hull { points: [self.a, self.b, top], count: 3 }
            }
        }
    }

    /// A box that holds the piece: low corner, high corner.
    pub(crate) fn extent(&self) -> [[f64; 2]; 2] {
        let mut extent = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in self.hull().points() {
            for axis in 0..2 {
                extent[0][axis] = extent[0][axis].min(point[axis].low);
                extent[1][axis] = extent[1][axis].max(point[axis].high);
            }
        }
        extent
    }

    /// The two halves.
    pub(crate) fn halves(&self) -> [Piece; 2] {
        match &self.shape {
            Shape::Line => {
                let half = times(&plus(&self.a, &self.b), Interval::of(0.5));
                [Piece::line(self.a, half), Piece::line(half, self.b)]
            }
            Shape::Arc { centre, radius, rays } => {
                // Any direction between the rays will do, but one must be used for both halves.
                let along = spot(middle(&plus(&rays[0], &rays[1])));
                let ray = times(&along, Interval::of(1.0).over(length(&along)));
                let halves = [[rays[0], ray], [ray, rays[1]]].map(|rays| Piece::arc(*centre, *radius, rays));
                [Piece { a: self.a, ..halves[0] }, Piece { b: self.b, ..halves[1] }]
            }
        }
    }

    /// An upper bound of the distance between the ends.
    pub(crate) fn chord(&self) -> f64 {
        distance(&self.a, &self.b).high
    }

    /// A point on the piece, to within rounding, near its middle.
    pub(crate) fn centre_point(&self) -> [f64; 2] {
        middle(&self.halves()[0].b)
    }
}

/// Up to three points whose convex hull holds a piece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hull {
    points: [Spot; 3],
    count: usize,
}

impl Hull {
    /// A single point.
    pub(crate) fn point(at: Spot) -> Self {
        Hull { points: [at; 3], count: 1 }
    }

    /// The points.
    pub(crate) fn points(&self) -> &[Spot] {
        &self.points[..self.count]
    }
}

/// Whether a vector points into the sector between two unit rays, a quarter turn at most, its edges included.
pub(crate) fn in_sector(rays: &[Spot; 2], vector: &Spot) -> Certainty {
    let from_a = cross(&rays[0], vector);
    let to_b = cross(vector, &rays[1]);
    let along = dot(&plus(&rays[0], &rays[1]), vector);
    if from_a.is_negative() || to_b.is_negative() || along.is_negative() {
        Certainty::No
    } else if from_a.low >= 0.0 && to_b.low >= 0.0 && along.is_positive() {
        Certainty::Yes
    } else {
        Certainty::Maybe
    }
}

/// The same for all points of a hull, seen from the centre: all of them, some perhaps, or certainly none.
pub(crate) fn hull_in_sector(rays: &[Spot; 2], centre: &Spot, hull: &Hull) -> Certainty {
    let bisector = plus(&rays[0], &rays[1]);
    let (mut all, mut outside) = (true, [true; 3]);
    for point in hull.points() {
        let vector = minus(point, centre);
        let tests = [cross(&rays[0], &vector), cross(&vector, &rays[1]), dot(&bisector, &vector)];
        for (none, test) in outside.iter_mut().zip(tests) {
            *none &= test.is_negative();
        }
        all &= tests[0].low >= 0.0 && tests[1].low >= 0.0 && tests[2].is_positive();
    }
    match (all, outside.contains(&true)) {
        (true, _) => Certainty::Yes,
        (_, true) => Certainty::No,
        _ => Certainty::Maybe,
    }
}

/// The counter-clockwise turn from one arm to the other, in \[0, 2π\], where it matters decided without rounding.
fn swept(turn: f64, arms: &[Spot; 2], from: &Spot, to: &Spot, centre: &Spot) -> f64 {
    let turn = turn.rem_euclid(TAU);
    if turn > DELICATE && turn < TAU - DELICATE {
        return turn;
    }
    let left = cross(&arms[0], &arms[1]);
    let sign = match (left.is_positive(), left.is_negative()) {
        (true, _) => Ordering::Greater,
        (_, true) => Ordering::Less,
        _ if from == to => Ordering::Equal,
        _ => exact_left(middle(from), middle(to), middle(centre)),
    };
    // Nothing, or a turn less than rounding away from nothing or from a whole one.
    match sign {
        Ordering::Equal => 0.0,
        Ordering::Greater => turn.min(DELICATE),
        Ordering::Less => turn.max(TAU - DELICATE),
    }
}

/// On which side of the first arm the second one points, for arms between doubles.
fn exact_left(from: [f64; 2], to: [f64; 2], centre: [f64; 2]) -> Ordering {
    // The numbers are finite, see `super::LARGEST`; anything else would count as 0.
    let exact = |value: f64| Rational::from_f64(value).unwrap_or_default();
    let arm = |p: [f64; 2]| [0, 1].map(|axis| exact(p[axis]) - exact(centre[axis]));
    let ([a, b], [c, d]) = (arm(from), arm(to));
    Rational::from(&a * &d).cmp(&Rational::from(&b * &c))
}
