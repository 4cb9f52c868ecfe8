//! What a report says of itself: its counts and its budgets.

use std::collections::BTreeMap;

use radcomp_model::number::nearest_f64;
use radcomp_spec::Block;
use rug::Rational;

use super::{buckets, profile, witness};
use crate::report::{GradeRecord, Report};

/// The band that the report's grade gives a program.
pub(super) fn band(report: &Report, program: &[Block<Rational>]) -> f64 {
    match report.grade {
        GradeRecord::Binary64 => nearest_f64(&witness::largest(program)) / (1_u64 << 40) as f64,
        GradeRecord::Resolution => report.least_increment_mm.0 / 2.0,
    }
}

/// The counts that do not agree with each other or with the cases.
pub(super) fn contradictions(report: &Report) -> Vec<String> {
    let mut found = Vec::new();
    let verdicts = &report.tally.verdicts;
    let sum = |counts: &mut dyn Iterator<Item = &u64>| counts.fold(0_u64, |sum, count| sum.saturating_add(*count));
    let judged = sum(&mut verdicts.values());
    if judged != report.tally.programs {
        found.push(format!("{} programs were judged, but there are {judged} verdicts", report.tally.programs));
    }
    let (failed, broken) = (report.counts.fail, report.tally.broken);
    if failed.saturating_add(broken) != report.red {
        found.push(format!(
            "{} failures are told, but {failed} programs failed and {broken} relations are broken",
            report.red
        ));
    }
    found.extend(buckets::contradictions(report));
    found.extend(profile::contradictions(report));
    let not_exact = sum(&mut verdicts.iter().filter(|(id, _)| *id != "exact").map(|(_, count)| count));
    let given = report.cases.iter().filter(|case| case.verdict != "exact").count();
    let cases = report.cases_left_out.saturating_add(given as u64);
    if not_exact != cases {
        found.push(format!("{not_exact} answers were not exact, but {cases} cases are given or left out"));
    }
    found.extend(share(report));
    let mut given = BTreeMap::new();
    for case in &report.cases {
        *given.entry(case.verdict.as_str()).or_insert(0_u64) += 1;
    }
    for (id, count) in given {
        let counted = verdicts.get(id).copied().unwrap_or_default();
        if count > counted {
            found.push(format!("{count} cases are {id}, but {counted} were counted"));
        }
    }
    found
}

/// What is wrong with the share of the band that the report says is needed: the cases tell it, if all are given.
fn share(report: &Report) -> Option<String> {
    let said = report.needed_share_of_beta.map(|share| share.0);
    if report.red > 0 {
        return said.map(|share| format!("the device fails, but is said to pass with {share:?} of the band"));
    }
    let Some(said) = said else { return Some("the device passes, but the share of the band is not given".to_owned()) };
    let shares = report.cases.iter().map(|case| match (case.verdict.as_str(), case.change_mm) {
        ("admissible", Some(change)) => change.0 / case.beta_mm.0,
        // What a witness took is not told: it says nothing here.
        ("exact" | "admissible" | "unsupported", _) => 0.0,
        _ if case.waiver.is_some() => 0.0,
        _ => 1.0,
    });
    let due = shares.fold(0.0, f64::max);
    let bare = report.tally.verdicts.get("admissible-without-witness").is_some_and(|count| *count > 0);
    let due = if bare { 1.0 } else { due };
    // A case that was left out may need more.
    let wrong = if report.cases_left_out == 0 { said != due } else { said < due || said.is_nan() };
    wrong.then(|| format!("{said:?} of the band is said to be enough, the cases need {due:?}"))
}
