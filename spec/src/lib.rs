//! The words that model, implementation and toolkit of radcomp share: blocks, paths, alarms, parameters and the
//! clauses that code cites. There is no arithmetic here: the model and the implementation each read the rules for
//! themselves, and all that they have in common is this vocabulary.
//!
//! Without the feature `std` the crate is `no_std` and holds the words alone; with it come the profile files
//! ([`profile`]) and the text of the clauses ([`catalogue`]).

#![cfg_attr(not(feature = "std"), no_std)]

pub mod block;
#[cfg(feature = "std")]
pub mod catalogue;
pub mod clause;
pub mod decision;
pub mod outcome;
pub mod parameters;
#[cfg(feature = "std")]
pub mod profile;

pub use block::{Block, Centre, Compensation, Direction, Movement, Side};
pub use clause::Clause;
pub use decision::DecisionKind;
pub use outcome::{Advisory, AdvisoryKind, Alarm, AlarmKind, Segment, Step};
pub use parameters::{Approach, OuterCorner, Parameters};
