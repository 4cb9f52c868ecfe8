//! Smaller programs that fail in the same way.

use std::cell::Cell;

use radcomp_spec::{Block, Centre, Movement};
use rug::Rational;

/// The most programs that one minimisation tries.
const MOST_TRIALS: usize = 3000;
/// The most numbers of one block: those of an arc, of a vector beside its code, and the radius.
const MOST_NUMBERS: usize = 7;

/// Shrinks a program while `fails` holds: blocks dropped, codes removed, coordinates rounded to fewer decimals, the
/// contour moved to the origin. Answers the smallest one found; `fails` holds for it if it held for `blocks`.
pub fn minimise(blocks: &[Block<Rational>], mut fails: impl FnMut(&[Block<Rational>]) -> bool) -> Vec<Block<Rational>> {
    let mut best = blocks.to_vec();
    let mut trials = 0;
    let mut attempt = |best: &mut Vec<Block<Rational>>, candidate: Vec<Block<Rational>>| {
        if trials >= MOST_TRIALS || candidate == *best {
            return false;
        }
        trials += 1;
        let smaller = fails(&candidate);
        if smaller {
            *best = candidate;
        }
        smaller
    };
    loop {
        let mut changed = false;
        changed |= drop_blocks(&mut best, &mut attempt);
        for transform in [without_codes, straightened] {
            for index in 0..best.len() {
                if let Some(block) = transform(&best[index]) {
                    let mut candidate = best.clone();
                    candidate[index] = block;
                    changed |= attempt(&mut best, candidate);
                }
            }
        }
        if !changed {
            break;
        }
    }
    let moved = to_origin(&best);
    attempt(&mut best, moved);
    for decimals in [0_u32, 1, 2] {
        let rounded: Vec<_> = best.iter().map(|block| map_numbers(block, &|value| round(value, decimals))).collect();
        if attempt(&mut best, rounded) {
            break;
        }
        for index in 0..best.len() {
            let mut candidate = best.clone();
            candidate[index] = map_numbers(&candidate[index], &|value| round(value, decimals));
            if attempt(&mut best, candidate) {
                continue;
            }
            for number in 0..MOST_NUMBERS {
                let mut candidate = best.clone();
                candidate[index] = with_rounded(&best[index], number, decimals);
                attempt(&mut best, candidate);
            }
        }
    }
    drop_blocks(&mut best, &mut attempt);
    best
}

/// Drops runs of blocks, long ones first.
fn drop_blocks(
    best: &mut Vec<Block<Rational>>,
    attempt: &mut impl FnMut(&mut Vec<Block<Rational>>, Vec<Block<Rational>>) -> bool,
) -> bool {
    let mut changed = false;
    let mut length = best.len().div_ceil(2).max(1);
    loop {
        let mut start = 0;
        while start < best.len() {
            let end = (start + length).min(best.len());
            let mut candidate = best.clone();
            candidate.drain(start..end);
            if attempt(best, candidate) {
                changed = true;
            } else {
                start += 1;
            }
        }
        if length == 1 {
            return changed;
        }
        length /= 2;
    }
}

fn without_codes(block: &Block<Rational>) -> Option<Block<Rational>> {
    let plain = Block {
        compensation: None,
        vector: None,
        corner: None,
        approach: None,
        rapid: false,
        stops_look_ahead: false,
        not_in_mode: None,
        ..block.clone()
    };
    (plain != *block).then_some(plain)
}

fn straightened(block: &Block<Rational>) -> Option<Block<Rational>> {
    match &block.movement {
        Movement::Arc { end, .. } | Movement::HeldVector { end } => {
            Some(Block { movement: Movement::Line { end: end.clone() }, ..block.clone() })
        }
        _ => None,
    }
}

/// The same program with its last end point of the approach at the origin.
fn to_origin(blocks: &[Block<Rational>]) -> Vec<Block<Rational>> {
    let origin = blocks.iter().find_map(|block| match &block.movement {
        Movement::Line { end } | Movement::Arc { end, .. } | Movement::HeldVector { end } => Some(end.clone()),
        Movement::None | Movement::Dummy { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. } => None,
    });
    let Some(origin) = origin else { return blocks.to_vec() };
    let shift = |end: &[Rational; 2]| [Rational::from(&end[0] - &origin[0]), Rational::from(&end[1] - &origin[1])];
    blocks
        .iter()
        .map(|block| {
            let movement = match &block.movement {
                Movement::Line { end } => Movement::Line { end: shift(end) },
                Movement::HeldVector { end } => Movement::HeldVector { end: shift(end) },
                Movement::Arc { end, centre, direction } => {
                    Movement::Arc { end: shift(end), centre: centre.clone(), direction: *direction }
                }
                other => other.clone(),
            };
            Block { movement, ..block.clone() }
        })
        .collect()
}

fn round(value: &Rational, decimals: u32) -> Rational {
    let scale = 10_u32.pow(decimals);
    let scaled = Rational::from(value * scale);
    scaled.round() / scale
}

/// The block with one of its numbers rounded.
fn with_rounded(block: &Block<Rational>, number: usize, decimals: u32) -> Block<Rational> {
    let seen = Cell::new(0);
    map_numbers(block, &|value| {
        let here = seen.replace(seen.get() + 1);
        if here == number { round(value, decimals) } else { value.clone() }
    })
}

fn map_numbers(block: &Block<Rational>, map: &impl Fn(&Rational) -> Rational) -> Block<Rational> {
    let point = |[a, b]: &[Rational; 2]| [map(a), map(b)];
    let movement = match &block.movement {
        Movement::None => Movement::None,
        Movement::Line { end } => Movement::Line { end: point(end) },
        Movement::Dummy { vector } => Movement::Dummy { vector: point(vector) },
        Movement::HeldVector { end } => Movement::HeldVector { end: point(end) },
        Movement::NewVector { vector } => Movement::NewVector { vector: point(vector) },
        Movement::CornerArc { vector } => Movement::CornerArc { vector: vector.as_ref().map(point) },
        Movement::Arc { end, centre, direction } => Movement::Arc {
            end: point(end),
            centre: match centre {
                Centre::FromStart(vector) => Centre::FromStart(point(vector)),
                Centre::Radius(radius) => Centre::Radius(map(radius)),
            },
            direction: *direction,
        },
    };
    let vector = block.vector.as_ref().map(point);
    Block { movement, vector, radius: block.radius.as_ref().map(map), ..block.clone() }
}
