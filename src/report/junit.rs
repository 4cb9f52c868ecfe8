//! A report as JUnit XML, for continuous integration.

use quick_junit::{NonSuccessKind, Report as Suites, TestCase, TestCaseStatus, TestSuite};
use radcomp_spec::clause;

use super::cause::Cause;
use super::document::Report;
use super::replay::replay;
use super::tally::ClauseTallyRecord;

/// The verdicts without an answer, each a test case of its own.
const FAULTS: [&str; 4] = ["crash", "timeout", "no-answer", "garbled"];

/// The report as JUnit XML: a test case for each clause, for each way of giving no answer, and for the relations between
/// moved programs. A clause that no program reaches, that the device does not support, or all of whose failures are
/// expected is skipped, with the reason. `file` is the report's file name, for the commands that it tells.
///
/// # Errors
///
/// If the XML cannot be written, in words.
pub fn junit(report: &Report, file: &str) -> Result<String, String> {
    let mut suites = Suites::new(format!("radcomp certify {}, profile {}", report.device, report.profile));
    let mut clauses = TestSuite::new("clauses");
    for (clause, title) in clause::ALL {
        let tally = report.tally.clauses.get(clause.id()).cloned().unwrap_or_default();
        let mut case = TestCase::new(format!("{} {title}", clause.id()), status(report, file, clause.id(), &tally));
        case.set_classname(format!("radcomp.{}", report.profile));
        clauses.add_test_case(case);
    }
    suites.add_test_suite(clauses);
    let mut answers = TestSuite::new("answers");
    for fault in FAULTS {
        let count = report.tally.verdicts.get(fault).copied().unwrap_or_default();
        let told = report.causes.iter().find(|cause| cause.cause == fault).map(|cause| told(cause, file));
        let status = if count == 0 { passed() } else { failed(&format!("{count} programs"), told) };
        let mut case = TestCase::new(format!("no {fault}"), status);
        case.set_classname(format!("radcomp.{}", report.profile));
        answers.add_test_case(case);
    }
    let told =
        report.broken.first().map(|broken| format!("{} {}: {}", broken.name, broken.relation, broken.difference));
    let status = match report.tally.broken {
        0 => passed(),
        count => failed(&format!("{count} relations broken"), told),
    };
    let mut case = TestCase::new("moved, mirrored, scaled, rotated, split and reversed programs", status);
    case.set_classname(format!("radcomp.{}", report.profile));
    answers.add_test_case(case);
    suites.add_test_suite(answers);
    suites.to_string().map_err(|error| error.to_string())
}

fn status(report: &Report, file: &str, id: &str, tally: &ClauseTallyRecord) -> TestCaseStatus {
    if tally.failed > 0 {
        let causes = report.causes.iter().filter(|cause| cause.clause.is_some_and(|clause| clause.0.id() == id));
        let told = causes.map(|cause| told(cause, file));
        let told = told.collect::<Vec<_>>().join("\n");
        return failed(&format!("{} of {} programs", tally.failed, tally.programs), Some(told));
    }
    if tally.expected_failures > 0 {
        let waivers = report.expected_failures.iter().filter(|waiver| waiver.clause.0.id() == id);
        let reasons: Vec<_> = waivers.map(|waiver| waiver.reason.as_str()).collect();
        return skipped(&format!("{} expected failures: {}", tally.expected_failures, reasons.join("; ")));
    }
    match (tally.programs, tally.unsupported) {
        (0, _) => skipped("no program reaches it"),
        (programs, unsupported) if programs == unsupported => skipped("not supported"),
        _ => passed(),
    }
}

/// A cause: what differs, the clause's sentence, the nearest decision, the safety verdict, the program, how to replay it.
fn told(cause: &Cause, file: &str) -> String {
    let mut lines = vec![format!("{} ({} programs)", cause.cause, cause.programs), cause.smallest.clone()];
    lines.extend(cause.sentence.clone());
    if let Some(nearest) = &cause.nearest {
        let (decision, block, margin) = (nearest.decision.0.id(), nearest.block + 1, nearest.margin_mm.text());
        lines.push(format!("nearest decision: {decision} at N{block}, margin {margin} mm"));
    }
    lines.push(format!("safety: {}", cause.safety.as_deref().unwrap_or("no path to judge")));
    lines.extend(cause.program.clone());
    lines.push(format!("replay: {}", replay(file, &cause.cause)));
    lines.join("\n")
}

fn passed() -> TestCaseStatus {
    TestCaseStatus::success()
}

fn skipped(reason: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::skipped();
    status.set_message(reason);
    status
}

fn failed(message: &str, told: Option<String>) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(message);
    if let Some(told) = told {
        status.set_description(told);
    }
    status
}
