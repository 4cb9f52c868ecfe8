//! Witnesses of an answer on other branches.

use radcomp_spec::Block;
use rug::Rational;

use super::input::{self, Place};
use super::{Search, Witness};
use crate::judge::Flip;

/// The most inputs that are tried.
const MOST_NUDGES: usize = 600;
/// The shares of the band that numbers are moved by.
const SHARES: [f64; 4] = [1.0, 0.25, 1.0 / 64.0, 1.0 / 65536.0];

impl Search<'_> {
    /// Looks for an input within the band whose exact outcome is the answer, the device having taken these decisions
    /// another way: one number near them is moved, then two.
    pub(in crate::judge) fn for_flips(&self, flips: &[Flip]) -> Option<Witness> {
        let beta = Rational::from_f64(self.beta)?;
        let mut places: Vec<Place> = Vec::new();
        for flip in flips {
            for index in input::near(self.blocks, flip.block) {
                places.extend((0..input::numbers(&self.blocks[index])).map(|number| (index, number)));
            }
        }
        places.sort_unstable();
        places.dedup();
        let steps: Vec<Rational> = SHARES
            .iter()
            .filter_map(|share| Some(Rational::from_f64(*share)? * &beta))
            .flat_map(|step| [step.clone(), -step])
            .collect();
        let moved = |from: &[Block<Rational>], place: Place, step: &Rational| {
            input::with(from, place, &(input::number_of(self.blocks, place) + step), self.ties)
        };
        let single = steps.iter().flat_map(|step| places.iter().map(move |place| moved(self.blocks, *place, step)));
        let double = steps.iter().flat_map(|step| {
            let (places, steps) = (&places, &steps);
            steps.iter().flat_map(move |other_step| {
                places.iter().enumerate().flat_map(move |(first, place)| {
                    let one = moved(self.blocks, *place, step);
                    places[first + 1..].iter().map(move |other| moved(&one, *other, other_step))
                })
            })
        });
        let found = single.chain(double).take(MOST_NUDGES).find(|input| self.is_witness(input))?;
        Some(self.nearest(found, flips))
    }
}
