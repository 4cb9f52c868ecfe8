//! What a clause lacks. The tests refuse every gap that is not excused here, each with its reason.

use super::{Ledger, Row};

/// A gap that is known, and why it stands.
#[derive(Clone, Copy, Debug)]
pub struct Excuse {
    /// The clause.
    pub clause: &'static str,
    /// What it lacks.
    pub lacks: &'static str,
    /// Why.
    pub reason: &'static str,
}

const IN_THE_READER: &str = "the program reader does it; the others see what it leads to";
const AN_ADVISORY: &str = "it is a warning alone, and the implementation gives none";
const OF_THE_TIP: &str = "the implementation gives the path of the nose centre and does not follow the tip";
const WITHOUT_TRACE: &str = "no step, decision or alarm carries its id, so that nothing can count its use; its own worked \
     examples are its tests, met exactly by model, reader and implementation";

/// Every gap that is known.
pub const EXCUSES: &[Excuse] = &[
    Excuse { clause: "TRC-PLANE-01", lacks: "model function", reason: IN_THE_READER },
    Excuse { clause: "TRC-PLANE-03", lacks: "model function", reason: IN_THE_READER },
    Excuse { clause: "TRC-PLANE-05", lacks: "model function", reason: IN_THE_READER },
    Excuse { clause: "TRC-DUMMY-05", lacks: "model function", reason: IN_THE_READER },
    Excuse { clause: "TRC-PLANE-03", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-PLANE-05", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-DUMMY-05", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-MODE-09", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-CANCEL-07", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-TIP-02", lacks: "implementation", reason: IN_THE_READER },
    Excuse { clause: "TRC-LOOK-06", lacks: "implementation", reason: AN_ADVISORY },
    Excuse { clause: "TRC-DUMMY-03", lacks: "implementation", reason: AN_ADVISORY },
    Excuse { clause: "TRC-WEDGE-01", lacks: "implementation", reason: AN_ADVISORY },
    Excuse { clause: "TRC-TIP-01", lacks: "implementation", reason: OF_THE_TIP },
    Excuse { clause: "TRC-TIP-03", lacks: "implementation", reason: OF_THE_TIP },
    Excuse { clause: "TRC-PLANE-01", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-PLANE-03", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-MODE-09", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-DUMMY-05", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-TIP-02", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-TIP-03", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-PLANE-02", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-PLANE-04", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-MODE-02", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-START-01", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-CORNER-12", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-SIDE-08", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-LOOK-04", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-LOOK-07", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-LOOK-08", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-DUMMY-04", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-ARC-01", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-ARC-04", lacks: "test by name", reason: WITHOUT_TRACE },
    Excuse { clause: "TRC-ARC-08", lacks: "test by name", reason: WITHOUT_TRACE },
];

/// The gaps of every clause that no excuse covers, and the excuses that cover none.
pub fn gaps(ledger: &Ledger) -> Vec<String> {
    let mut gaps = Vec::new();
    let mut used = vec![false; EXCUSES.len()];
    for row in &ledger.rows {
        for lacks in lacking(row) {
            match EXCUSES.iter().position(|excuse| excuse.clause == row.clause && excuse.lacks == lacks) {
                Some(place) => used[place] = true,
                None => gaps.push(format!("{} has no {lacks} ({}:{})", row.clause, row.file, row.line)),
            }
        }
    }
    for (excuse, _) in EXCUSES.iter().zip(&used).filter(|(_, used)| !**used) {
        gaps.push(format!("{} has its {}: the excuse in src/evidence/gaps.rs can go", excuse.clause, excuse.lacks));
    }
    gaps
}

/// What a clause lacks, by name.
fn lacking(row: &Row) -> Vec<&'static str> {
    let mut lacks = Vec::new();
    if row.model.is_empty() {
        lacks.push("model function");
        if row.reader.is_empty() {
            lacks.push("function of the reader");
        }
    }
    if row.implementation.is_empty() {
        lacks.push("implementation");
    }
    if !row.exercise.used && row.tests.is_empty() {
        lacks.push("test by name");
    }
    if row.exercise.examples == 0 {
        lacks.push("example");
    }
    lacks
}
