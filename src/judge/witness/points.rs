//! Witnesses of an answer on the exact branches whose points lie farther off than δ.

use radcomp_model::Run;
use radcomp_spec::{Block, Segment};
use rug::Rational;

use super::input;
use super::steps::{Lever, can_close, groups, steps};
use super::{Search, Ties, Witness};
use crate::judge::{Difference, Divergence, Shape, Stroke};

/// How often an input is improved before the search is given up.
const MOST_ROUNDS: usize = 12;
/// The parts of the band that are searched, one after the other.
const NARROWER: [f64; 3] = [1.0, 1.0 / 32.0, 1.0 / 1024.0];
/// The shares of the band that neighbours stand off.
const SHARES: [f64; 2] = [0.5, -0.5];
/// A point that is farther off than so many bands is not looked for, except at the end of a wedge a kilometre long.
const FARTHEST: f64 = 1e9;
/// No smaller share of a step is tried first.
const LEAST_SHARE: f64 = 1.0 / 8.0;
/// How many shares of a step are tried.
const MOST_SHARES: usize = 9;
/// The share of the band that tells how far a number moves the point, and later the share of the last step: the common
/// point of circles that all but touch follows a number with a square root, as steeply as they are near.
const PROBE: f64 = 1.0 / 16.0;

/// An input whose divergent point is nearer to where the device has it.
struct Improved {
    input: Vec<Block<Rational>>,
    divergence: Divergence,
    /// The largest change of a number.
    longest: f64,
    /// The share of the steps that led here.
    share: f64,
}

/// Where a step leads.
enum Along {
    Witness(Vec<Block<Rational>>),
    Nearer(Box<Improved>),
    Nowhere,
}

impl Search<'_> {
    /// Looks for an input within the band, number by number, whose exact outcome is the answer. `exact` is the outcome of
    /// the program itself.
    ///
    /// Gauss and Newton's method: the smallest change of the numbers around it that brings the first divergent point to
    /// where the device has it, no number leaving the band; then the next point, until the paths agree.
    pub(in crate::judge) fn for_points(&self, exact: &Run) -> Option<Witness> {
        let divergence = self.divergence(exact)?;
        let gap = gap(&divergence)?;
        // The vector of a wedge follows its angle with the square of its length, as the centre of a large circle does.
        let [a, b] = aim(&divergence.expected?, &divergence);
        if gap[0].hypot(gap[1]) > self.beta * (a * a + b * b).max(FARTHEST) {
            return None;
        }
        if !can_close(&self.levers(self.blocks, &divergence, PROBE * self.beta)?, gap, self.beta) {
            return None;
        }
        // What lies within a part of the band lies within it; where the point follows unevenly, small steps find it.
        let narrower = |ties| {
            NARROWER.iter().find_map(|share| {
                let narrower = Search { beta: self.beta * share, ties, ..*self };
                narrower.improved(self.blocks.to_vec(), divergence.clone())
            })
        };
        narrower(Ties::All).or_else(|| input::has_far_ties(self.blocks).then(|| narrower(Ties::Row)).flatten())
    }

    /// Looks for such an input from others than the program: one of its numbers moved to the edge of the band. They
    /// take branches that have no outcome at the program itself.
    pub(in crate::judge) fn beside_the_program(&self, divergence: &Divergence) -> Option<Witness> {
        let beta = Rational::from_f64(self.beta)?;
        let mut best: Option<(Vec<Block<Rational>>, Divergence)> = None;
        for index in input::near(self.blocks, divergence.block) {
            for number in 0..input::numbers(&self.blocks[index]) {
                for share in SHARES {
                    let off = Rational::from_f64(share)? * &beta;
                    let value = input::number_of(self.blocks, (index, number)) + off;
                    let start = input::with_alone(self.blocks, (index, number), value);
                    let Some(left) = self.parting(&start)? else { return Some(self.nearest(start, &[])) };
                    if is_nearer(&left, best.as_ref().map_or(divergence, |(_, known)| known)) {
                        best = Some((start, left));
                    }
                }
            }
        }
        let (start, left) = best?;
        self.improved(start, left)
    }

    fn improved(&self, mut best: Vec<Block<Rational>>, mut divergence: Divergence) -> Option<Witness> {
        let mut probe = PROBE * self.beta;
        for _ in 0..MOST_ROUNDS {
            let gap = gap(&divergence)?;
            let levers = self.levers(&best, &divergence, probe)?;
            if !can_close(&levers, gap, self.beta) {
                return None;
            }
            let mut improved: Option<Improved> = None;
            for group in groups(&levers, divergence.block) {
                let known = improved.as_ref().map_or(&divergence, |improved| &improved.divergence);
                match self.along(&best, &group, &steps(&group, gap, self.beta), known)? {
                    Along::Witness(input) => return Some(self.nearest(input, &[])),
                    Along::Nearer(nearer) => improved = Some(*nearer),
                    Along::Nowhere => {}
                }
            }
            let improved = improved?;
            probe = probe.min(PROBE * improved.longest);
            (best, divergence) = (improved.input, improved.divergence);
        }
        None
    }

    /// Goes along these steps, halving them until the point comes nearer than it is known to come; then farther, while the
    /// steps that lead too far are not met. None if an outcome takes too many bits.
    fn along(&self, from: &[Block<Rational>], levers: &[&Lever], steps: &[f64], known: &Divergence) -> Option<Along> {
        let mut nearest: Option<Improved> = None;
        // Steps may lead to an alarm, or too far.
        let (mut share, mut too_far) = (1.0, None);
        for _ in 0..MOST_SHARES {
            let step: Vec<f64> = steps.iter().map(|step| share * step).collect();
            let input = self.stepped(from, levers, &step)?;
            let Some(left) = self.parting(&input)? else { return Some(Along::Witness(input)) };
            if is_nearer(&left, nearest.as_ref().map_or(known, |nearest| &nearest.divergence)) {
                let longest = step.iter().fold(0.0_f64, |longest, step| longest.max(step.abs()));
                nearest = Some(Improved { input, divergence: left, longest, share });
            } else {
                too_far = Some(share);
            }
            share = match (&nearest, too_far) {
                (Some(nearest), Some(too_far)) => f64::midpoint(nearest.share, too_far),
                (Some(_), None) => break,
                (None, _) if share <= LEAST_SHARE => break,
                (None, _) => share / 2.0,
            };
        }
        Some(nearest.map_or(Along::Nowhere, |nearer| Along::Nearer(Box::new(nearer))))
    }

    /// The numbers that move the divergent point.
    fn levers(&self, best: &[Block<Rational>], divergence: &Divergence, probe: f64) -> Option<Vec<Lever>> {
        let aim = aim(divergence.expected.as_ref()?, divergence);
        let mut levers = Vec::new();
        for index in input::near(best, divergence.block) {
            for number in 0..input::numbers(&best[index]) {
                let place = (index, number);
                let now = input::number_of(best, place);
                let at = (&now - input::number_of(self.blocks, place)).to_f64();
                // Toward the program's own number, so that the probe stays within the band.
                let probe = if at > 0.0 { -probe } else { probe };
                let moved = input::with(best, place, &(now + Rational::from_f64(probe)?), self.ties);
                // The probe may lead to an alarm before the point is reached.
                let outcome = self.outcome(&moved)?;
                let Some(reached) = nearest_point(&outcome, divergence, aim) else { continue };
                let pull = [(reached[0] - aim[0]) / probe, (reached[1] - aim[1]) / probe];
                if pull != [0.0, 0.0] {
                    levers.push(Lever { place, at, pull });
                }
            }
        }
        Some(levers)
    }

    /// The input with these numbers moved, each kept within the band.
    fn stepped(&self, best: &[Block<Rational>], levers: &[&Lever], steps: &[f64]) -> Option<Vec<Block<Rational>>> {
        let beta = Rational::from_f64(self.beta)?;
        let mut input = best.to_vec();
        for (lever, step) in levers.iter().zip(steps) {
            let home = input::number_of(self.blocks, lever.place);
            let off = input::number_of(best, lever.place) + Rational::from_f64(*step)? - &home;
            let off = off.clamp(&-beta.clone(), &beta);
            input = input::with(&input, lever.place, &(home + off), self.ties);
        }
        Some(input)
    }
}

/// How far the device's point lies from the outcome's, if it is a point that differs.
fn gap(divergence: &Divergence) -> Option<[f64; 2]> {
    let (expected, observed) = (divergence.expected?, divergence.observed?);
    let (from, to) = (aim(&expected, divergence), aim(&observed, divergence));
    match divergence.difference {
        Difference::End(_) | Difference::Centre(_) | Difference::Place(_) => Some([to[0] - from[0], to[1] - from[1]]),
        _ => None,
    }
}

/// The point of a stroke that differs: its centre, or its end.
fn aim(stroke: &Stroke, divergence: &Divergence) -> [f64; 2] {
    match (stroke.shape, &divergence.difference) {
        (Shape::Arc { centre, .. }, Difference::Centre(_)) => centre,
        _ => stroke.to,
    }
}

/// The point of the block's elements that stands for the divergent one: the nearest to it.
fn nearest_point(run: &Run, divergence: &Divergence, aim: [f64; 2]) -> Option<[f64; 2]> {
    let wants_centre = matches!(divergence.difference, Difference::Centre(_));
    let wants_place = matches!(divergence.difference, Difference::Place(_));
    let mut at = [0.0, 0.0];
    let mut nearest: Option<[f64; 2]> = None;
    for step in &run.steps {
        let point = match &step.segment {
            Segment::Arc { end, centre, .. } => {
                at = [end[0].to_f64(), end[1].to_f64()];
                if wants_centre { [centre[0].to_f64(), centre[1].to_f64()] } else { at }
            }
            Segment::Line { end } => {
                at = [end[0].to_f64(), end[1].to_f64()];
                at
            }
            Segment::Hold if wants_place => at,
            Segment::Hold => continue,
        };
        let off = |point: [f64; 2]| (point[0] - aim[0]).hypot(point[1] - aim[1]);
        if step.block == divergence.block && nearest.is_none_or(|known| off(point) < off(known)) {
            nearest = Some(point);
        }
    }
    nearest
}

/// Whether the first divergence has moved on, or become smaller.
fn is_nearer(now: &Divergence, before: &Divergence) -> bool {
    let off = |divergence: &Divergence| match divergence.difference {
        Difference::End(off) | Difference::Centre(off) | Difference::Place(off) => Some(off),
        _ => None,
    };
    match (off(now), off(before)) {
        (Some(now_off), Some(before_off)) => {
            now.block > before.block || (now.block == before.block && now_off < before_off)
        }
        _ => false,
    }
}
