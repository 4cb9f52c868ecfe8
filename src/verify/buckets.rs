//! The four buckets of programs, against the verdicts, the causes, the clauses and the decisions.

use crate::report::{Buckets, ClauseTallyRecord, Report};

/// The verdicts of a device that passes.
const PASS: [&str; 3] = ["exact", "admissible", "admissible-without-witness"];
/// The verdict of a device that neither passes nor fails.
const UNSUPPORTED: &str = "unsupported";
/// The verdicts of a device whose answer diverges at a clause.
const DIVERGENT: [&str; 2] = ["inadmissible", "fork-limit"];

/// The counts of the buckets that do not agree with the rest of the report.
pub(super) fn contradictions(report: &Report) -> Vec<String> {
    let mut found = Vec::new();
    let counts = report.counts;
    let mut equal = |told: &str, count: u64, due: u64| {
        if count != due {
            found.push(format!("{count} {told}, not {due}"));
        }
    };
    let of = |ids: &[&str]| sum(report.tally.verdicts.iter().filter(|(id, _)| ids.contains(&&***id)).map(|(_, n)| *n));
    let red = |id: &&String| !PASS.contains(&&***id) && *id != UNSUPPORTED;
    let red = sum(report.tally.verdicts.iter().filter(|(id, _)| red(id)).map(|(_, count)| *count));
    equal("programs are said to pass, by their verdicts", counts.pass, of(&PASS));
    equal("programs are said to be unsupported, by their verdicts", counts.unsupported, of(&[UNSUPPORTED]));
    let failed = counts.fail.saturating_add(counts.expected_failure);
    equal("programs are said to fail or to be expected to, by their verdicts", failed, red);
    let waived = sum(report.expected_failures.iter().map(|waiver| waiver.programs));
    equal("expected failures are counted, by the waivers", counts.expected_failure, waived);
    let causes = sum(report.causes.iter().map(|cause| cause.programs));
    equal("programs are said to fail, by the causes", counts.fail, causes);
    let clauses = &report.tally.clauses;
    let divergent = sum(clauses.values().map(|clause| clause.failed.saturating_add(clause.expected_failures)));
    equal("programs diverge at some clause, by the verdicts", divergent, of(&DIVERGENT));
    let waived = sum(clauses.values().map(|clause| clause.expected_failures));
    equal("expected failures are told clause by clause, by the waivers", waived, counts.expected_failure);
    found.extend(clauses.iter().filter_map(|(id, clause)| wrong_clause(id, clause, counts)));
    found.extend(wrong_sides(report));
    found.extend(report.cases.iter().filter_map(|case| {
        let waiver = report.expected_failures.get(case.waiver?);
        let fits = waiver.zip(case.divergence.as_ref()).is_some_and(|(waiver, at)| waiver.clause == at.clause);
        (!fits).then(|| format!("{} is said to be waived, but no waiver is for its clause", case.name))
    }));
    found
}

/// A clause whose programs do not add up.
fn wrong_clause(id: &str, clause: &ClauseTallyRecord, counts: Buckets) -> Option<String> {
    let settled = clause.passed.saturating_add(clause.unsupported);
    let all_settled = counts.fail == 0 && counts.expected_failure == 0;
    let wrong = settled > clause.programs || (all_settled && settled != clause.programs);
    wrong.then(|| format!("{id}: {settled} of {} programs passed or are unsupported", clause.programs))
}

/// Decisions whose programs do not add up: each program takes a decision that it is counted at.
fn wrong_sides(report: &Report) -> Vec<String> {
    let (sides, decisions) = (&report.tally.sides, &report.tally.decisions);
    let mut found = Vec::new();
    for id in sides.keys().chain(decisions.keys().filter(|id| !sides.contains_key(*id))) {
        let programs = sides.get(id).copied().unwrap_or_default();
        let taken = decisions.get(id).copied().unwrap_or_default();
        for (programs, taken) in programs.into_iter().zip(taken) {
            let sum = programs.sum();
            if sum > taken || (sum == 0) != (taken == 0) || exceeds(programs, report.counts) {
                found.push(format!("{id}: {sum} programs take {taken} decisions of one side"));
            }
        }
    }
    found
}

/// Whether a part is larger than its whole.
fn exceeds(part: Buckets, whole: Buckets) -> bool {
    part.pass > whole.pass
        || part.fail > whole.fail
        || part.expected_failure > whole.expected_failure
        || part.unsupported > whole.unsupported
}

fn sum(counts: impl Iterator<Item = u64>) -> u64 {
    counts.fold(0, u64::saturating_add)
}
