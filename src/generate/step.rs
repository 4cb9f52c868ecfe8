//! Steps and notches narrower than the tool: a long move, one to three short ones, and a long one that leads on; the long
//! ones may be one circle.

use radcomp_spec::Direction;

use super::contour::{Contour, DIRECTIONS, Move, MoveShape, Whole, symmetric, whole_length};
use super::dice::Dice;

/// A direction with a whole length.
type Heading = (Whole, i64);

/// Lines and arcs alike; the last long move most often leads whither the first one does, or to its side.
pub(super) fn step(start: Whole, scale: i64, dice: &mut Dice) -> Contour {
    let (vector, length) = dice.pick(&DIRECTIONS);
    let ahead = (symmetric(vector, dice), length);
    // Not so short that a least increment makes another shape of it.
    let short = (scale / 5).max(100);
    let mut contour = Contour { start, moves: Vec::new(), entry: None };
    let onward = add(&mut contour, ahead, 4 * scale, dice);
    let mut heading = turned(onward, dice);
    for _ in 0..dice.between(1, 3) {
        let behind = add(&mut contour, heading, short, dice);
        heading = turned(behind, dice);
    }
    if dice.once_in(2) {
        heading = onward;
    }
    let behind = add(&mut contour, heading, 4 * scale, dice);
    if dice.once_in(2) {
        add(&mut contour, turned(behind, dice), 4 * scale, dice);
    }
    contour
}

/// A notch in a round: an arc, two lines inward and out again, and the same circle on from there.
pub(super) fn notched_round(start: Whole, scale: i64, dice: &mut Dice) -> Contour {
    // Not along an axis: its coordinates changed over are the same.
    let (vector, length) = dice.pick(&DIRECTIONS[2..]);
    let times = (20 * scale / length).max(40);
    let circle = |[a, b]: Whole, about: Whole| [about[0] + a * times, about[1] + b * times];
    // Places on the circle: where it starts, the two edges of the notch, and where it ends.
    let [a, b] = symmetric(vector, dice);
    let edges = if dice.once_in(2) { [[a, b], [b, a]] } else { [[a, b], [-a, b]] };
    // Neither arc is a full circle.
    let [from, to] = edges.map(|edge| match symmetric(vector, dice) {
        place if place == edge => edge.map(|value| -value),
        place => place,
    });
    let direction = if dice.once_in(2) { Direction::Counterclockwise } else { Direction::Clockwise };
    let centre = [start[0] - from[0] * times, start[1] - from[1] * times];
    let part = dice.between(1, 8);
    let ground = [0, 1].map(|axis| centre[axis] + (edges[0][axis] + edges[1][axis]) * times * part / 16);
    let mut contour = Contour { start, moves: Vec::new(), entry: None };
    let line = |end: Whole, size: i64| Move { end, shape: MoveShape::Line, size: size.max(1), rapid: false };
    let arc = |end: Whole, at: Whole| {
        let shape = MoveShape::Centre { from_start: [centre[0] - at[0], centre[1] - at[1]], direction };
        Move { end, shape, size: length * times, rapid: false }
    };
    let ends = edges.map(|edge| circle(edge, centre));
    let wide = whole_length([ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]]);
    contour.moves.push(arc(ends[0], start));
    contour.moves.push(line(ground, wide / 2));
    contour.moves.push(line(ends[1], wide / 2));
    contour.moves.push(arc(circle(to, centre), ends[1]));
    contour
}

/// A tool that is wider than the step, or as wide, or that goes in.
pub(super) fn radius(contour: &Contour, dice: &mut Dice) -> i64 {
    let short = contour.moves[1].size;
    dice.pick(&[short / 2, short, short * 3 / 2, 2 * short, 3 * short, 4 * short, 6 * short]).max(1)
}

/// Adds a line or an arc that starts in a direction, about so long; answers the direction at its end.
fn add(contour: &mut Contour, (vector, length): Heading, about: i64, dice: &mut Dice) -> Heading {
    let at = contour.end();
    let times = (about * dice.between(1, 4) / 2 / length).max(1);
    let [a, b] = vector.map(|value| value * times);
    let size = length * times;
    if dice.once_in(2) {
        contour.moves.push(Move { end: [at[0] + a, at[1] + b], shape: MoveShape::Line, size, rapid: false });
        return (vector, length);
    }
    let (from_start, direction) =
        if dice.once_in(2) { ([-b, a], Direction::Counterclockwise) } else { ([b, -a], Direction::Clockwise) };
    // A full circle leads nowhere.
    let to_end = match symmetric([a, b], dice) {
        [x, y] if [x, y] == [-from_start[0], -from_start[1]] => from_start,
        to_end => to_end,
    };
    let end = [at[0] + from_start[0] + to_end[0], at[1] + from_start[1] + to_end[1]];
    contour.moves.push(Move { end, shape: MoveShape::Centre { from_start, direction }, size, rapid: false });
    let [x, y] = to_end.map(|value| value / times);
    match direction {
        Direction::Counterclockwise => ([-y, x], length),
        Direction::Clockwise => ([y, -x], length),
    }
}

/// On, to a side at right angles, to any place symmetric to it, or another direction.
fn turned((vector, length): Heading, dice: &mut Dice) -> Heading {
    match dice.below(6) {
        0 => (vector, length),
        1 | 2 => ([-vector[1], vector[0]], length),
        3 => ([vector[1], -vector[0]], length),
        4 => (symmetric(vector, dice), length),
        _ => {
            let (vector, length) = dice.pick(&DIRECTIONS);
            (symmetric(vector, dice), length)
        }
    }
}
