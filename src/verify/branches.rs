//! The outcomes on every combination of branches at decisions inside the band.

use std::cmp::Ordering;
use std::collections::VecDeque;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Run, run_with};
use radcomp_spec::{Block, Parameters};
use rug::Rational;

/// The most combinations that are looked at for one program.
pub const MOST_RUNS: usize = 256;

/// What came of looking.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Search {
    /// The outcome on some combination was accepted.
    Found,
    /// None was.
    NotFound,
    /// None was, and there are more than [`MOST_RUNS`].
    TooMany,
}

/// Which decisions in the band are answered otherwise than exactly: the first is number 0. Numbers rise.
type Plan = Vec<(usize, Ordering)>;

/// Looks for an accepted outcome, those with the fewest decisions answered otherwise first.
pub(super) fn search(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    beta: &Real,
    mut accept: impl FnMut(&Run) -> bool,
) -> Search {
    let mut plans = VecDeque::from([Plan::new()]);
    for _ in 0..MOST_RUNS {
        let Some(plan) = plans.pop_front() else { return Search::NotFound };
        let (run, exact) = follow(parameters, blocks, beta, &plan);
        if !run.contradiction && accept(&run) {
            return Search::Found;
        }
        // Each combination is reached once: by its last decision from the plan without it.
        let next = plan.last().map_or(0, |(number, _)| number + 1);
        for (number, exact) in exact.into_iter().enumerate().skip(next) {
            for other in [Ordering::Less, Ordering::Equal, Ordering::Greater] {
                if other != exact {
                    let mut longer = plan.clone();
                    longer.push((number, other));
                    plans.push_back(longer);
                }
            }
        }
    }
    if plans.is_empty() { Search::NotFound } else { Search::TooMany }
}

/// The outcome of a plan, and the exact answer of every decision in the band.
fn follow(parameters: &Parameters, blocks: &[Block<Rational>], beta: &Real, plan: &Plan) -> (Run, Vec<Ordering>) {
    let mut seen = Vec::new();
    let run = run_with(parameters, blocks, |decision| {
        if !is_in_band(decision, beta) {
            return decision.exact;
        }
        let number = seen.len();
        seen.push(decision.exact);
        plan.iter().find(|(planned, _)| *planned == number).map_or(decision.exact, |(_, answer)| *answer)
    });
    (run, seen)
}

/// Whether a decision that shapes the path has a margin of at most β, exactly.
fn is_in_band(decision: &Decision, beta: &Real) -> bool {
    decision.kind.shapes_the_path() && decision.margin <= *beta && decision.margin >= -beta
}
