//! Certification: a device against the vectors and the generated programs of a level.

mod campaign;
mod failure;
mod programs;
mod recorded;
mod reported;
mod safety;
mod tally;
mod waivers;

pub use campaign::{Campaign, Level, MOVED_ONE_IN, Outcome, TRIPLE_ONE_IN, certify};
pub use failure::Failure;
pub use programs::{named_programs, programs, recount};
pub use recorded::Recorded;
pub use safety::Safety;
pub use tally::{ClauseTally, Tally};
pub use waivers::{Waiver, WaiverError, Waivers};
