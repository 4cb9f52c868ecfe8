//! How far a decision reaches: from which path element on an outcome is the same whatever was decided before.
//!
//! A vector at the end of an element is formed by the element and the next one, and the tool's travel along an element by
//! the vectors at its two ends. What the engine keeps from one block to the next besides the program's own place and codes
//! is of the last element: its vector, how it was formed, whether it was the start-up block. So let the same blocks be read
//! after a block, from the same programmed point. The first one that moves may still start up after one course of things,
//! and follow another element after another. The second follows an element of the program in either case, and its end and
//! all that comes behind it are the same, unless the path has ended in an alarm.
//!
//! Two things carry a vector on, or the mode: a block whose vector the program gives or holds, which does not count as one
//! that moves here; and a start-up block whose next element is not found, which in some controls leaves the mode to be
//! started up again. The first block that moves is one whose next element is found.

use radcomp_model::number::Real;
use radcomp_spec::{Block, Clause, Movement, Step, clause};
use rug::Rational;

/// An element that ended where the program or the next element put its end.
struct Mover {
    block: usize,
    /// The path element of its own move.
    step: usize,
    /// Its end was settled without a next element.
    lost: bool,
}

/// The influence of what is decided while one block or another is read, on one outcome.
pub(super) struct Influence<'a> {
    steps: &'a [Step<Real>],
    movers: Vec<Mover>,
}

impl<'a> Influence<'a> {
    /// Influence on the outcome with these path elements.
    pub(super) fn on(steps: &'a [Step<Real>], blocks: &[Block<Rational>]) -> Self {
        let plain = |step: &Step<Real>| {
            let block = &blocks[step.block];
            let moves = matches!(block.movement, Movement::Line { .. } | Movement::Arc { .. });
            step.main && moves && block.vector.is_none()
        };
        let movers = steps.iter().enumerate().filter(|(_, step)| plain(step));
        let movers = movers.map(|(index, step)| Mover { block: step.block, step: index, lost: is_lost(step.clause) });
        Influence { steps, movers: movers.collect() }
    }

    /// The first path element that is the same whatever is decided up to the reading of a block, if the path comes to it.
    pub(super) fn end(&self, reading: usize) -> Option<usize> {
        let second = self.second(reading)?;
        // Moves of the same block behind its own belong to it.
        let beyond = &self.steps[second.step..];
        let first = beyond.iter().position(|step| step.block > second.block)?;
        Some(second.step + first)
    }

    /// Whether the place where a block ends, if the path comes to it, is the same whatever is decided up to the reading of
    /// another.
    pub(super) fn spares_end_of(&self, block: usize, reading: usize) -> bool {
        self.second(reading).is_some_and(|second| second.block <= block)
    }

    /// The second block that moves after another one, the first being followed by it.
    fn second(&self, reading: usize) -> Option<&Mover> {
        let after = self.movers.partition_point(|mover| mover.block <= reading);
        self.movers[after..].windows(2).find(|pair| !pair[0].lost).map(|pair| &pair[1])
    }
}

/// Whether an element that ended by this clause ended without a next one.
fn is_lost(clause: Clause) -> bool {
    [clause::TRC_LOOK_03, clause::TRC_START_04, clause::TRC_MODE_04].contains(&clause)
}
