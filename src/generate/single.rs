//! Programs that show a single feature: approach, start-up, two to five blocks, cancel.

use radcomp_spec::{Block, Compensation, Direction, Side};
use rug::Rational;

use super::contour::{Contour, DIRECTIONS, Move, MoveShape, SCALES, Whole};
use super::dice::Dice;
use super::{Reach, Shape, codes, contour, features, step, vectors};

/// Radii of tool noses, in thousandths of a millimetre.
const NOSES: [i64; 5] = [200, 400, 800, 1200, 1600];

/// A program of a shape. A whole program has no feature of its own, and is here one of a single corner.
pub(super) fn program(shape: Shape, dice: &mut Dice, reach: Reach) -> Vec<Block<Rational>> {
    let scale = dice.pick(&SCALES);
    let start = [dice.between(-20, 20) * scale, dice.between(-20, 20) * scale];
    let steps = shape == Shape::Slot && dice.once_in(2);
    let contour = match shape {
        Shape::CornerChain => chain(start, dice.between(3, 5), |at, heading| contour::line(at, heading, scale, dice)),
        Shape::ArcChain => chain(start, dice.between(2, 4), |at, heading| contour::arc(at, heading, scale, dice)),
        Shape::Slot if steps && dice.once_in(6) => step::notched_round(start, scale, dice),
        Shape::Slot if steps => step::step(start, scale, dice),
        Shape::Slot => slot(start, scale, dice),
        Shape::Lathe => turned(start, scale, dice),
        Shape::StartUp => Contour {
            entry: (reach.starts_on_arcs() && dice.once_in(2)).then(|| contour::entry(start, scale, dice)),
            ..chain(start, dice.between(1, 2), |at, heading| contour::any(at, heading, scale, dice))
        },
        Shape::Cancel => chain(start, dice.between(1, 2), |at, heading| contour::any(at, heading, scale, dice)),
        // An arc that leads to the contour may have another side than what follows it.
        Shape::SideChange => Contour {
            entry: (reach.starts_on_arcs() && dice.once_in(2)).then(|| contour::entry(start, scale, dice)),
            ..chain(start, dice.between(2, 3), |at, heading| contour::any(at, heading, scale, dice))
        },
        Shape::WithoutMovement => {
            chain(start, dice.between(2, 3), |at, heading| contour::any(at, heading, scale, dice))
        }
        Shape::SingleCorner | Shape::WholeProgram => {
            chain(start, 2, |at, heading| contour::any(at, heading, scale, dice))
        }
    };
    let side = dice.pick(&[Side::Left, Side::Right]);
    let radius = match shape {
        Shape::Slot if steps => step::radius(&contour, dice),
        Shape::Slot => slot_radius(&contour, dice),
        Shape::Lathe if dice.once_in(2) => dice.pick(&NOSES),
        _ => codes::tool_radius(&contour.moves, dice),
    };
    let mut blocks = codes::lead_in(&contour, side, radius, dice, reach);
    let first = blocks.len();
    blocks.extend(contour.moves.iter().map(codes::block));
    match shape {
        Shape::SideChange => change_side(&mut blocks[first..], usize::from(contour.entry.is_none()), side, dice),
        Shape::SingleCorner | Shape::CornerChain => choose_corners(&mut blocks, dice, reach),
        _ => {}
    }
    if shape == Shape::Cancel || !dice.once_in(8) {
        codes::lead_out(&mut blocks, contour.end(), side, dice);
    }
    if shape == Shape::Cancel && dice.once_in(3) {
        start_again(&mut blocks, side, dice);
    }
    match shape {
        Shape::SingleCorner | Shape::StartUp | Shape::Cancel | Shape::SideChange => {
            vectors::give(&mut blocks, dice, reach);
        }
        Shape::WithoutMovement => features::decorate(&mut blocks, 2, dice, reach),
        _ => {}
    }
    blocks
}

/// So many moves, each made from where the tool is and whither it goes.
fn chain(start: Whole, count: i64, mut next: impl FnMut(Whole, Whole) -> Move) -> Contour {
    let (mut at, mut heading) = (start, [1, 0]);
    let mut moves = Vec::new();
    for _ in 0..count {
        let made = next(at, heading);
        heading = contour::heading_after(at, &made);
        at = made.end;
        moves.push(made);
    }
    Contour { start, moves, entry: None }
}

/// In, across at right angles, and out again; in a slot of parallel or nearly parallel walls.
fn slot(start: Whole, scale: i64, dice: &mut Dice) -> Contour {
    let (vector, length) = dice.pick(&DIRECTIONS);
    let [a, b] = contour::symmetric(vector, dice);
    let (deep, wide) = (scale * dice.between(1, 5), scale * dice.between(1, 3));
    let side = if dice.once_in(2) { 1 } else { -1 };
    let across = [-b * wide * side, a * wide * side];
    let out = if dice.once_in(2) { deep } else { scale * dice.between(1, 5) };
    let aslant = if dice.once_in(4) { dice.between(-2, 2) * scale / 10 } else { 0 };
    let mut at = start;
    let moves =
        [([a * deep, b * deep], length * deep), (across, length * wide), ([aslant - a * out, -b * out], length * out)];
    let moves = moves.map(|(vector, size)| {
        at = [at[0] + vector[0], at[1] + vector[1]];
        straight(at, size)
    });
    Contour { start, moves: moves.to_vec(), entry: None }
}

/// Half the width of the slot, just less or more, or what is surely too little or too much.
fn slot_radius(contour: &Contour, dice: &mut Dice) -> i64 {
    let wide = contour.moves[1].size;
    let exact = wide / 2;
    let radii = [exact, exact - 1, exact + 1, wide / 4, wide / 3, wide];
    dice.pick(&radii).max(1)
}

/// A contour that a lathe turns toward the chuck, its first coordinate falling.
fn turned(start: Whole, scale: i64, dice: &mut Dice) -> Contour {
    let mut moves = Vec::new();
    let mut at = start;
    let mut go = |vector: Whole, shape: MoveShape, size: i64| {
        at = [at[0] + vector[0], at[1] + vector[1]];
        moves.push(Move { end: at, shape, size, rapid: false });
    };
    for _ in 0..dice.between(2, 4) {
        let length = scale * dice.between(1, 5);
        match dice.below(7) {
            0 => go([-length, 0], MoveShape::Line, length),
            1 => go([0, length], MoveShape::Line, length),
            2 => go([-length, length], MoveShape::Line, length),
            3 => go([-4 * length, 3 * length], MoveShape::Line, 5 * length),
            // A groove: down, along, up.
            4 => {
                let wide = scale * dice.between(1, 3);
                go([0, -length], MoveShape::Line, length);
                go([-wide, 0], MoveShape::Line, wide);
                go([0, length], MoveShape::Line, length);
            }
            // A fillet, and the rounding of an edge: a quarter of a circle.
            5 => {
                let shape = MoveShape::Centre { from_start: [0, length], direction: Direction::Clockwise };
                go([-length, length], shape, length);
            }
            _ => {
                let shape = MoveShape::Centre { from_start: [-length, 0], direction: Direction::Counterclockwise };
                go([-length, length], shape, length);
            }
        }
    }
    Contour { start, moves, entry: None }
}

fn straight(end: Whole, size: i64) -> Move {
    Move { end, shape: MoveShape::Line, size, rapid: false }
}

/// The other side from one of the moves on, the one at `first` or one behind it, and at times the first side again from the
/// next.
fn change_side(moves: &mut [Block<Rational>], first: usize, side: Side, dice: &mut Dice) {
    let place = first + dice.below(moves.len() - first);
    moves[place].compensation = Some(Compensation::On(side.other()));
    if place + 1 < moves.len() && dice.once_in(3) {
        moves[place + 1].compensation = Some(Compensation::On(side));
    }
}

/// The form of the outer corners, where codes choose it.
fn choose_corners(blocks: &mut [Block<Rational>], dice: &mut Dice, reach: Reach) {
    if !reach.corners().is_empty() {
        let place = dice.below(blocks.len());
        blocks[place].corner = Some(dice.pick(reach.corners()));
    }
}

/// A start-up after the cancel, and a move.
fn start_again(blocks: &mut Vec<Block<Rational>>, side: Side, dice: &mut Dice) {
    for compensation in [Some(Compensation::On(side)), None] {
        let end = [dice.between(-9, 9) * 1000, dice.between(-9, 9) * 1000];
        blocks.push(Block { compensation, ..codes::line(end) });
    }
}
