//! Running a campaign: its units go to threads as these come free, and what they give is added up in order.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::campaign::Campaign;
use super::checkpoint::Checkpoint;
use super::ledger::{Ledger, MOST_FAILURES};
use super::plan::{Place, Plan};
use crate::device::Device;
use crate::judge::judge_answer;
use crate::metamorphic;
use crate::report::BrokenRecord;

/// A part of a campaign: of its units, those whose number leaves the same rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1.
    pub number: u64,
    /// Of how many.
    pub of: u64,
}

/// How a campaign is run.
#[derive(Debug, Default)]
pub struct Course<'a> {
    /// Only this part of it.
    pub shard: Option<Shard>,
    /// Go on with further rounds of programs until so much time has passed; not for a part.
    pub time: Option<Duration>,
    /// Where the work is kept that has been done.
    pub checkpoint: Option<&'a Checkpoint>,
}

/// One program in so many is also moved, mirrored, scaled, rotated and split; each costs about fifteen answers.
pub const MOVED_ONE_IN: u64 = 32;
/// How many units may be done before one that comes before them.
const MOST_AHEAD: u64 = 256;

/// Judges the programs of a campaign. Answers what came of them, and how many generated programs the campaign has.
pub(super) fn run<D: Device>(
    campaign: &Campaign,
    course: &Course<'_>,
    make: &(impl Fn() -> D + Sync),
    progress: impl Fn(u64) + Sync,
) -> (Ledger, u64) {
    // How many programs a campaign has that runs until its time is up is known at its end.
    let programs = if course.time.is_some() { u64::MAX } else { campaign.programs };
    let plan = Plan::new(&campaign.profile, campaign.seed, programs, campaign.budget.grade);
    let work = Work::new(&plan, campaign, course);
    progress(work.locked().ledger.tally.programs);
    thread::scope(|scope| {
        for _ in 0..campaign.threads.max(1) {
            scope.spawn(|| {
                // A thread that panics has lost programs: that is a fault of the toolkit, and ends the run.
                let _watch = Watch(&work);
                let mut device = make();
                while let Some(index) = work.take() {
                    let unit = work.unit(index);
                    let ledger = judge_unit(campaign, &mut device, &plan, unit);
                    progress(ledger.tally.programs);
                    work.add(index, ledger);
                }
            });
        }
    });
    let state = work.state.into_inner().unwrap_or_else(PoisonError::into_inner);
    let generated = if course.time.is_some() { plan.generated(state.end) } else { campaign.programs };
    (state.ledger, generated)
}

fn judge_unit(campaign: &Campaign, device: &mut impl Device, plan: &Plan, unit: u64) -> Ledger {
    let mut ledger = Ledger::default();
    let parameters = &campaign.profile.parameters;
    let (named, programs): (Vec<_>, Vec<_>) =
        plan.unit(unit).into_iter().map(|planned| ((planned.name, planned.number), planned.blocks)).unzip();
    // A device may work on several programs at the same time.
    let answers = device.answer_all(parameters, &programs);
    for (index, ((name, number), (blocks, answer))) in (0..).zip(named.into_iter().zip(programs.iter().zip(answers))) {
        let judged = judge_answer(answer, parameters, blocks, &campaign.budget);
        ledger.note(campaign, Place(unit, index), &name, blocks, &judged);
        if let Some(number) = number.filter(|number| number % MOVED_ONE_IN == 0)
            && !judged.verdict.is_red()
        {
            let broken = metamorphic::check(device, parameters, blocks, &campaign.budget);
            ledger.tally.moved += 1;
            ledger.tally.broken += broken.len() as u64;
            let room = MOST_FAILURES - ledger.broken.len();
            let records = broken.iter().take(room).map(|broken| (number, BrokenRecord::new(number, broken)));
            ledger.broken.extend(records);
        }
    }
    ledger
}

/// The units of a part of a campaign, by their index there, and what is done of them.
struct Work<'a> {
    shard: Shard,
    /// When the time is up, if there is one.
    deadline: Option<Instant>,
    checkpoint: Option<&'a Checkpoint>,
    state: Mutex<State>,
    changed: Condvar,
}

struct State {
    /// The next unit to be given out.
    next: u64,
    /// The unit after the last one.
    end: u64,
    /// The units before this one are in the ledger.
    added: u64,
    ledger: Ledger,
    /// Units that are done before one that comes before them.
    early: BTreeMap<u64, Ledger>,
    /// A thread has panicked.
    lost: bool,
}

impl<'a> Work<'a> {
    fn new(plan: &Plan, campaign: &Campaign, course: &Course<'a>) -> Self {
        let shard = course.shard.unwrap_or(Shard { number: 1, of: 1 });
        let begun = course.checkpoint.map(|checkpoint| checkpoint.begun()).unwrap_or_default();
        let units = match course.time {
            Some(_) => plan.units_of_rounds(campaign.programs.max(plan.generated(begun.units))),
            None => plan.units(),
        };
        // The units with this rest, counted.
        let end = (units + shard.of - shard.number) / shard.of;
        let deadline = course.time.map(|time| Instant::now() + time.saturating_sub(begun.spent));
        let (added, ledger) = (begun.units, begun.ledger);
        let state = State { next: added, end, added, ledger, early: BTreeMap::new(), lost: false };
        let (state, changed) = (Mutex::new(state), Condvar::new());
        Work { shard, deadline, checkpoint: course.checkpoint, state, changed }
    }

    /// The number of the unit with this index.
    fn unit(&self, index: u64) -> u64 {
        self.shard.number - 1 + index * self.shard.of
    }

    fn locked(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next unit; none when there are no more.
    fn take(&self) -> Option<u64> {
        let mut state = self.locked();
        loop {
            if state.lost {
                return None;
            }
            if state.next >= state.end {
                if self.deadline.is_none_or(|deadline| Instant::now() >= deadline) {
                    return None;
                }
                state.end += Plan::round();
            }
            if state.next < state.added + MOST_AHEAD {
                state.next += 1;
                return Some(state.next - 1);
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Adds what a unit gave.
    fn add(&self, index: u64, ledger: Ledger) {
        let mut state = self.locked();
        state.early.insert(index, ledger);
        let State { added, ledger, early, .. } = &mut *state;
        while let Some(next) = early.remove(added) {
            ledger.merge(next);
            *added += 1;
        }
        if let Some(checkpoint) = self.checkpoint {
            checkpoint.keep(state.added, &state.ledger);
        }
        self.changed.notify_all();
    }
}

/// Tells the other threads of a panic, so that none waits for a unit that will not come.
struct Watch<'a>(&'a Work<'a>);

impl Drop for Watch<'_> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.locked().lost = true;
            self.0.changed.notify_all();
        }
    }
}

impl Shard {
    /// Reads `i/n`.
    ///
    /// # Errors
    ///
    /// A text that is not of this form, or a part that there is not.
    pub fn parse(text: &str) -> Result<Shard, String> {
        let numbers = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        let (number, of): (u64, u64) = numbers.ok_or("a shard is i/n, such as 1/8")?;
        if !(1..=MOST_SHARDS).contains(&of) {
            return Err(format!("there are 1 to {MOST_SHARDS} shards"));
        }
        if !(1..=of).contains(&number) {
            return Err(format!("of {of} shards there is no number {number}: they count from 1"));
        }
        Ok(Shard { number, of })
    }
}

/// The most parts of a campaign.
const MOST_SHARDS: u64 = 10_000;

/// What a checkpoint gives a campaign to begin with.
#[derive(Default)]
pub(super) struct Begun {
    /// So many units are done.
    pub(super) units: u64,
    /// In so much time.
    pub(super) spent: Duration,
    pub(super) ledger: Ledger,
}
