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
//! started up again. The first block that moves is one whose next element is found. A control that looks for interference
//! over several blocks ([TRC-INT-01]) forms its vectors otherwise; nothing is said of it here.

use radcomp_model::number::Real;
use radcomp_spec::parameters::{Interference, Parameters};
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
    pub(super) fn on(parameters: &Parameters, steps: &'a [Step<Real>], blocks: &[Block<Rational>]) -> Self {
        let plain = |step: &Step<Real>| {
            let block = &blocks[step.block];
            let moves = matches!(block.movement, Movement::Line { .. } | Movement::Arc { .. });
            parameters.interference == Interference::Off && step.main && moves && block.vector.is_none()
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

#[cfg(test)]
mod tests {
    use radcomp_model::{Decision, Engine, Sink, run};
    use radcomp_spec::profile::{BUILTIN, Profile};
    use rug::Rational;
    use std::cmp::Ordering;

    use super::*;
    use crate::generate::{self, Reach};

    fn program(profile: &Profile, number: u64) -> Vec<Block<Rational>> {
        generate::program(29, number, Reach::of(profile))
    }

    /// The block with its end elsewhere, if it has one.
    fn moved(block: &Block<Rational>, by: [i32; 2]) -> Option<Block<Rational>> {
        let mut moved = block.clone();
        let (Movement::Line { end } | Movement::Arc { end, .. }) = &mut moved.movement else { return None };
        end.iter_mut().zip(by).for_each(|(value, by)| *value += Rational::from((by, 8)));
        Some(moved)
    }

    /// A block's end is moved, which changes it and the next one with an end. Whatever the rules make of that, what comes
    /// behind the influence of both is the same, or the path ends before.
    #[test]
    fn nothing_behind_the_influence_of_a_change_follows_from_it() {
        let mut seen = 0;
        for (name, _) in BUILTIN {
            let profile = Profile::builtin(name).unwrap();
            for number in 0..500 {
                let blocks = program(&profile, number);
                let exact = run(&profile.parameters, &blocks);
                let influence = Influence::on(&profile.parameters, &exact.steps, &blocks);
                let ends: Vec<usize> =
                    (0..blocks.len()).filter(|index| moved(&blocks[*index], [0, 0]).is_some()).collect();
                for pair in ends.windows(2) {
                    let Some(end) = influence.end(pair[1]) else { continue };
                    let by = [[1, 0], [-3, 2], [0, -40]][pair[0] % 3];
                    let mut other = blocks.clone();
                    other[pair[0]] = moved(&blocks[pair[0]], by).unwrap();
                    let outcome = run(&profile.parameters, &other);
                    let (first, last) = (exact.steps[end].block, influence.second(pair[1]).unwrap().block);
                    if outcome.alarm.is_some_and(|alarm| alarm.block <= last) {
                        continue;
                    }
                    let from = outcome.steps.iter().position(|step| step.block >= first).expect("the path goes on");
                    let told = format!("{name} #{number}, N{}: {:?}", pair[0] + 1, outcome.alarm);
                    assert_eq!(outcome.steps[from..], exact.steps[end..], "{told}");
                    assert_eq!(outcome.alarm, exact.alarm, "{told}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 6_000, "{seen}");
    }

    /// Watches which blocks have path elements.
    #[derive(Default)]
    struct Order {
        last: Option<usize>,
        decided: bool,
    }

    impl Sink for Order {
        fn step(&mut self, step: Step<Real>) {
            assert!(!self.decided || Some(step.block) > self.last, "a block's path elements stand apart");
            (self.last, self.decided) = (Some(step.block), false);
        }

        fn decide(&mut self, decision: Decision) -> Ordering {
            self.decided |= decision.kind.shapes_the_path();
            decision.exact
        }
    }

    #[test]
    fn the_path_elements_of_a_block_are_settled_together() {
        for (name, _) in BUILTIN {
            let profile = Profile::builtin(name).unwrap();
            for number in 0..400 {
                let mut order = Order::default();
                let mut engine = Engine::new(&profile.parameters);
                let read = program(&profile, number).iter().try_for_each(|block| engine.push(block, &mut order));
                let _alarm = read.and_then(|()| engine.finish(&mut order));
            }
        }
    }
}
