//! A checker of reports that shares no code with the judge.
//!
//! The judge looks for witnesses and for admitted outcomes, in `f64` where that is quick. What it found is easier to check
//! than to find, and is checked here again from the report alone: by the exact model, with every distance and every
//! margin compared exactly, by other code. Of the toolkit it uses the reader of reports; of the judge nothing.
//!
//! What a confirmed case means, `E(x)` being the exact outcome of program x, β and δ the budgets that the report's own
//! grade gives:
//!
//! | verdict | what is checked |
//! |---|---|
//! | `exact` | the answer is E(x) to within δ |
//! | `admissible` | the witness x′ differs from x in numbers only, none by more than β, and the answer is E(x′) to within δ |
//! | `admissible-without-witness` | the answer is, to within δ, the outcome on some combination of branches in the band |
//! | `inadmissible` | the answer is neither E(x) to within δ nor the outcome on any combination of branches in the band |
//! | `fork-limit` | the same, for as many combinations as are looked at |
//!
//! A combination of branches in the band answers each decision whose exact margin is at most β in magnitude in one of
//! the three ways, and every other decision exactly. What *to within δ* means stands in `walk.rs`.
//!
//! What is not claimed: that an inadmissible answer is E(x′) of no x′ at all, as points may move without any branch
//! being taken another way; that an outcome on other branches is E(x′) of some x′; anything of a program that the report
//! does not hold, of the clauses that the device names, of divergences, flips, causes and broken relations, which are
//! told for people; and that the answer is the device's.

mod branches;
mod buckets;
mod check;
mod head;
mod path;
mod profile;
mod walk;
mod witness;

use std::collections::BTreeMap;

pub use branches::MOST_RUNS;
pub use check::Finding;
pub use profile::LEAST_PROGRAMS;

use crate::report::{Case, Report};

/// What came of checking a report.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// What the report says of itself and is not so.
    pub contradictions: Vec<String>,
    /// Cases by verdict.
    pub verdicts: BTreeMap<String, Count>,
}

/// Cases of one verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Confirmed.
    pub confirmed: u64,
    /// Not confirmed.
    pub refuted: u64,
    /// Without anything to check.
    pub unchecked: u64,
}

impl Summary {
    /// Whether everything that can be checked is confirmed.
    pub fn is_confirmed(&self) -> bool {
        self.contradictions.is_empty() && self.verdicts.values().all(|count| count.refuted == 0)
    }
}

/// Checks a report; `each` hears of every case.
pub fn verify(report: &Report, mut each: impl FnMut(&Case, &Finding)) -> Summary {
    let mut summary = Summary { contradictions: head::contradictions(report), verdicts: BTreeMap::new() };
    for case in &report.cases {
        let finding = check::check(report, case);
        let count = summary.verdicts.entry(case.verdict.clone()).or_default();
        match finding {
            Finding::Confirmed => count.confirmed += 1,
            Finding::NotConfirmed(_) => count.refuted += 1,
            Finding::NothingToCheck => count.unchecked += 1,
        }
        each(case, &finding);
    }
    summary
}
