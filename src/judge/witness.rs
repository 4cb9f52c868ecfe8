//! Witnesses: inputs within the band whose exact outcome is the device's answer.
//!
//! Where a vector lies far from its corner, or two curves meet at a grazing angle, a change of the input far below the
//! least increment moves it visibly. A device may stand on any such outcome; the judge says so only with the input in
//! hand.

use radcomp_model::{Run, run};
use radcomp_spec::{Block, Centre, Movement, Parameters, Segment};
use rug::Rational;

use super::compare::{self, Difference, Divergence};
use super::fork::Flip;
use crate::device::Answer;

/// An input whose exact outcome is the device's answer.
#[derive(Clone, Debug)]
pub struct Witness {
    /// The input.
    pub input: Vec<Block<Rational>>,
    /// The largest change of one number from the program's, in millimetres: the smallest band under which this input
    /// is a witness.
    pub beta: f64,
    /// The decisions that the device took another way; none if only points moved.
    pub flips: Vec<Flip>,
}

impl Witness {
    fn new(blocks: &[Block<Rational>], input: Vec<Block<Rational>>, flips: Vec<Flip>) -> Self {
        let mut beta = Rational::new();
        for (before, after) in blocks.iter().zip(&input) {
            for number in 0..numbers(before) {
                let change = (number_of(after, number) - number_of(before, number)).abs();
                if change > beta {
                    beta = change;
                }
            }
        }
        Witness { input, beta: beta.to_f64(), flips }
    }
}

/// How often a witness is improved before the search is given up.
const MOST_ROUNDS: usize = 6;
/// A point that is farther off than so many bands is not looked for: nothing but a wedge a kilometre long moves so far.
const FARTHEST: f64 = 1e9;
/// How many numbers are tried in a round.
const MOST_CANDIDATES: usize = 16;

/// The most inputs that are tried for a device that took other branches.
const MOST_NUDGES: usize = 600;
/// The shares of the band that numbers are moved by.
const SHARES: [f64; 4] = [1.0, 0.25, 1.0 / 64.0, 1.0 / 65536.0];

/// Looks for an input within `beta` of `blocks` whose exact outcome is the answer, the device having taken these
/// decisions another way: one number near them is moved, then two.
pub(crate) fn for_flips(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    answer: &Answer,
    flips: &[Flip],
    beta: f64,
    delta: f64,
) -> Option<Witness> {
    let beta = Rational::from_f64(beta)?;
    let mut places: Vec<(usize, usize)> = Vec::new();
    for flip in flips {
        for index in near(blocks, flip.block) {
            places.extend((0..numbers(&blocks[index])).map(|number| (index, number)));
        }
    }
    places.sort_unstable();
    places.dedup();
    let mut tried = 0;
    let mut matches = |input: &[Block<Rational>]| {
        tried += 1;
        let found = compare::divergence(&run(parameters, input), answer, delta).is_none();
        if found || tried < MOST_NUDGES { Ok(found) } else { Err(()) }
    };
    let steps: Vec<Rational> = SHARES
        .iter()
        .filter_map(|share| Some(Rational::from_f64(*share)? * &beta))
        .flat_map(|step| [step.clone(), -step])
        .collect();
    let moved = |from: &[Block<Rational>], (index, number): (usize, usize), step: &Rational| {
        with(from, index, number, number_of(&blocks[index], number) + step)
    };
    for step in &steps {
        for place in &places {
            let input = moved(blocks, *place, step);
            if matches(&input).ok()? {
                return Some(Witness::new(blocks, input, flips.to_vec()));
            }
        }
    }
    for step in &steps {
        for other_step in &steps {
            for (first, place) in places.iter().enumerate() {
                for other in &places[first + 1..] {
                    let input = moved(&moved(blocks, *place, step), *other, other_step);
                    if matches(&input).ok()? {
                        return Some(Witness::new(blocks, input, flips.to_vec()));
                    }
                }
            }
        }
    }
    None
}

/// Looks for an input within `beta` of `blocks`, number by number, whose exact outcome matches the answer to within
/// `delta`. `exact` is the outcome of `blocks` itself. The search moves one number at a time, the one that brings the
/// first divergent point nearest; it can miss a witness, never make one up.
pub(crate) fn for_points(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    exact: &Run,
    answer: &Answer,
    beta: f64,
    delta: f64,
) -> Option<Witness> {
    let reach = beta * FARTHEST;
    let beta = Rational::from_f64(beta)?;
    let mut best = blocks.to_vec();
    let mut outcome = exact.clone();
    for _ in 0..MOST_ROUNDS {
        let divergence = compare::divergence(&outcome, answer, delta)?;
        let Difference::End(off) = divergence.difference else { return None };
        if off > reach {
            return None;
        }
        let (expected, observed) = (divergence.expected?, divergence.observed?);
        let wanted = [observed.to[0] - expected.to[0], observed.to[1] - expected.to[1]];
        let mut candidates = Vec::new();
        for index in near(&best, divergence.block) {
            for number in 0..numbers(&best[index]) {
                let from = number_of(&blocks[index], number);
                let moved = with(&best, index, number, Rational::from(&from + &beta));
                // The step may lead to an alarm before the point is reached.
                let outcome = run(parameters, &moved);
                let Some(reached) = end_nearest(&outcome, divergence.block, expected.to) else { continue };
                let by = [reached[0] - expected.to[0], reached[1] - expected.to[1]];
                let square = by[0] * by[0] + by[1] * by[1];
                if square == 0.0 {
                    continue;
                }
                // How much of the step brings the point as near as this number can bring it.
                let share = ((wanted[0] * by[0] + wanted[1] * by[1]) / square).clamp(-1.0, 1.0);
                let left = (wanted[0] - share * by[0]).hypot(wanted[1] - share * by[1]);
                candidates.push((left, index, number, from, share));
            }
        }
        candidates.sort_by(|x, y| x.0.total_cmp(&y.0));
        let mut improved = None;
        for (_, index, number, from, share) in candidates.into_iter().take(MOST_CANDIDATES) {
            let step = Rational::from_f64(share)? * &beta;
            let moved = with(&best, index, number, from + step);
            let reached = run(parameters, &moved);
            match compare::divergence(&reached, answer, delta) {
                None => return Some(Witness::new(blocks, moved, Vec::new())),
                // A step to the other side may lead to an alarm, or leave the point where it was.
                Some(left) if is_nearer(&left, &divergence) => {
                    improved = Some((moved, reached));
                    break;
                }
                Some(_) => {}
            }
        }
        (best, outcome) = improved?;
    }
    None
}

/// Whether the first divergence has moved on, or become smaller.
fn is_nearer(now: &Divergence, before: &Divergence) -> bool {
    match (&now.difference, &before.difference) {
        (Difference::End(now_off), Difference::End(before_off)) => {
            now.block > before.block || (now.block == before.block && now_off < before_off)
        }
        _ => false,
    }
}

/// The blocks that a vector at this block's end depends on: the moving ones around it.
fn near(blocks: &[Block<Rational>], block: usize) -> Vec<usize> {
    let moving = |index: &usize| numbers(&blocks[*index]) > 0;
    let before = (0..=block.min(blocks.len().saturating_sub(1))).rev().filter(moving).take(3);
    let after = (block + 1..blocks.len()).filter(moving).take(2);
    before.chain(after).collect()
}

/// How many numbers a block moves by.
fn numbers(block: &Block<Rational>) -> usize {
    match &block.movement {
        Movement::None => 0,
        Movement::Line { .. } | Movement::Dummy { .. } => 2,
        Movement::Arc { centre: Centre::Radius(_), .. } => 3,
        Movement::Arc { centre: Centre::FromStart(_), .. } => 4,
    }
}

fn number_of(block: &Block<Rational>, number: usize) -> Rational {
    let mut copy = block.clone();
    place(&mut copy, number).cloned().unwrap_or_default()
}

fn place(block: &mut Block<Rational>, number: usize) -> Option<&mut Rational> {
    match (&mut block.movement, number) {
        (Movement::Line { end } | Movement::Arc { end, .. }, 0 | 1) => end.get_mut(number),
        (Movement::Dummy { vector }, 0 | 1) => vector.get_mut(number),
        (Movement::Arc { centre: Centre::FromStart(vector), .. }, 2 | 3) => vector.get_mut(number - 2),
        (Movement::Arc { centre: Centre::Radius(radius), .. }, 2) => Some(radius),
        _ => None,
    }
}

/// The blocks with one number replaced. Blocks that end at the same point keep ending at one point, so that a move of
/// no length and a full circle stay what they are.
fn with(blocks: &[Block<Rational>], index: usize, number: usize, value: Rational) -> Vec<Block<Rational>> {
    let mut moved = blocks.to_vec();
    let joint = if number < 2 { end_of(&blocks[index]) } else { None };
    for (other, block) in moved.iter_mut().enumerate() {
        let together = other == index || (joint.is_some() && end_of(block) == joint);
        if together && let Some(place) = place(block, number) {
            place.clone_from(&value);
        }
    }
    moved
}

fn end_of(block: &Block<Rational>) -> Option<[Rational; 2]> {
    match &block.movement {
        Movement::Line { end } | Movement::Arc { end, .. } => Some(end.clone()),
        Movement::None | Movement::Dummy { .. } => None,
    }
}

/// The end of the block's element that lies nearest to a point.
fn end_nearest(run: &Run, block: usize, point: [f64; 2]) -> Option<[f64; 2]> {
    let ends = run.steps.iter().filter(|step| step.block == block).filter_map(|step| match &step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => Some([end[0].to_f64(), end[1].to_f64()]),
        Segment::Hold => None,
    });
    let off = |end: &[f64; 2]| (end[0] - point[0]).hypot(end[1] - point[1]);
    ends.min_by(|x, y| off(x).total_cmp(&off(y)))
}
