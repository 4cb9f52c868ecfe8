//! What a campaign judges, and what came of it.

use std::collections::BTreeMap;

use radcomp_spec::profile::Profile;

use super::course::{Course, Shard};
use super::failure::{Failure, Told};
use super::record::LedgerRecord;
use super::tally::Tally;
use super::waivers::Waivers;
use super::{course, smallest};
use crate::device::Device;
use crate::judge::Budget;
use crate::report::{BrokenRecord, Cases, ShardRecord};

/// How much is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Vectors, boundary triples and generated programs; seconds.
    One,
    /// More of them; minutes.
    Two,
    /// As many as the time allows, and at least twenty times as many; hours.
    Three,
}

impl Level {
    /// The level with this number.
    pub const fn of(number: u8) -> Option<Level> {
        match number {
            1 => Some(Level::One),
            2 => Some(Level::Two),
            3 => Some(Level::Three),
            _ => None,
        }
    }

    /// How many generated programs the level asks for; more may be judged, never fewer.
    pub const fn programs(self) -> u64 {
        match self {
            Level::One => 24_000,
            Level::Two => 480_000,
            Level::Three => 4_800_000,
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
    /// How many generated programs the campaign had: those of [`Campaign`], or more if it ran until its time was up.
    pub programs: u64,
    /// The counts.
    pub tally: Tally,
    /// Failed programs, in order; at most 200.
    pub failures: Vec<Told>,
    /// Relations between moved programs that the device broke, with the number of the program; at most 200.
    pub broken: Vec<(u64, BrokenRecord)>,
    /// Programs whose answer was not exact, for the report.
    pub cases: Cases,
    /// Programs that a waiver covers, by its place.
    pub expected: BTreeMap<usize, u64>,
    /// Failures of one cause: the group's name, how many, and the smallest program found; most frequent first.
    pub groups: Vec<(String, u64, Failure)>,
}

/// Judges a device. `make` makes one for each thread; `progress` hears how many programs are done.
pub fn certify<D: Device>(campaign: &Campaign, make: impl Fn() -> D + Sync, progress: impl Fn(u64) + Sync) -> Outcome {
    certify_on(campaign, &Course::default(), make, progress).0
}

/// Judges a device on a part of the campaign, until a time is up, or from a checkpoint on. Of a part, what the report needs
/// that is merged with those of the others comes with the outcome.
pub fn certify_on<D: Device>(
    campaign: &Campaign,
    course: &Course<'_>,
    make: impl Fn() -> D + Sync,
    progress: impl Fn(u64) + Sync,
) -> (Outcome, Option<ShardRecord>) {
    let (mut ledger, programs) = course::run(campaign, course, &make, progress);
    // Which causes are the most frequent ones is known when all parts are there.
    let most = if course.shard.is_some() { usize::MAX } else { smallest::MOST_GROUPS };
    smallest::make_small(&mut ledger.groups, most, campaign, &mut make());
    let shard = course.shard.map(|Shard { number, of }| {
        let ledger = LedgerRecord::from(&ledger);
        ShardRecord { number, of, ledger }
    });
    (smallest::told(ledger, programs, campaign), shard)
}
