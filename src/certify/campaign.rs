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
use crate::boundary::{self, Triple};
use crate::device::Device;
use crate::generate::{self, Reach};
use crate::judge::{Budget, Judged, judge};
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
    /// Failures of one cause: the group's name, how many, and the smallest program found.
    pub groups: Vec<(String, u64, Failure)>,
}

/// How many failed programs are kept.
const MOST_FAILURES: usize = 200;
/// How many causes are minimised.
const MOST_GROUPS: usize = 8;
/// One program in so many is also moved, mirrored, scaled, rotated and split; each costs about fifteen answers.
const MOVED_ONE_IN: u64 = 32;
/// One triple of every decision for so many generated programs.
const TRIPLE_ONE_IN: u64 = 400;
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
}

fn judge_chunk(campaign: &Campaign, device: &mut impl Device, from: u64, to: u64) -> Part {
    let (tally, cases) = (Tally::default(), Cases::default());
    let mut part = Part { from, tally, failures: Vec::new(), broken: Vec::new(), cases };
    let reach = Reach::of(&campaign.profile);
    for number in from..to {
        let blocks = generate::program(campaign.seed, number, reach);
        let judged = judge_one(campaign, device, &blocks);
        part.tally.add(&blocks, &judged, campaign.budget.beta(&blocks));
        part.cases.extend(case_of(campaign, &format!("#{number}"), &blocks, &judged));
        if judged.verdict.is_red() {
            part.failures.push(Failure::new(format!("#{number}"), judged.verdict, blocks));
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

fn case_of(campaign: &Campaign, name: &str, blocks: &[Block<Rational>], judged: &Judged) -> Option<report::Case> {
    report::case(name, blocks, judged, &campaign.budget, campaign.budget.beta(blocks))
}

/// The vectors that were written for this profile without changing its parameters.
fn judge_vectors(
    campaign: &Campaign,
    device: &mut impl Device,
    outcome: &mut Outcome,
    groups: &mut BTreeMap<String, (u64, Failure)>,
) {
    for vector in vectors::all().iter().flatten() {
        let Ok(profile) = vector.profile() else { continue };
        // A vector whose parameters are another profile's is none of this campaign's.
        if profile.parameters != campaign.profile.parameters || profile.machine != campaign.profile.machine {
            continue;
        }
        let Ok(Ok(program)) = vector.read(&profile) else { continue };
        let blocks: Vec<_> = program.blocks.into_iter().map(|read| read.block).collect();
        let judged = judge_one(campaign, device, &blocks);
        outcome.tally.add(&blocks, &judged, campaign.budget.beta(&blocks));
        outcome.cases.extend(case_of(campaign, &vector.name, &blocks, &judged));
        if judged.verdict.is_red() {
            note(Failure::new(vector.name.clone(), judged.verdict, blocks), outcome, groups);
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
    for triple in boundary::all(campaign.seed, count, Reach::of(&campaign.profile)) {
        for (place, blocks) in Triple::NAMES.iter().zip(triple.programs) {
            let judged = judge_one(campaign, device, &blocks);
            outcome.tally.add(&blocks, &judged, campaign.budget.beta(&blocks));
            let name = format!("boundary {} {place} ({})", triple.kind.id(), triple.family);
            outcome.cases.extend(case_of(campaign, &name, &blocks, &judged));
            if judged.verdict.is_red() {
                note(Failure::new(name, judged.verdict, blocks), outcome, groups);
            }
        }
    }
}

fn note(failure: Failure, outcome: &mut Outcome, groups: &mut BTreeMap<String, (u64, Failure)>) {
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
        // A smaller program counts only if it can be written for the profile and fails in the same way.
        let mut same = |blocks: &[Block<Rational>]| {
            let verdict = judge_one(campaign, device, blocks).verdict;
            let candidate = Failure::new(String::new(), verdict, blocks.to_vec());
            candidate.verdict.is_red() && candidate.group() == *name && candidate.listing(&campaign.profile).is_ok()
        };
        let blocks = minimise(&failure.blocks, &mut same);
        let judged = judge_one(campaign, device, &blocks);
        let safety = judged.answer.as_ref().map(|answer| Safety::of(&blocks, &judged.exact, answer, &campaign.budget));
        *failure = Failure { safety, ..Failure::new(failure.name.clone(), judged.verdict, blocks) };
    }
    groups
}
