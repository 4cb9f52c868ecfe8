//! Compensation codes around a contour.

use radcomp_spec::{Block, Centre, Compensation, Movement, Side};
use rug::Rational;

use super::contour::{Contour, Move, MoveShape, Whole};
use super::dice::Dice;
use super::{Reach, thousandths};

/// Approach, start-up, the contour, cancel, and a move away.
pub(super) fn with_codes(contour: Contour, dice: &mut Dice, reach: Reach) -> Vec<Block<Rational>> {
    let side = dice.pick(&[Side::Left, Side::Right]);
    let radius = tool_radius(&contour.moves, dice);
    let mut blocks = Vec::with_capacity(contour.moves.len() + 8);
    let approach = [contour.start[0] - dice.between(-8, 8) * 500, contour.start[1] - dice.between(-8, 8) * 500];
    blocks.push(Block { rapid: dice.once_in(2), ..line(approach) });

    let mut start_up = line(contour.start);
    if dice.once_in(3) {
        blocks.push(Block {
            compensation: Some(Compensation::On(side)),
            radius: Some(thousandths(radius)),
            ..Block::empty()
        });
    } else {
        start_up.compensation = Some(Compensation::On(side));
        start_up.radius = Some(thousandths(radius));
    }
    if !dice.once_in(30) {
        blocks.push(start_up);
    }
    for each in &contour.moves {
        blocks.push(block(each));
    }
    change_codes(&mut blocks, side, dice, reach);
    if !dice.once_in(12) {
        let last = contour.moves.last().map_or(contour.start, |last| last.end);
        let away = [last[0] + dice.between(-6, 6) * 700, last[1] + dice.between(-6, 6) * 700];
        let off = Some(Compensation::Off);
        if dice.once_in(4) {
            blocks.push(Block { compensation: off, ..Block::empty() });
            blocks.push(line(away));
        } else {
            blocks.push(Block { compensation: off, rapid: dice.once_in(2), ..line(away) });
        }
    }
    blocks
}

/// A radius that fits exactly as often as not: the size of a move, half of it, or any.
fn tool_radius(moves: &[Move], dice: &mut Dice) -> i64 {
    let sizes: Vec<i64> = moves.iter().map(|each| each.size.max(1)).collect();
    let size = dice.pick(&sizes);
    match dice.below(8) {
        0 => size,
        1 => size / 2,
        2 => size / 4,
        3 => dice.pick(&[0, 1, 500, 1000, 800]),
        _ => dice.between(1, (size / 3).max(2)),
    }
}

/// Changes of side, the same code again, M96 and M97, and cancels inside the contour.
fn change_codes(blocks: &mut [Block<Rational>], side: Side, dice: &mut Dice, reach: Reach) {
    let first = blocks.len().min(3);
    let mut current = side;
    for block in &mut blocks[first..] {
        if dice.once_in(9) {
            current = current.other();
            block.compensation = Some(Compensation::On(current));
        } else if dice.once_in(25) {
            block.compensation = Some(Compensation::On(current));
        } else if dice.once_in(40) {
            block.compensation = Some(Compensation::Off);
        }
        if reach.corner_codes && dice.once_in(4) {
            use radcomp_spec::OuterCorner::{Arc, Intersection};
            block.corner = Some(dice.pick(&[Arc, Intersection]));
        }
        if dice.once_in(80) {
            block.radius = Some(thousandths(dice.between(1, 900)));
        }
    }
}

fn line(end: Whole) -> Block<Rational> {
    Block::moving(Movement::Line { end: point(end) })
}

fn point(whole: Whole) -> [Rational; 2] {
    whole.map(thousandths)
}

fn block(each: &Move) -> Block<Rational> {
    let end = point(each.end);
    Block::moving(match each.shape {
        MoveShape::Line => Movement::Line { end },
        MoveShape::Centre { from_start, direction } => {
            Movement::Arc { end, centre: Centre::FromStart(point(from_start)), direction }
        }
        MoveShape::Radius { radius, direction } => {
            Movement::Arc { end, centre: Centre::Radius(thousandths(radius)), direction }
        }
    })
}
