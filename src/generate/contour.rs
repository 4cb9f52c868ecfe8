//! Contours in whole thousandths of a millimetre.

use radcomp_spec::Direction;

use super::Reach;
use super::dice::Dice;

/// A point or vector in thousandths of a millimetre.
pub(super) type Whole = [i64; 2];

/// One move of a contour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Move {
    pub(super) end: Whole,
    pub(super) shape: MoveShape,
    /// Length of a line or radius of an arc, rounded; what a tool may exactly fit.
    pub(super) size: i64,
    /// At rapid traverse.
    pub(super) rapid: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum MoveShape {
    Line,
    Centre { from_start: Whole, direction: Direction },
    Radius { radius: i64, direction: Direction },
}

/// Directions with whole lengths: the vector, and its length.
pub(super) const DIRECTIONS: [(Whole, i64); 8] =
    [([1, 0], 1), ([0, 1], 1), ([3, 4], 5), ([4, 3], 5), ([5, 12], 13), ([8, 15], 17), ([7, 24], 25), ([20, 21], 29)];

/// Points of the circle with radius 65 that have whole coordinates, in one eighth; the rest by symmetry.
const ON_CIRCLE_65: [Whole; 5] = [[65, 0], [63, 16], [60, 25], [56, 33], [52, 39]];

pub(super) const SCALES: [i64; 7] = [20, 50, 100, 200, 500, 1000, 2000];

/// A start point and the moves from there.
#[derive(Clone, Debug)]
pub(super) struct Contour {
    pub(super) start: Whole,
    pub(super) moves: Vec<Move>,
    /// The arc that leads to its start, and where that begins, if it is one.
    pub(super) entry: Option<(Whole, Move)>,
}

impl Contour {
    /// Where it ends.
    pub(super) fn end(&self) -> Whole {
        self.moves.last().map_or(self.start, |last| last.end)
    }
}

pub(super) fn contour(dice: &mut Dice, reach: Reach) -> Contour {
    let scale = dice.pick(&SCALES);
    let unit = dice.pick(&[1, scale, scale]);
    let start = [dice.between(-20, 20) * unit, dice.between(-20, 20) * unit];
    let mut at = start;
    let mut heading: Whole = [1, 0];
    let count = dice.between(3, 8);
    let mut moves = Vec::with_capacity(count as usize);
    let entry = (reach.starts_on_arcs() && dice.once_in(3)).then(|| entry(start, scale, dice));
    if let Some((from, arc)) = &entry {
        heading = heading_after(*from, arc);
    }
    for _ in 0..count {
        let mut next = any(at, heading, scale, dice);
        next.rapid = matches!(next.shape, MoveShape::Line) && dice.once_in(8);
        heading = heading_after(at, &next);
        at = next.end;
        moves.push(next);
    }
    Contour { start, moves, entry }
}

/// A line or an arc.
pub(super) fn any(at: Whole, heading: Whole, scale: i64, dice: &mut Dice) -> Move {
    match dice.below(10) {
        0..=5 => line(at, heading, scale, dice),
        6 => radius_arc(at, scale, dice),
        _ => centre_arc(at, heading, scale, dice),
    }
}

/// An arc, given by its radius or its centre.
pub(super) fn arc(at: Whole, heading: Whole, scale: i64, dice: &mut Dice) -> Move {
    if dice.once_in(4) { radius_arc(at, scale, dice) } else { centre_arc(at, heading, scale, dice) }
}

/// A direction in one of the eight symmetric positions.
pub(super) fn symmetric(vector: Whole, dice: &mut Dice) -> Whole {
    let [a, b] = if dice.once_in(2) { vector } else { [vector[1], vector[0]] };
    [if dice.once_in(2) { a } else { -a }, if dice.once_in(2) { b } else { -b }]
}

pub(super) fn line(at: Whole, heading: Whole, scale: i64, dice: &mut Dice) -> Move {
    let (vector, length) = match dice.below(11) {
        // On along the tangent, at right angles, back, and by 45°.
        0 => (heading, 0),
        1 => ([-heading[1], heading[0]], 0),
        2 => ([heading[1], -heading[0]], 0),
        3 => ([-heading[0], -heading[1]], 0),
        4 => ([heading[0] - heading[1], heading[0] + heading[1]], 0),
        // A little aside, and all but back.
        6 => (aside(heading, scale, dice), 0),
        7 => (aside([-heading[0], -heading[1]], scale, dice), 0),
        5 => ([dice.between(-3000, 3000), dice.between(-3000, 3000)], 0),
        _ => {
            let (vector, length) = dice.pick(&DIRECTIONS);
            let times = scale * dice.between(1, 6);
            (symmetric([vector[0] * times, vector[1] * times], dice), length * times)
        }
    };
    let vector = tame(vector, scale);
    let size = if length > 0 { length } else { whole_length(vector) };
    Move { end: [at[0] + vector[0], at[1] + vector[1]], shape: MoveShape::Line, size, rapid: false }
}

/// A vector that turns from a heading by an angle whose tangent is one part in a few: about the limits of the corners that
/// count as straight, and, turned from the heading back, of those that are too sharp.
fn aside(heading: Whole, scale: i64, dice: &mut Dice) -> Whole {
    let shorter = (whole_length(heading) / 40).max(1);
    let [a, b] = [heading[0] / shorter, heading[1] / shorter];
    let parts = dice.pick(&[5, 5, 6, 8, 12, 19, 20, 21, 40, 57, 58]);
    let side = if dice.once_in(2) { 1 } else { -1 };
    let vector = [a * parts - side * b, b * parts + side * a];
    let times = (scale * 5 / whole_length(vector).max(1)).max(1);
    [vector[0] * times, vector[1] * times]
}

/// An arc that ends at a point, and where it starts.
pub(super) fn entry(start: Whole, scale: i64, dice: &mut Dice) -> (Whole, Move) {
    let direction = dice.pick(&[Direction::Clockwise, Direction::Counterclockwise]);
    let times = (scale * dice.between(1, 4) / 25).max(1);
    let [to_start, to_end] = [0, 0].map(|_| {
        let ray = dice.pick(&ON_CIRCLE_65);
        symmetric([ray[0] * times, ray[1] * times], dice)
    });
    let from = [start[0] - to_end[0] + to_start[0], start[1] - to_end[1] + to_start[1]];
    let shape = MoveShape::Centre { from_start: [-to_start[0], -to_start[1]], direction };
    (from, Move { end: start, shape, size: 65 * times, rapid: false })
}

/// Keeps headings from growing without end: a vector along the same direction of a reasonable length.
fn tame(vector: Whole, scale: i64) -> Whole {
    let common = gcd(vector[0].abs(), vector[1].abs());
    let reduced = if common > 0 { [vector[0] / common, vector[1] / common] } else { vector };
    let length = whole_length(reduced).max(1);
    let times = (scale * 5 / length).max(1);
    let tamed = [reduced[0] * times, reduced[1] * times];
    if whole_length(vector) > 100 * scale || whole_length(vector) < 2 { tamed } else { vector }
}

pub(super) fn whole_length(vector: Whole) -> i64 {
    let squared = vector[0].unsigned_abs().pow(2) + vector[1].unsigned_abs().pow(2);
    squared.isqrt() as i64
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// An arc whose start and end lie exactly on it.
fn centre_arc(at: Whole, heading: Whole, scale: i64, dice: &mut Dice) -> Move {
    let direction = dice.pick(&[Direction::Clockwise, Direction::Counterclockwise]);
    let times = (scale * dice.between(1, 4) / 25).max(1);
    let rays = |dice: &mut Dice| {
        let ray = dice.pick(&ON_CIRCLE_65);
        symmetric([ray[0] * times, ray[1] * times], dice)
    };
    // Half of the arcs begin at right angles to an axis-parallel heading, so that they continue it.
    let to_start = if dice.once_in(2) && (heading[0] == 0 || heading[1] == 0) {
        let radius = 65 * times;
        let side = if dice.once_in(2) { 1 } else { -1 };
        [-heading[1].signum() * radius * side, heading[0].signum() * radius * side]
    } else {
        rays(dice)
    };
    let centre = [at[0] - to_start[0], at[1] - to_start[1]];
    let to_end = if dice.once_in(8) { to_start } else { rays(dice) };
    let mut end = [centre[0] + to_end[0], centre[1] + to_end[1]];
    if dice.once_in(6) {
        // An end that is not quite on the arc, or well off it.
        let off = dice.pick(&[1, 2, 5, 7, 10, 20]);
        end[dice.below(2)] += if dice.once_in(2) { off } else { -off };
    }
    let mut from_start = [-to_start[0], -to_start[1]];
    if dice.once_in(60) {
        from_start = [0, 0];
    }
    Move { end, shape: MoveShape::Centre { from_start, direction }, size: 65 * times, rapid: false }
}

fn radius_arc(at: Whole, scale: i64, dice: &mut Dice) -> Move {
    let direction = dice.pick(&[Direction::Clockwise, Direction::Counterclockwise]);
    let (vector, length) = dice.pick(&DIRECTIONS);
    let times = 2 * scale * dice.between(1, 4);
    let vector = symmetric([vector[0] * times, vector[1] * times], dice);
    let half = length * times / 2;
    // Half turns, arcs through Pythagorean points, any other, and now and then one that does not exist.
    let radius = match dice.below(8) {
        0 | 1 => half,
        2 => half * 5 / 4,
        3 => half * 13 / 12,
        4 => half - 1,
        _ => half + dice.between(1, 3 * half.max(1)),
    };
    let radius = if dice.once_in(3) { -radius } else { radius };
    let end = [at[0] + vector[0], at[1] + vector[1]];
    Move { end, shape: MoveShape::Radius { radius, direction }, size: radius.abs(), rapid: false }
}

/// A whole vector along the direction of travel at the end of a move; for R arcs any.
pub(super) fn heading_after(at: Whole, done: &Move) -> Whole {
    match done.shape {
        MoveShape::Line => [done.end[0] - at[0], done.end[1] - at[1]],
        MoveShape::Radius { .. } => [done.end[1] - at[1], at[0] - done.end[0]],
        MoveShape::Centre { from_start, direction } => {
            let ray = [done.end[0] - at[0] - from_start[0], done.end[1] - at[1] - from_start[1]];
            match direction {
                Direction::Counterclockwise => [-ray[1], ray[0]],
                Direction::Clockwise => [ray[1], -ray[0]],
            }
        }
    }
}
