//! The outcomes that a device may reach by taking another branch at decisions inside the band.
//!
//! A decision is inside the band if an input within β takes its margin to the other sign, or to zero; an interval
//! that certainly holds every such margin ([`radcomp_model::number::Real::reach`]) tells which are not. A decision that
//! is taken after the answer has parted from an outcome for good cannot bring the two together, and is not answered
//! otherwise.

use std::cmp::Ordering;
use std::collections::VecDeque;

use radcomp_model::number::{Real, within_bits};
use radcomp_model::{Decision, Engine, Run, Sink, Stop};
use radcomp_spec::{Advisory, Block, DecisionKind, Parameters, Step};
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

/// What a caller makes of an outcome.
pub(crate) enum Reception {
    /// It is the one that was looked for.
    Accepted,
    /// It is not. Decisions taken when more path elements than these stood fast cannot change that.
    Refused(usize),
}

/// The most bits that the sign of one number may take in a search; the reference has no such bound.
pub(crate) const MOST_BITS: i64 = 60_000;

/// Runs the model with other answers to the decisions inside the band, nearest to the exact outcome first, until
/// `receive` is content. Answers the accepted flips, or whether the bound was hit.
pub(crate) fn find(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    beta: f64,
    mut receive: impl FnMut(&Run) -> Reception,
) -> Result<Vec<Flip>, Exhausted> {
    // Each script answers the first in-band decisions; the rest are answered exactly.
    let mut scripts = VecDeque::from([Vec::<Ordering>::new()]);
    let mut limit_hit = false;
    let traced = Branch::run(parameters, blocks, Band { beta, traced: true }, &[]).is_some();
    for _ in 0..MOST_FORKS {
        let Some(script) = scripts.pop_front() else { return Err(Exhausted { limit_hit }) };
        let Some(branch) = Branch::run(parameters, blocks, Band { beta, traced }, &script) else {
            limit_hit = true;
            continue;
        };
        let useful = if branch.run.contradiction {
            usize::MAX
        } else {
            match receive(&branch.run) {
                Reception::Accepted => return Ok(branch.flips),
                Reception::Refused(useful) => useful,
            }
        };
        for (position, choice) in branch.choices.iter().enumerate().skip(script.len()) {
            if choice.elements > useful {
                break;
            }
            for answer in choice.others() {
                let mut longer: Vec<_> = branch.choices[..position].iter().map(|choice| choice.taken).collect();
                longer.push(answer);
                scripts.push_back(longer);
            }
        }
    }
    Err(Exhausted { limit_hit: limit_hit || !scripts.is_empty() })
}

/// No outcome was accepted.
pub(crate) struct Exhausted {
    /// There were more outcomes than the bound allows.
    pub(crate) limit_hit: bool,
}

/// A decision inside the band.
struct Choice {
    /// How many path elements stood fast when it was taken.
    elements: usize,
    taken: Ordering,
    exact: Ordering,
    /// Where the margin may go.
    reach: (f64, f64),
}

impl Choice {
    /// The answers that another input within the band gives.
    fn others(&self) -> impl Iterator<Item = Ordering> {
        [Ordering::Less, Ordering::Equal, Ordering::Greater]
            .into_iter()
            .filter(|answer| *answer != self.exact && reaches(self.reach, *answer))
    }
}

fn reaches((low, high): (f64, f64), answer: Ordering) -> bool {
    match answer {
        Ordering::Less => low < 0.0,
        Ordering::Equal => low <= 0.0 && high >= 0.0,
        Ordering::Greater => high > 0.0,
    }
}

/// Which decisions are answered otherwise.
#[derive(Clone, Copy)]
struct Band {
    beta: f64,
    /// Whether every margin is followed back to the program's numbers. Where that takes too many bits, margins up to a
    /// few bands wide are taken to be inside.
    traced: bool,
}

/// How many bands a margin may be wide that is not followed back: the numbers of a corner move it by so many.
const SEVERAL: f64 = 8.0;

impl Band {
    /// Where a margin may go.
    fn reach(self, margin: &Real) -> (f64, f64) {
        if self.traced {
            return margin.reach(self.beta);
        }
        let (low, high) = margin.filter();
        (low - SEVERAL * self.beta, high + SEVERAL * self.beta)
    }
}

/// A run of the model on one choice of branches.
struct Branch<'a> {
    band: Band,
    script: &'a [Ordering],
    run: Run,
    choices: Vec<Choice>,
    flips: Vec<Flip>,
}

impl<'a> Branch<'a> {
    /// None if a sign takes too many bits.
    fn run(parameters: &Parameters, blocks: &[Block<Rational>], band: Band, script: &'a [Ordering]) -> Option<Self> {
        let engine = if band.traced { Engine::on_inputs(parameters) } else { Engine::new(parameters) };
        within_bits(MOST_BITS, || Branch::follow(engine, blocks, band, script))
    }

    fn follow(mut engine: Engine, blocks: &[Block<Rational>], band: Band, script: &'a [Ordering]) -> Self {
        let mut branch = Branch { band, script, run: Run::default(), choices: Vec::new(), flips: Vec::new() };
        let ended = blocks
            .iter()
            .try_for_each(|block| engine.push(block, &mut branch))
            .and_then(|()| engine.finish(&mut branch));
        match ended {
            Ok(()) => {}
            Err(Stop::Alarm(alarm)) => branch.run.alarm = Some(alarm),
            Err(Stop::Contradiction) => branch.run.contradiction = true,
        }
        branch
    }
}

impl Sink for Branch<'_> {
    fn step(&mut self, step: Step<Real>) {
        self.run.steps.push(step);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        self.run.advisories.push(advisory);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        if !decision.kind.shapes_the_path() {
            return decision.exact;
        }
        let exact = decision.exact;
        let reach = self.band.reach(&decision.margin);
        let choice = Choice { elements: self.run.steps.len(), taken: exact, exact, reach };
        if choice.others().next().is_none() {
            return exact;
        }
        let taken = self.script.get(self.choices.len()).copied().unwrap_or(exact);
        if taken != exact {
            let margin = decision.margin.to_f64();
            self.flips.push(Flip { block: decision.block, kind: decision.kind, margin, exact, taken });
        }
        self.choices.push(Choice { taken, ..choice });
        taken
    }
}
