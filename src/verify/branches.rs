//! The outcomes on every combination of branches at decisions inside the band.

use std::cmp::Ordering;
use std::collections::VecDeque;

use radcomp_model::number::{Real, within_bits};
use radcomp_model::{Decision, Engine, Run, Sink, Stop};
use radcomp_spec::{Block, Parameters, Step};
use rug::Rational;

/// The most combinations that are looked at for one program.
pub const MOST_RUNS: usize = 256;
/// The most bits that the sign of one number may take here.
const MOST_BITS: i64 = 1_000_000;

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
    beta: f64,
    mut accept: impl FnMut(&Run) -> bool,
) -> Search {
    let mut plans = VecDeque::from([Plan::new()]);
    for _ in 0..MOST_RUNS {
        let Some(plan) = plans.pop_front() else { return Search::NotFound };
        // Where a sign takes too many bits, this is one combination too many.
        let Some((run, exact)) = within_bits(MOST_BITS, || follow(parameters, blocks, beta, &plan)) else {
            return Search::TooMany;
        };
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
fn follow(parameters: &Parameters, blocks: &[Block<Rational>], beta: f64, plan: &Plan) -> (Run, Vec<Ordering>) {
    let mut follower = Follower { beta, plan, seen: Vec::new(), run: Run::default() };
    let mut engine = Engine::on_inputs(parameters);
    for block in blocks {
        // A stopped engine gives its reason again at the end.
        if engine.push(block, &mut follower).is_err() {
            break;
        }
    }
    match engine.finish(&mut follower) {
        Err(Stop::Alarm(alarm)) => follower.run.alarm = Some(alarm),
        Err(Stop::Contradiction) => follower.run.contradiction = true,
        Ok(()) => {}
    }
    (follower.run, follower.seen)
}

/// Takes the decisions in the band as a plan says.
struct Follower<'a> {
    beta: f64,
    plan: &'a Plan,
    seen: Vec<Ordering>,
    run: Run,
}

impl Sink for Follower<'_> {
    fn step(&mut self, step: Step<Real>) {
        self.run.steps.push(step);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        if !is_in_band(&decision, self.beta) {
            return decision.exact;
        }
        let number = self.seen.len();
        self.seen.push(decision.exact);
        self.plan.iter().find(|(planned, _)| *planned == number).map_or(decision.exact, |(_, answer)| *answer)
    }
}

/// Whether a decision that shapes the path may have another answer where every number of the program may move by β.
fn is_in_band(decision: &Decision, beta: f64) -> bool {
    let (low, high) = decision.margin.reach(beta);
    let certain = low > 0.0 || high < 0.0 || (low == 0.0 && high == 0.0);
    decision.kind.shapes_the_path() && !certain
}
