//! Running a campaign.

use std::collections::BTreeMap;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use radcomp_spec::Block;
use radcomp_spec::profile::Profile;
use rug::Rational;

use super::failure::Failure;
use super::safety::Safety;
use super::tally::Tally;
use super::waivers::Waivers;
use crate::boundary::{self, Triple};
use crate::device::{Device, DeviceFault};
use crate::generate::{self, Reach};
use crate::judge::{Budget, Judged, Verdict, judge, judge_answer};
use crate::metamorphic::{self, Broken};
use crate::minimise::minimise;
use crate::report::{self, Cases};
use crate::vectors;

/// How much is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Vectors and generated programs; seconds.
    One,
    /// More of them; minutes.
    Two,
}

impl Level {
    /// How many generated programs the level asks for; more may be judged, never fewer.
    pub const fn programs(self) -> u64 {
        match self {
            Level::One => 24_000,
            Level::Two => 480_000,
        }
    }
}

/// What a campaign judges.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// The control's profile.
    pub profile: Profile,
    /// Seed of the generated programs.
    pub seed: u64,
    /// How many of them.
    pub programs: u64,
    /// The budgets.
    pub budget: Budget,
    /// Failures that are accepted.
    pub waivers: Waivers,
    /// Threads to work with; the outcome does not depend on it.
    pub threads: usize,
}

/// What came of it.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The counts.
    pub tally: Tally,
    /// Failed programs, in order; at most 200.
    pub failures: Vec<Failure>,
    /// Relations between moved programs that the device broke, with the number of the program; at most 200.
    pub broken: Vec<(u64, Broken)>,
    /// Programs whose answer was not exact, for the report.
    pub cases: Cases,
    /// Programs that a waiver covers, by its place.
    pub expected: BTreeMap<usize, u64>,
    /// Failures of one cause: the group's name, how many, and the smallest program found.
    pub groups: Vec<(String, u64, Failure)>,
}

/// How many failed programs are kept.
const MOST_FAILURES: usize = 200;
/// How many causes are minimised.
const MOST_GROUPS: usize = 8;
/// One program in so many is also moved, mirrored, scaled, rotated and split; each costs about fifteen answers.
pub const MOVED_ONE_IN: u64 = 32;
/// One triple of every decision for so many generated programs.
pub const TRIPLE_ONE_IN: u64 = 400;
/// How many programs a thread takes at a time.
const CHUNK: u64 = 60;

/// Judges a device. `make` makes one for each thread; `progress` hears how many programs are done.
pub fn certify<D: Device>(campaign: &Campaign, make: impl Fn() -> D + Sync, progress: impl Fn(u64) + Sync) -> Outcome {
    let mut outcome = Outcome::default();
    let mut groups = BTreeMap::new();
    judge_vectors(campaign, &mut make(), &mut outcome, &mut groups);
    judge_boundaries(campaign, &mut make(), &mut outcome, &mut groups);
    let next = AtomicU64::new(0);
    // A thread that panics has lost programs: that is a fault of the toolkit, and ends the run.
    let mut parts: Vec<Part> = thread::scope(|scope| {
        let work = || {
            let mut device = make();
            let mut parts = Vec::new();
            loop {
                let from = next.fetch_add(CHUNK, Ordering::Relaxed);
                if from >= campaign.programs {
                    return parts;
                }
                let to = (from + CHUNK).min(campaign.programs);
                parts.push(judge_chunk(campaign, &mut device, from, to));
                progress(to - from);
            }
        };
        let threads: Vec<_> = (0..campaign.threads.max(1)).map(|_| scope.spawn(work)).collect();
        threads.into_iter().flat_map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic))).collect()
    });
    parts.sort_by_key(|part| part.from);
    for part in parts {
        outcome.tally.merge(part.tally);
        outcome.cases.merge(part.cases);
        for (waiver, programs) in part.expected {
            *outcome.expected.entry(waiver).or_default() += programs;
        }
        let room = MOST_FAILURES - outcome.broken.len();
        outcome.broken.extend(part.broken.into_iter().take(room));
        for failure in part.failures {
            note(failure, &mut outcome, &mut groups);
        }
    }
    outcome.groups = smallest(campaign, &mut make(), groups);
    outcome
}

/// What one chunk of programs gave.
struct Part {
    from: u64,
    tally: Tally,
    failures: Vec<Failure>,
    broken: Vec<(u64, Broken)>,
    cases: Cases,
    expected: BTreeMap<usize, u64>,
}

fn judge_chunk(campaign: &Campaign, device: &mut impl Device, from: u64, to: u64) -> Part {
    let (tally, cases) = (Tally::default(), Cases::default());
    let expected = BTreeMap::new();
    let mut part = Part { from, tally, failures: Vec::new(), broken: Vec::new(), cases, expected };
    let reach = Reach::of(&campaign.profile);
    let programs: Vec<_> = (from..to).map(|number| generate::program(campaign.seed, number, reach)).collect();
    let judged = judge_all(campaign, device, &programs);
    for ((number, blocks), judged) in (from..to).zip(programs).zip(judged) {
        let name = format!("#{number}");
        let waiver = count(campaign, &name, &blocks, &judged, &mut part.tally, &mut part.cases);
        if let Some(waiver) = waiver {
            *part.expected.entry(waiver).or_default() += 1;
        } else if judged.verdict.is_red() {
            part.failures.push(Failure::new(name, judged.verdict, blocks));
        } else if number % MOVED_ONE_IN == 0 {
            let broken = metamorphic::check(device, &campaign.profile.parameters, &blocks, &campaign.budget);
            part.tally.moved += 1;
            part.tally.broken += broken.len() as u64;
            part.broken.extend(broken.into_iter().map(|broken| (number, broken)));
        }
    }
    part
}

fn judge_one(campaign: &Campaign, device: &mut impl Device, blocks: &[Block<Rational>]) -> Judged {
    judge(device, &campaign.profile.parameters, blocks, &campaign.budget)
}

/// Judges several programs, which a device may work on at the same time.
fn judge_all(campaign: &Campaign, device: &mut impl Device, programs: &[Vec<Block<Rational>>]) -> Vec<Judged> {
    let parameters = &campaign.profile.parameters;
    let answers = device.answer_all(parameters, programs);
    let judged = answers.into_iter().zip(programs);
    judged.map(|(answer, blocks)| judge_answer(answer, parameters, blocks, &campaign.budget)).collect()
}

fn case_of(campaign: &Campaign, name: &str, blocks: &[Block<Rational>], judged: &Judged) -> Option<report::Case> {
    report::case(name, blocks, judged, &campaign.budget, campaign.budget.beta(blocks))
}

/// Counts a judged program and keeps its case. Answers the place of the waiver that covers it.
pub(super) fn count(
    campaign: &Campaign,
    name: &str,
    blocks: &[Block<Rational>],
    judged: &Judged,
    tally: &mut Tally,
    cases: &mut Cases,
) -> Option<usize> {
    let waiver = campaign.waivers.covering(name, &judged.verdict);
    tally.add_waived(blocks, judged, campaign.budget.beta(blocks), waiver.is_some());
    cases.extend(case_of(campaign, name, blocks, judged).map(|case| report::Case { waiver, ..case }));
    waiver
}

fn judge_vectors(
    campaign: &Campaign,
    device: &mut impl Device,
    outcome: &mut Outcome,
    groups: &mut BTreeMap<String, (u64, Failure)>,
) {
    let named = vector_programs(&campaign.profile);
    judge_named(campaign, device, named, outcome, groups);
}

/// The vectors that were written for this profile without changing its parameters.
pub(super) fn vector_programs(profile: &Profile) -> Vec<(String, Vec<Block<Rational>>)> {
    let mut named = Vec::new();
    for vector in vectors::all().iter().flatten() {
        let Ok(own) = vector.profile() else { continue };
        // A vector whose parameters are another profile's is none of this campaign's.
        if own.parameters != profile.parameters || own.machine != profile.machine {
            continue;
        }
        let Ok(Ok(program)) = vector.read(&own) else { continue };
        named.push((vector.name.clone(), program.blocks.into_iter().map(|read| read.block).collect()));
    }
    named
}

/// Judges programs that have names.
fn judge_named(
    campaign: &Campaign,
    device: &mut impl Device,
    named: Vec<(String, Vec<Block<Rational>>)>,
    outcome: &mut Outcome,
    groups: &mut BTreeMap<String, (u64, Failure)>,
) {
    let (names, programs): (Vec<_>, Vec<_>) = named.into_iter().unzip();
    let judged = judge_all(campaign, device, &programs);
    for ((name, blocks), judged) in names.into_iter().zip(programs).zip(judged) {
        let waiver = count(campaign, &name, &blocks, &judged, &mut outcome.tally, &mut outcome.cases);
        if let Some(waiver) = waiver {
            *outcome.expected.entry(waiver).or_default() += 1;
        } else if judged.verdict.is_red() {
            note(Failure::new(name, judged.verdict, blocks), outcome, groups);
        }
    }
}

/// Programs exactly on each decision, and one least increment to either side.
fn judge_boundaries(
    campaign: &Campaign,
    device: &mut impl Device,
    outcome: &mut Outcome,
    groups: &mut BTreeMap<String, (u64, Failure)>,
) {
    let count = campaign.programs / TRIPLE_ONE_IN;
    let mut triples = boundary::all(campaign.seed, count, Reach::of(&campaign.profile)).peekable();
    while triples.peek().is_some() {
        let named = triples.by_ref().take(CHUNK as usize / 3).flat_map(boundary_programs).collect();
        judge_named(campaign, device, named, outcome, groups);
    }
}

/// The three programs of a triple, with their names.
pub(super) fn boundary_programs(triple: Triple) -> Vec<(String, Vec<Block<Rational>>)> {
    let name = |place| format!("boundary {} {place} ({})", triple.kind.id(), triple.family);
    Triple::NAMES.iter().map(name).zip(triple.programs).collect()
}

/// Counts a failure with those of its cause.
pub(super) fn note(failure: Failure, outcome: &mut Outcome, groups: &mut BTreeMap<String, (u64, Failure)>) {
    let (count, smallest) = groups.entry(failure.group()).or_insert_with(|| (0, failure.clone()));
    *count += 1;
    if failure.blocks.len() < smallest.blocks.len() {
        *smallest = failure.clone();
    }
    if outcome.failures.len() < MOST_FAILURES {
        outcome.failures.push(failure);
    }
}

/// The groups, most frequent first, each with its program minimised.
fn smallest(
    campaign: &Campaign,
    device: &mut impl Device,
    groups: BTreeMap<String, (u64, Failure)>,
) -> Vec<(String, u64, Failure)> {
    let mut groups: Vec<_> = groups.into_iter().map(|(name, (count, failure))| (name, count, failure)).collect();
    groups.sort_by(|x, y| y.1.cmp(&x.1).then_with(|| x.0.cmp(&y.0)));
    for (name, _, failure) in groups.iter_mut().take(MOST_GROUPS) {
        // Each smaller program would have to be waited for.
        if matches!(failure.verdict, Verdict::Fault(DeviceFault::Timeout(_))) {
            continue;
        }
        // A smaller program counts only if it can be written for the profile and fails in the same way.
        let mut same = |blocks: &[Block<Rational>]| {
            let verdict = judge_one(campaign, device, blocks).verdict;
            let candidate = Failure::new(String::new(), verdict, blocks.to_vec());
            candidate.verdict.is_red() && candidate.group() == *name && candidate.listing(&campaign.profile).is_ok()
        };
        let blocks = minimise(&failure.blocks, &mut same);
        let judged = judge_one(campaign, device, &blocks);
        let safety = judged.answer.as_ref().map(|answer| Safety::of(&blocks, &judged.exact, answer, &campaign.budget));
        let case = case_of(campaign, &failure.name, &blocks, &judged).map(Box::new);
        *failure = Failure { safety, case, ..Failure::new(failure.name.clone(), judged.verdict, blocks) };
    }
    groups
}
