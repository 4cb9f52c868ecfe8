//! The outcomes that a device may reach by taking another branch at decisions inside the band.

use std::cmp::Ordering;
use std::collections::VecDeque;

use radcomp_model::{Decision, Run, run_with};
use radcomp_spec::{Block, DecisionKind, Parameters};
use rug::Rational;

/// The most outcomes that are looked at for one program.
pub(crate) const MOST_FORKS: usize = 64;

/// A decision that was answered otherwise than exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flip {
    /// Index of the block that was being read.
    pub block: usize,
    /// Which decision.
    pub kind: DecisionKind,
    /// Its margin, in millimetres, within one unit in the last place.
    pub margin: f64,
    /// The exact answer.
    pub exact: Ordering,
    /// The branch that was taken.
    pub taken: Ordering,
}

/// Runs the model with other answers to the decisions whose margin is at most `beta`, nearest to the exact outcome
/// first, until `accept` is content. Answers the accepted flips, or whether the bound was hit.
pub(crate) fn find(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    beta: f64,
    mut accept: impl FnMut(&Run) -> bool,
) -> Result<Vec<Flip>, Exhausted> {
    // Each script answers the first in-band decisions; the rest are answered exactly.
    let mut scripts = VecDeque::from([Vec::<Ordering>::new()]);
    for _ in 0..MOST_FORKS {
        let Some(script) = scripts.pop_front() else { return Err(Exhausted { limit_hit: false }) };
        let mut taken = Vec::new();
        let mut flips = Vec::new();
        let run = run_with(parameters, blocks, |decision| {
            if !decision.kind.shapes_the_path() || !in_band(decision, beta) {
                return decision.exact;
            }
            let answer = script.get(taken.len()).copied().unwrap_or(decision.exact);
            if answer != decision.exact {
                flips.push(Flip {
                    block: decision.block,
                    kind: decision.kind,
                    margin: decision.margin.to_f64(),
                    exact: decision.exact,
                    taken: answer,
                });
            }
            taken.push((decision.exact, answer));
            answer
        });
        if !run.contradiction && accept(&run) {
            return Ok(flips);
        }
        for position in script.len()..taken.len() {
            for answer in [Ordering::Less, Ordering::Equal, Ordering::Greater] {
                if answer != taken[position].0 {
                    let mut longer: Vec<_> = taken[..position].iter().map(|(_, answer)| *answer).collect();
                    longer.push(answer);
                    scripts.push_back(longer);
                }
            }
        }
    }
    Err(Exhausted { limit_hit: !scripts.is_empty() })
}

/// No outcome was accepted.
pub(crate) struct Exhausted {
    /// There were more outcomes than the bound allows.
    pub(crate) limit_hit: bool,
}

/// Whether a decision's margin may lie within the band; when the certain interval at hand does not tell, it does.
pub(crate) fn in_band(decision: &Decision, beta: f64) -> bool {
    let (low, high) = decision.margin.filter();
    low <= beta && high >= -beta
}
