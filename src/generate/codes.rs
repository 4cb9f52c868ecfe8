//! Compensation codes around a contour.

use radcomp_spec::{Approach, Block, Centre, Compensation, Movement, Side};
use rug::Rational;

use super::contour::{Contour, Move, MoveShape, Whole};
use super::dice::Dice;
use super::{Reach, thousandths};

/// Approach, start-up, the contour, cancel, and a move away.
pub(super) fn with_codes(contour: Contour, dice: &mut Dice, reach: Reach) -> Vec<Block<Rational>> {
    let side = dice.pick(&[Side::Left, Side::Right]);
    let radius = tool_radius(&contour.moves, dice);
    let mut blocks = lead_in(&contour, side, radius, dice, reach);
    blocks.extend(contour.moves.iter().map(block));
    change_codes(&mut blocks, side, radius, dice, reach);
    if !dice.once_in(12) {
        lead_out(&mut blocks, contour.end(), side, dice);
    }
    blocks
}

/// Approach and start-up.
pub(super) fn lead_in(
    contour: &Contour,
    side: Side,
    radius: i64,
    dice: &mut Dice,
    reach: Reach,
) -> Vec<Block<Rational>> {
    let mut blocks = Vec::with_capacity(contour.moves.len() + 8);
    let approach = match &contour.entry {
        Some((from, _)) => *from,
        None => approach(contour.start, radius, dice, reach),
    };
    blocks.push(Block { rapid: dice.once_in(2), ..line(approach) });

    let negative = dice.once_in(if reach.negative_radii() { 4 } else { 100 });
    let codes = Block {
        compensation: Some(Compensation::On(side)),
        radius: Some(thousandths(if negative { -radius } else { radius })),
        ..Block::empty()
    };
    let mut start_up = match &contour.entry {
        Some((_, arc)) => block(arc),
        None => Block { rapid: dice.once_in(6), ..line(contour.start) },
    };
    if dice.once_in(3) {
        if dice.once_in(6) {
            // Of two codes the last one counts.
            blocks.push(Block { compensation: Some(Compensation::On(side.other())), ..codes.clone() });
        }
        blocks.push(codes);
    } else {
        start_up = Block { movement: start_up.movement, rapid: start_up.rapid, ..codes };
    }
    if !dice.once_in(30) {
        blocks.push(start_up);
    }
    blocks
}

/// Cancel, and a move away; now and then a code that takes the cancel back.
pub(super) fn lead_out(blocks: &mut Vec<Block<Rational>>, end: Whole, side: Side, dice: &mut Dice) {
    let away = [end[0] + dice.between(-6, 6) * 700, end[1] + dice.between(-6, 6) * 700];
    let off = Some(Compensation::Off);
    if dice.once_in(4) {
        blocks.push(Block { compensation: off, ..Block::empty() });
        if dice.once_in(6) {
            blocks.push(Block { compensation: Some(Compensation::On(side)), ..Block::empty() });
        }
        blocks.push(line(away));
    } else {
        blocks.push(Block { compensation: off, rapid: dice.once_in(2), ..line(away) });
    }
}

/// Where the tool comes from: somewhere near, or exactly one radius away where that decides something.
fn approach(start: Whole, radius: i64, dice: &mut Dice, reach: Reach) -> Whole {
    if reach.asks_entry_length() && dice.once_in(8) {
        return [start[0] - radius - dice.between(-1, 1), start[1]];
    }
    [start[0] - dice.between(-8, 8) * 500, start[1] - dice.between(-8, 8) * 500]
}

/// A radius that fits exactly as often as not: the size of a move, half of it, or any.
pub(super) fn tool_radius(moves: &[Move], dice: &mut Dice) -> i64 {
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

/// Changes of side, the same code again, cancels inside the contour and new starts after them, corner codes, offsets, and
/// codes that are not for offset mode.
fn change_codes(blocks: &mut Vec<Block<Rational>>, side: Side, radius: i64, dice: &mut Dice, reach: Reach) {
    let first = blocks.len().min(3);
    let alarms = reach.not_in_mode();
    let (mut current, mut on) = (side, true);
    for block in &mut blocks[first..] {
        if dice.once_in(reach.side_change_one_in()) {
            current = current.other();
            (block.compensation, on) = (Some(Compensation::On(current)), true);
        } else if dice.once_in(reach.same_code_one_in()) || (!on && dice.once_in(2)) {
            (block.compensation, on) = (Some(Compensation::On(current)), true);
        } else if dice.once_in(40) {
            (block.compensation, on) = (Some(Compensation::Off), false);
        }
        if !reach.corners().is_empty() && dice.once_in(4) {
            block.corner = Some(dice.pick(reach.corners()));
        }
        if reach.approaches() && dice.once_in(5) {
            block.approach = Some(dice.pick(&[Approach::Norm, Approach::Kont]));
        }
        if reach.changes_offset() && dice.once_in(6) {
            let any = dice.between(1, radius.max(2));
            let value = dice.pick(&[radius / 2, radius + 1, radius * 2, any]);
            block.radius = Some(thousandths(if reach.negative_radii() && dice.once_in(12) { -value } else { value }));
        } else if dice.once_in(80) {
            block.radius = Some(thousandths(dice.between(1, 900)));
        } else if reach.negative_radii() && dice.once_in(25) {
            block.radius = Some(thousandths(if dice.once_in(2) { radius } else { -radius }));
        }
        block.stops_look_ahead = reach.stops() && dice.once_in(25);
    }
    if !alarms.is_empty() && dice.once_in(20) {
        // In mode, as far as the blocks before tell.
        let place = dice.between(first as i64, blocks.len() as i64) as usize;
        let last = blocks[..place].iter().filter_map(|block| block.compensation).next_back();
        if matches!(last, Some(Compensation::On(_))) {
            blocks.insert(place, Block { not_in_mode: Some(dice.pick(&alarms)), ..Block::empty() });
        }
    }
}

pub(super) fn line(end: Whole) -> Block<Rational> {
    Block::moving(Movement::Line { end: point(end) })
}

fn point(whole: Whole) -> [Rational; 2] {
    whole.map(thousandths)
}

pub(super) fn block(each: &Move) -> Block<Rational> {
    let end = point(each.end);
    let movement = match each.shape {
        MoveShape::Line => Movement::Line { end },
        MoveShape::Centre { from_start, direction } => {
            Movement::Arc { end, centre: Centre::FromStart(point(from_start)), direction }
        }
        MoveShape::Radius { radius, direction } => {
            Movement::Arc { end, centre: Centre::Radius(thousandths(radius)), direction }
        }
    };
    Block { rapid: each.rapid, ..Block::moving(movement) }
}
