//! Witnesses of an answer on the exact branches whose points lie farther off than δ.

use radcomp_model::Run;
use radcomp_spec::{Block, Segment};
use rug::Rational;

use super::input::{self, Place};
use super::{Search, Witness};
use crate::judge::{Difference, Divergence, Shape, Stroke};

/// How often an input is improved before the search is given up.
const MOST_ROUNDS: usize = 12;
/// The parts of the band that are searched, one after the other.
const NARROWER: [f64; 3] = [1.0, 1.0 / 32.0, 1.0 / 1024.0];
/// The shares of the band that neighbours stand off.
const SHARES: [f64; 2] = [0.5, -0.5];
/// A point that is farther off than so many bands is not looked for, except at the end of a wedge a kilometre long.
const FARTHEST: f64 = 1e9;
/// How often a step that does not help is halved.
const HALVINGS: usize = 4;
/// How often the numbers that have reached the edge of the band are set aside in one step.
const MOST_PASSES: usize = 4;
/// The share of the band that tells how far a number moves the point.
const PROBE: f64 = 1.0 / 16.0;

/// A number, how far it stands from the program's, and how the point follows it, per millimetre.
struct Lever {
    place: Place,
    at: f64,
    pull: [f64; 2],
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
        if !can_close(&self.levers(self.blocks, &divergence)?, gap, self.beta) {
            return None;
        }
        // What lies within a part of the band lies within it; where the point follows unevenly, small steps find it.
        NARROWER.iter().find_map(|share| {
            let narrower = Search { beta: self.beta * share, ..*self };
            narrower.improved(self.blocks.to_vec(), divergence.clone())
        })
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
        for _ in 0..MOST_ROUNDS {
            let gap = gap(&divergence)?;
            let levers = self.levers(&best, &divergence)?;
            if !can_close(&levers, gap, self.beta) {
                return None;
            }
            let mut improved: Option<(Vec<Block<Rational>>, Divergence)> = None;
            for group in groups(&levers, divergence.block) {
                let mut step = steps(&group, gap, self.beta);
                for _ in 0..HALVINGS {
                    let input = self.stepped(&best, &group, &step)?;
                    let Some(left) = self.parting(&input)? else { return Some(self.nearest(input, &[])) };
                    if is_nearer(&left, improved.as_ref().map_or(&divergence, |(_, known)| known)) {
                        improved = Some((input, left));
                        break;
                    }
                    // A step may lead to an alarm, or too far.
                    step.iter_mut().for_each(|step| *step /= 2.0);
                }
            }
            (best, divergence) = improved?;
        }
        None
    }

    /// The numbers that move the divergent point.
    fn levers(&self, best: &[Block<Rational>], divergence: &Divergence) -> Option<Vec<Lever>> {
        let aim = aim(divergence.expected.as_ref()?, divergence);
        let mut levers = Vec::new();
        for index in input::near(best, divergence.block) {
            for number in 0..input::numbers(&best[index]) {
                let place = (index, number);
                let now = input::number_of(best, place);
                let at = (&now - input::number_of(self.blocks, place)).to_f64();
                // Toward the program's own number, so that the probe stays within the band.
                let probe = if at > 0.0 { -PROBE * self.beta } else { PROBE * self.beta };
                let moved = input::with(best, place, &(now + Rational::from_f64(probe)?));
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
            input = input::with(&input, lever.place, &(home + off));
        }
        Some(input)
    }
}

/// Whether all the numbers together can close half of the gap, as far as the point follows them evenly.
fn can_close(levers: &[Lever], gap: [f64; 2], beta: f64) -> bool {
    let length = gap[0].hypot(gap[1]);
    let pulls = levers.iter().map(|lever| (lever.pull[0] * gap[0] + lever.pull[1] * gap[1]).abs() * beta);
    2.0 * pulls.sum::<f64>() >= length / 2.0 * length
}

/// The numbers that are moved together: all of them; then fewer, since a number may also belong to another junction that
/// stands on a decision and must stay.
fn groups(levers: &[Lever], block: usize) -> Vec<Vec<&Lever>> {
    let mut indices: Vec<usize> = levers.iter().map(|lever| lever.place.0).collect();
    indices.dedup();
    let only = |keep: &dyn Fn(&Lever) -> bool| levers.iter().filter(|lever| keep(lever)).collect::<Vec<_>>();
    let mut groups = vec![only(&|_| true), only(&|lever| lever.place.0 <= block)];
    groups.extend(indices.iter().map(|index| only(&|lever| lever.place.0 == *index)));
    groups.extend(levers.iter().map(|lever| vec![lever]));
    groups.retain(|group| !group.is_empty());
    groups
}

/// The smallest steps of the levers that close the gap: numbers at the edge of the band are held there, and the others
/// take over what they cannot do.
fn steps(levers: &[&Lever], gap: [f64; 2], beta: f64) -> Vec<f64> {
    let mut steps = vec![0.0; levers.len()];
    let mut free = vec![true; levers.len()];
    for _ in 0..MOST_PASSES {
        let mut left = gap;
        let (mut aa, mut ab, mut bb) = (0.0, 0.0, 0.0);
        for ((lever, step), free) in levers.iter().zip(&steps).zip(&free) {
            let [a, b] = lever.pull;
            if *free {
                (aa, ab, bb) = (aa + a * a, ab + a * b, bb + b * b);
            } else {
                left = [left[0] - a * step, left[1] - b * step];
            }
        }
        // Points that can move along one line only leave the matrix singular: a share of its trace keeps it solvable.
        let lift = (aa + bb) * 1e-12;
        let (aa, bb) = (aa + lift, bb + lift);
        let determinant = aa * bb - ab * ab;
        if determinant <= 0.0 {
            break;
        }
        let dual = [(bb * left[0] - ab * left[1]) / determinant, (aa * left[1] - ab * left[0]) / determinant];
        let mut held = false;
        for ((lever, step), free) in levers.iter().zip(&mut steps).zip(&mut free) {
            if !*free {
                continue;
            }
            let wanted = lever.pull[0] * dual[0] + lever.pull[1] * dual[1];
            *step = wanted.clamp(-beta - lever.at, beta - lever.at);
            if *step != wanted {
                *free = false;
                held = true;
            }
        }
        if !held {
            break;
        }
    }
    steps
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
