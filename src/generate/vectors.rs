//! Vectors that the program gives: G38 and G39, and I, J, K beside compensation codes.

use radcomp_spec::{Block, Compensation, Movement};
use rug::Rational;

use super::contour::{DIRECTIONS, symmetric};
use super::dice::Dice;
use super::features::toward;
use super::{Reach, thousandths};

/// Gives vectors where the profile has words for them: at corners, and beside the codes that start up, change the side and
/// cancel.
pub(super) fn give(blocks: &mut Vec<Block<Rational>>, dice: &mut Dice, reach: Reach) {
    let plain = std::mem::take(blocks);
    let mut position = [Rational::new(), Rational::new()];
    // A side is in force, and a block has moved since it came.
    let (mut on, mut started) = (false, false);
    for mut block in plain {
        let codes = reach.vector_codes();
        // Before the start-up block they are an alarm.
        if codes && dice.once_in(if started { 6 } else { 60 }) {
            blocks.push(corner(&block, &position, dice));
        }
        let line = match &block.movement {
            Movement::Line { end } => Some(end.clone()),
            _ => None,
        };
        let moves = line.as_ref().is_some_and(|end| *end != position);
        if codes && started && block.compensation.is_none() && block.radius.is_none() && dice.once_in(8) {
            if let Some(end) = line {
                block.movement = Movement::HeldVector { end };
            }
        } else if moves || (block.movement == Movement::None && block.compensation == Some(Compensation::Off)) {
            let has_meaning = match block.compensation {
                Some(Compensation::On(_)) if started => reach.vectors_in_mode(),
                Some(Compensation::On(_)) => reach.vectors_at_start_up(),
                Some(Compensation::Off) => reach.vectors_at_cancel(),
                None => false,
            };
            if has_meaning && dice.once_in(2) {
                block.vector = Some(direction(&block, &position, dice));
            }
        }
        on = block.compensation.map_or(on, |code| code != Compensation::Off);
        started = on && (started || moves || matches!(block.movement, Movement::Arc { .. }));
        if let Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } = &block.movement {
            position = end.clone();
        }
        blocks.push(block);
    }
}

/// A vector block without a move of the program, most often in the direction of the next block.
fn corner(next: &Block<Rational>, position: &[Rational; 2], dice: &mut Dice) -> Block<Rational> {
    let vector = direction(next, position, dice);
    Block::moving(match dice.below(4) {
        0 | 1 => Movement::CornerArc { vector: None },
        2 => Movement::CornerArc { vector: Some(vector) },
        _ => Movement::NewVector { vector },
    })
}

/// A direction: that of a block, opposite to it, at right angles to it, or one with a whole length.
fn direction(block: &Block<Rational>, position: &[Rational; 2], dice: &mut Dice) -> [Rational; 2] {
    let [a, b] = toward(block, position);
    let chosen = match dice.below(8) {
        0..=2 => [a, b],
        3 => [-a, -b],
        4 => [-b, a],
        _ => {
            let (vector, _) = dice.pick(&DIRECTIONS);
            symmetric(vector, dice).map(|component| thousandths(component * 1000))
        }
    };
    // A move of no length has no direction.
    if chosen.iter().all(Rational::is_zero) { [thousandths(1000), Rational::new()] } else { chosen }
}
