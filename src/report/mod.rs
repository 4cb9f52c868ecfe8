//! The machine-readable report of a certification: what was judged, and for every answer that was not exact the
//! program, the answer, the verdict and, where there is one, the witness.
//!
//! A report stands alone. It carries the control's profile and the two budgets, so that a checker needs neither
//! a profile file nor the device. `report.schema.json` beside this file is its published form ([`SCHEMA`]).
//!
//! Numbers that count are strings. Those of a program are exact: a decimal where there is a finite one, else `p/q`.
//! Those of a device's answer, margins and budgets are `f64`, written as the shortest decimal whose nearest `f64` they
//! are, or `NaN`, `inf`, `-inf`: they come back bit for bit (the payload of a NaN apart). JSON's own numbers promise
//! neither, and stand for counts, indices and the seed only. Lengths are in millimetres, coordinates in the plane
//! `(a, b)` of [TRC-PLANE-01]; blocks are counted from 0.

mod answer;
mod block;
mod buckets;
mod case;
mod cause;
mod device;
mod document;
mod error;
mod hash;
mod junit;
mod number;
mod page;
mod parameters;
mod profile;
mod reasons;
mod replay;
mod tally;
mod text;
mod word;

pub use answer::{AlarmRecord, AnswerRecord, SegmentRecord, StepRecord};
pub use block::{BlockRecord, CentreRecord, MovementRecord};
pub use buckets::{Bucket, Buckets};
pub use case::{Case, Cases, DivergenceRecord, FlipRecord, MOST_CASES, MOST_RED_CASES, case};
pub use cause::{BrokenRecord, Cause, NearestRecord};
pub use device::{DeviceRecord, FileRecord};
pub use document::{ExpectedFailure, FORMAT, GradeRecord, Head, MOST_BYTES, Report, SCHEMA, ShardRecord};
pub use error::ReportError;
pub use hash::{hex, sha256, sha256_of_file};
pub use junit::junit;
pub use number::{Binary, Exact, MOST_DIGITS};
pub use page::page;
pub use parameters::ParametersRecord;
pub use profile::profile_text;
pub use reasons::{MOST_REASONS, Reasons};
pub use replay::replay;
pub use tally::{ClauseTallyRecord, TallyRecord};
pub use word::{Id, Word};
