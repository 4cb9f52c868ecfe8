//! Certification: a device against the vectors and the generated programs of a level.

mod campaign;
mod checkpoint;
mod course;
mod failure;
mod ledger;
mod merge;
mod plan;
mod programs;
mod record;
mod recorded;
mod reported;
mod safety;
mod smallest;
mod tally;
mod waivers;

pub use campaign::{Campaign, Level, Outcome, certify, certify_on};
pub use checkpoint::Checkpoint;
pub use course::{Course, MOVED_ONE_IN, Shard};
pub use failure::{Failure, Told, group};
pub use merge::{campaign_of, merge};
pub use plan::{Place, ROUND};
pub use programs::{named_programs, programs, recount};
pub use record::LedgerRecord;
pub use recorded::Recorded;
pub use safety::Safety;
pub use tally::{ClauseTally, Tally};
pub use waivers::{Waiver, WaiverError, Waivers};
