//! Witnesses: inputs within the band whose exact outcome is the device's answer.
//!
//! Where a vector lies far from its corner, or two curves meet at a grazing angle, a change of the input far below the
//! least increment moves it visibly. A device may stand on any such outcome; the judge says so only with the input in
//! hand. A search can miss a witness, never make one up: each is run through the model before it is told.

mod flips;
mod input;
mod points;
mod steps;

use radcomp_model::number::within_bits;
use radcomp_model::{Run, run};
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::compare::{self, Divergence};
use super::fork::{Flip, MOST_BITS};
use super::stroke::Tolerance;
use crate::device::Answer;
pub(super) use input::Ties;

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

/// What a witness is looked for.
#[derive(Clone, Copy)]
pub(super) struct Search<'a> {
    pub(super) parameters: &'a Parameters,
    pub(super) blocks: &'a [Block<Rational>],
    pub(super) answer: &'a Answer,
    /// How far a number may be moved, in millimetres.
    pub(super) beta: f64,
    pub(super) tolerance: Tolerance,
    /// Which blocks keep ending at one point.
    pub(super) ties: Ties,
}

/// How often the way to a witness is halved to bring it nearer.
const HALVINGS: usize = 12;

impl Search<'_> {
    /// Where the answer first differs from an outcome.
    pub(super) fn divergence(&self, run: &Run) -> Option<Divergence> {
        compare::divergence(run, self.answer, self.tolerance)
    }

    /// The exact outcome of an input, unless it takes too many bits.
    fn outcome(&self, input: &[Block<Rational>]) -> Option<Run> {
        within_bits(MOST_BITS, || run(self.parameters, input))
    }

    /// Where the answer first differs from the exact outcome of an input.
    fn parting(&self, input: &[Block<Rational>]) -> Option<Option<Divergence>> {
        Some(self.divergence(&self.outcome(input)?))
    }

    /// Whether an input's exact outcome is the answer.
    fn is_witness(&self, input: &[Block<Rational>]) -> bool {
        matches!(self.parting(input), Some(None))
    }

    /// The witness nearest to the program on the straight way to this one, as far as halving finds it: a band as wide as
    /// its change is enough for the answer.
    fn nearest(&self, found: Vec<Block<Rational>>, flips: &[Flip]) -> Witness {
        let mut best = found;
        for _ in 0..HALVINGS {
            let halfway = input::halfway(self.blocks, &best);
            if !self.is_witness(&halfway) {
                break;
            }
            best = halfway;
        }
        Witness { beta: input::change(self.blocks, &best).to_f64(), input: best, flips: flips.to_vec() }
    }
}
