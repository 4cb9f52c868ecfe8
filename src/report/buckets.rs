//! The four buckets that every judged program falls into.

use serde::{Deserialize, Serialize};

/// Programs by what came of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Buckets {
    /// Judged exact or admissible.
    pub pass: u64,
    /// Red.
    pub fail: u64,
    /// Red, and waived: the clause and the reason stand in the waiver.
    pub expected_failure: u64,
    /// The device says that it does not support something in it.
    pub unsupported: u64,
}

/// One of the four.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "each is the field of Buckets with its name")]
pub enum Bucket {
    Pass,
    Fail,
    ExpectedFailure,
    Unsupported,
}

impl Buckets {
    /// Counts one program.
    pub fn count(&mut self, bucket: Bucket) {
        *match bucket {
            Bucket::Pass => &mut self.pass,
            Bucket::Fail => &mut self.fail,
            Bucket::ExpectedFailure => &mut self.expected_failure,
            Bucket::Unsupported => &mut self.unsupported,
        } += 1;
    }

    /// Adds the counts of another part.
    pub fn merge(&mut self, other: Buckets) {
        self.pass += other.pass;
        self.fail += other.fail;
        self.expected_failure += other.expected_failure;
        self.unsupported += other.unsupported;
    }

    /// All programs; the largest count if there are more than a `u64` holds.
    pub fn sum(&self) -> u64 {
        [self.fail, self.expected_failure, self.unsupported].into_iter().fold(self.pass, u64::saturating_add)
    }
}
