//! What stands against a certificate.

use radcomp_spec::profile::Profile;

use super::statement::{Certificate, Statement};
use crate::certify::{named_programs, recount};
use crate::report::{Report, TallyRecord};
use crate::verify::verify;

/// Everything that stands against a certificate of a report whose file has this hash. `whole` also runs every program of
/// the level again by the model, which takes about as long as the campaign, and compares the counts.
pub fn objections(certificate: &Certificate, report: &Report, report_sha256: &str, whole: bool) -> Vec<String> {
    let mut found = Vec::new();
    if !certificate.is_signed() {
        found.push("the signature is not that of the statement".to_owned());
    }
    if certificate.statement.report_sha256 != report_sha256 {
        found.push("the certificate is of another report: the hashes differ".to_owned());
    }
    if certificate.statement != Statement::of(report, &certificate.statement.report_sha256) {
        found.push("the statement is not what the report says".to_owned());
    }
    found.extend(objections_to_report(report, whole));
    found
}

/// Why there can be no certificate of a report: it is red, it contradicts itself, or it is not a whole level.
pub fn objections_to_report(report: &Report, whole: bool) -> Vec<String> {
    let summary = verify(report, |_, _| {});
    let mut found = summary.contradictions.clone();
    if !summary.is_confirmed() && found.is_empty() {
        found.push("a case is not confirmed; `radcomp verify-witness` tells which".to_owned());
    }
    let mut demand = |holds: bool, otherwise: &str| {
        if !holds {
            found.push(otherwise.to_owned());
        }
    };
    demand(report.level.is_some(), "the report is of no level");
    demand(report.shard.is_none(), "the report is of a part of the campaign; `radcomp merge` puts the parts together");
    demand(report.red == 0, "the report is red");
    demand(report.causes.is_empty() && report.broken.is_empty(), "the report holds failures");
    demand(report.counts.pass > 0, "no program has passed");
    demand(report.expected_failures.iter().all(|waiver| waiver.programs > 0), "a waiver covers no failure");
    let Ok(profile) = Profile::parse(&report.profile_file, &report.profile) else { return found };
    let due = named_programs(&profile, report.seed, report.generated_programs, report.grade.into())
        + report.generated_programs;
    if report.tally.programs != due {
        found.push(format!("{} programs were judged, the level has {due}", report.tally.programs));
    } else if whole && found.is_empty() {
        let due = TallyRecord::from(&recount(&profile, report.seed, report.generated_programs, report.grade.into()));
        found.extend(miscounted(&report.tally, &due));
    }
    found
}

/// The counts that do not depend on the device, compared with those of the model.
fn miscounted(told: &TallyRecord, due: &TallyRecord) -> Vec<String> {
    let mut found = Vec::new();
    if (told.blocks, told.corners) != (due.blocks, due.corners) {
        found.push("the blocks and corners are not those of the level's programs".to_owned());
    }
    if told.decisions != due.decisions {
        found.push("the decisions are not those of the level's programs".to_owned());
    }
    let sums = |tally: &TallyRecord| {
        let sums = tally.sides.iter().map(|(id, sides)| (id.clone(), sides.map(|buckets| buckets.sum())));
        sums.collect::<Vec<_>>()
    };
    if sums(told) != sums(due) {
        found.push("the programs that take the decisions are not those of the level".to_owned());
    }
    let counts = |tally: &TallyRecord| {
        let counts = tally.clauses.iter();
        let counts = counts.map(|(id, c)| (id.clone(), [c.programs, c.elements, c.alarms, c.decisions]));
        // A clause at which programs only diverge is none of the model's.
        counts.filter(|(_, counts)| *counts != [0; 4]).collect::<Vec<_>>()
    };
    if counts(told) != counts(due) {
        found.push("the counts by clause are not those of the level's programs".to_owned());
    }
    found
}
