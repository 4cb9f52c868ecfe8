//! The outcomes that a device may reach by taking another branch at decisions inside the band.
//!
//! A decision is inside the band if an input within β takes its margin to the other sign, or to zero; an interval
//! that holds every value of the margin's expression at such inputs ([`radcomp_model::number::Real::reach`]) tells which
//! are not. Another input may choose another expression, the longer of two lengths for the shorter; what is chosen so
//! scales a margin and does not change its sign.
//!
//! A decision that is taken after the answer has parted from an outcome for good cannot bring the two together, and is not
//! answered otherwise. Nor is one whose influence ([`Influence`]) has ended where the two still agree, and whose
//! influence meets that of no decision that could: whatever outcome is the answer with it answered otherwise, the one with
//! its exact answer and all else alike is the answer too.

use std::cmp::Ordering;
use std::collections::VecDeque;
use std::ops::Range;

use radcomp_model::number::{Real, within_bits};
use radcomp_model::{Decision, Engine, Run, Sink, Stop};
use radcomp_spec::{Advisory, Block, DecisionKind, Parameters, Step};
use rug::Rational;

use super::compare::Parting;
use super::influence::Influence;

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
    /// It is not: where they part.
    Refused(Parting),
}

/// The most bits that the sign of one number may take in a search; the reference has no such bound.
pub(crate) const MOST_BITS: i64 = 60_000;

/// Runs the model with other answers to the decisions inside the band, nearest to the exact outcome first, until
/// `receive` is content. Answers the accepted flips, or whether the bound was hit.
///
/// First margins up to a few bands wide are taken to be inside, and what is accepted is followed back to the program's
/// numbers; where that finds nothing, and some wider margin is inside all the same, every margin is followed back.
pub(crate) fn find(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    beta: f64,
    mut receive: impl FnMut(&Run) -> Reception,
) -> Result<Vec<Flip>, Exhausted> {
    let traced = Band { beta, traced: true };
    let near = match search(parameters, blocks, Band { beta, traced: false }, |branch| match receive(&branch.run) {
        Reception::Accepted if !branch.is_reachable(parameters, blocks, traced) => {
            Reception::Refused(Parting::anywhere())
        }
        reception => reception,
    }) {
        Err(near) => near,
        found => return found,
    };
    let Some(base) = Branch::run(parameters, blocks, traced, &[]) else { return Err(near) };
    let parting = match receive(&base.run) {
        Reception::Accepted => Parting::anywhere(),
        Reception::Refused(parting) => parting,
    };
    if base.choices[base.useful(parameters, blocks, &parting)].iter().all(|choice| choice.is_near) {
        return Err(near);
    }
    search(parameters, blocks, traced, |branch| receive(&branch.run))
}

fn search(
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    band: Band,
    mut receive: impl FnMut(&Branch<'_>) -> Reception,
) -> Result<Vec<Flip>, Exhausted> {
    // Each script answers the first in-band decisions; the rest are answered exactly.
    let mut scripts = VecDeque::from([Vec::<Ordering>::new()]);
    let (mut limit_hit, mut dead_end) = (false, false);
    for _ in 0..MOST_FORKS {
        let Some(script) = scripts.pop_front() else { return Err(Exhausted { limit_hit, dead_end }) };
        let Some(branch) = Branch::run(parameters, blocks, band, &script) else {
            limit_hit = true;
            continue;
        };
        let parting = if branch.run.contradiction {
            dead_end = true;
            Parting::anywhere()
        } else {
            match receive(&branch) {
                Reception::Accepted => return Ok(branch.flips.into_iter().map(|(_, flip)| flip).collect()),
                Reception::Refused(parting) => parting,
            }
        };
        for position in branch.useful(parameters, blocks, &parting).filter(|position| *position >= script.len()) {
            for answer in branch.choices[position].others() {
                let mut longer: Vec<_> = branch.choices[..position].iter().map(|choice| choice.taken).collect();
                longer.push(answer);
                scripts.push_back(longer);
            }
        }
    }
    Err(Exhausted { limit_hit: limit_hit || !scripts.is_empty(), dead_end })
}

/// No outcome was accepted.
pub(crate) struct Exhausted {
    /// There were more outcomes than the bound allows.
    pub(crate) limit_hit: bool,
    /// A branch that an input within the band takes has no outcome at the program itself: two lines that are one have no
    /// intersection.
    pub(crate) dead_end: bool,
}

/// A decision inside the band.
struct Choice {
    /// How many path elements stood fast when it was taken.
    elements: usize,
    /// The block that was being read.
    reading: usize,
    taken: Ordering,
    exact: Ordering,
    /// Where the margin may go.
    reach: (f64, f64),
    /// The margin is up to a few bands wide.
    is_near: bool,
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

/// Whether the margin of a decision is a length, which no input makes negative.
fn is_a_length(kind: DecisionKind) -> bool {
    use DecisionKind::{CentreDistance, CentresApart, Moves, WholeTurn};
    matches!(kind, Moves | CentreDistance | WholeTurn | CentresApart)
}

/// Which decisions are answered otherwise.
#[derive(Clone, Copy)]
struct Band {
    beta: f64,
    /// Whether every margin is followed back to the program's numbers.
    traced: bool,
}

/// How many bands a margin may be wide that is not followed back: the numbers of a corner move it by so many.
const SEVERAL: f64 = 8.0;

impl Band {
    /// A few bands about a margin.
    fn near(self, margin: &Real) -> (f64, f64) {
        let (low, high) = margin.filter();
        (low - SEVERAL * self.beta, high + SEVERAL * self.beta)
    }
}

/// A run of the model on one choice of branches.
struct Branch<'a> {
    band: Band,
    /// Answers to the decisions inside the band, or to those with these numbers.
    answers: Answers<'a>,
    /// How many decisions have been taken.
    taken: usize,
    /// The block that is being read.
    reading: usize,
    run: Run,
    choices: Vec<Choice>,
    /// The decisions answered otherwise, with their numbers.
    flips: Vec<(usize, Flip)>,
}

/// How decisions are answered.
#[derive(Clone, Copy)]
enum Answers<'a> {
    /// Those inside the band, in their order.
    Script(&'a [Ordering]),
    /// As these flips say, by the numbers of the decisions.
    Flips(&'a [(usize, Flip)]),
}

impl<'a> Branch<'a> {
    /// None if a sign takes too many bits.
    fn run(parameters: &Parameters, blocks: &[Block<Rational>], band: Band, script: &'a [Ordering]) -> Option<Self> {
        Branch::answered(parameters, blocks, band, Answers::Script(script))
    }

    fn answered(parameters: &Parameters, blocks: &[Block<Rational>], band: Band, answers: Answers<'a>) -> Option<Self> {
        let engine = if band.traced { Engine::on_inputs(parameters) } else { Engine::new(parameters) };
        within_bits(MOST_BITS, || Branch::follow(engine, blocks, band, answers))
    }

    /// Whether some input inside the band takes each of the flips; it is taken to, if that takes too many bits.
    fn is_reachable(&self, parameters: &Parameters, blocks: &[Block<Rational>], traced: Band) -> bool {
        let followed = Branch::answered(parameters, blocks, traced, Answers::Flips(&self.flips));
        followed.is_none_or(|followed| followed.flips.len() == self.flips.len())
    }

    fn follow(mut engine: Engine, blocks: &[Block<Rational>], band: Band, answers: Answers<'a>) -> Self {
        let mut branch =
            Branch { band, answers, taken: 0, reading: 0, run: Run::default(), choices: Vec::new(), flips: Vec::new() };
        let ended = blocks
            .iter()
            .enumerate()
            .try_for_each(|(index, block)| {
                branch.reading = index;
                engine.push(block, &mut branch)
            })
            .and_then(|()| engine.finish(&mut branch));
        match ended {
            Ok(()) => {}
            Err(Stop::Alarm(alarm)) => branch.run.alarm = Some(alarm),
            Err(Stop::Contradiction) => branch.run.contradiction = true,
        }
        branch
    }

    /// The decisions inside the band that could bring an answer together with the outcome: from the first to the last one
    /// whose influence meets the place where they part, or meets that of such a one.
    fn useful(&self, parameters: &Parameters, blocks: &[Block<Rational>], parting: &Parting) -> Range<usize> {
        let last = self.choices.partition_point(|choice| choice.elements <= parting.settled);
        let influence = Influence::on(parameters, &self.run.steps, blocks);
        let spared = |choice: &Choice| parting.vector.is_some_and(|end| influence.spares_end_of(end, choice.reading));
        let mut first = last;
        // What another answer to the useful ones may change comes after this path element.
        let mut agreed = parting.agreed_before(usize::MAX);
        while let Some(choice) = first.checked_sub(1).map(|before| &self.choices[before]) {
            let ends = influence.end(choice.reading).zip(agreed).is_some_and(|(end, agreed)| end <= agreed);
            if ends || (first == last && spared(choice)) {
                break;
            }
            agreed = agreed.and(parting.agreed_before(choice.elements)).min(agreed);
            first -= 1;
        }
        first..last
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
        let number = self.taken;
        self.taken += 1;
        if !decision.kind.shapes_the_path() {
            return decision.exact;
        }
        let exact = decision.exact;
        let near = self.band.near(&decision.margin);
        let mut reach = if self.band.traced { decision.margin.reach(self.band.beta) } else { near };
        if is_a_length(decision.kind) {
            reach.0 = reach.0.max(0.0);
        }
        let is_near = near.0 <= 0.0 && near.1 >= 0.0;
        let (elements, reading) = (self.run.steps.len(), self.reading);
        let choice = Choice { elements, reading, taken: exact, exact, reach, is_near };
        if choice.others().next().is_none() {
            return exact;
        }
        let taken = match self.answers {
            Answers::Script(script) => script.get(self.choices.len()).copied().unwrap_or(exact),
            Answers::Flips(flips) => {
                let flip = flips.iter().find(|(flipped, _)| *flipped == number).map(|(_, flip)| flip.taken);
                flip.filter(|taken| reaches(reach, *taken)).unwrap_or(exact)
            }
        };
        if taken != exact {
            let margin = decision.margin.to_f64();
            let flip = Flip { block: decision.block, kind: decision.kind, margin, exact, taken };
            self.flips.push((number, flip));
        }
        self.choices.push(Choice { taken, ..choice });
        taken
    }
}
