//! Certificates: a short signed statement of what a green report supports, and of what it does not.
//!
//! The signature is Ed25519 over the statement's JSON without white space, its fields in the order in which they are
//! declared. It tells who made the statement. That the statement is of a report, and that the report is complete, the
//! verifier finds out itself: see [`objections`].

mod check;
mod key;
mod page;
mod statement;

pub use check::{objections, objections_to_report};
pub use key::{Key, KeyError};
pub use page::page;
pub use statement::{BARE_ADMISSIBLE, Certificate, Claim, FORMAT, LIMITS, Statement};
