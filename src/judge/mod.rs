//! The judge: is a device's answer one that the rules admit?
//!
//! `E(x)` is the exact outcome of program x. A device works in floating point, so at a decision whose margin lies
//! within the band β it may take either branch; elsewhere it may not; and no point may lie farther than δ from where
//! the branch taken puts it. The judge runs the model, and where the answer differs, again with every combination of
//! branches inside the band, up to a bound.

mod budget;
mod compare;
mod fork;
mod influence;
mod stroke;
mod verdict;
mod witness;

pub use budget::{Budget, Grade};
pub(crate) use compare::path_difference;
pub use compare::{Difference, Divergence};
pub use fork::Flip;
pub(crate) use stroke::Tolerance;
pub use stroke::{Shape, Stroke};
pub use verdict::{Judged, VERDICTS, Verdict, judge, judge_answer};
pub use witness::Witness;
