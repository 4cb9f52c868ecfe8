//! Blocks without movement, dummy blocks, and the step of one least increment to either side.

use radcomp_spec::{Block, Centre, Direction, Movement};
use rug::Rational;

use super::dice::Dice;
use super::{Reach, thousandths};

/// Puts blocks without movement and dummy blocks before one block in so many.
pub(super) fn decorate(blocks: &mut Vec<Block<Rational>>, one_in: usize, dice: &mut Dice, reach: Reach) {
    let plain = std::mem::take(blocks);
    let mut position = [Rational::new(), Rational::new()];
    for block in plain {
        if !blocks.is_empty() && dice.once_in(one_in) {
            // Most runs are at the limit or one past it.
            let run = match reach.non_moving_allowed().map(i64::from) {
                Some(allowed) => dice.pick(&[1, allowed, allowed, allowed + 1, allowed + 2]),
                None => dice.pick(&[1, 2, 4, 9, 12]),
            };
            let dummy_at = (reach.dummies() && dice.once_in(2)).then(|| dice.between(0, run));
            for index in 0..run {
                if dummy_at == Some(index) {
                    blocks.push(dummy(&block, &position, dice));
                }
                blocks.push(still(&position, dice, reach));
            }
        }
        if let Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } = &block.movement {
            position = end.clone();
        }
        blocks.push(block);
    }
}

/// A block without movement, or a move of no length, or a stop.
fn still(position: &[Rational; 2], dice: &mut Dice, reach: Reach) -> Block<Rational> {
    let block = if dice.once_in(6) { Block::moving(Movement::Line { end: position.clone() }) } else { Block::empty() };
    Block { stops_look_ahead: reach.stops() && dice.once_in(12), ..block }
}

/// The dummy that stands for the next block; now and then a wrong one.
fn dummy(next: &Block<Rational>, position: &[Rational; 2], dice: &mut Dice) -> Block<Rational> {
    let mut vector = toward(next, position);
    if dice.once_in(8) {
        vector = vector.map(|value| -value);
    }
    Block::moving(Movement::Dummy { vector })
}

/// A vector along a block at its start; for an arc with R, and a block that does not move, any.
pub(super) fn toward(next: &Block<Rational>, position: &[Rational; 2]) -> [Rational; 2] {
    match &next.movement {
        Movement::Line { end } | Movement::HeldVector { end } => {
            [Rational::from(&end[0] - &position[0]), Rational::from(&end[1] - &position[1])]
        }
        Movement::Arc { centre: Centre::FromStart([a, b]), direction, .. } => match direction {
            // [TRC-DUMMY-03]
            Direction::Counterclockwise => [b.clone(), Rational::from(-a)],
            Direction::Clockwise => [Rational::from(-b), a.clone()],
        },
        _ => [thousandths(1000), thousandths(0)],
    }
}

/// Moves one number of one block by one least increment.
pub(super) fn nudge(blocks: &mut [Block<Rational>], dice: &mut Dice, by: i64) {
    let moving: Vec<usize> = (0..blocks.len())
        .filter(|&index| matches!(blocks[index].movement, Movement::Line { .. } | Movement::Arc { .. }))
        .collect();
    if moving.is_empty() {
        return;
    }
    let block = &mut blocks[dice.pick(&moving)];
    let axis = dice.below(2);
    let of_centre = dice.once_in(3);
    match &mut block.movement {
        Movement::Line { end } => end[axis] += thousandths(by),
        Movement::Arc { centre: Centre::FromStart(vector), .. } if of_centre => vector[axis] += thousandths(by),
        Movement::Arc { centre: Centre::Radius(radius), .. } if of_centre => *radius += thousandths(by),
        Movement::Arc { end, .. } => end[axis] += thousandths(by),
        _ => {}
    }
}
