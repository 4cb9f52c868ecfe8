//! Certificates: what is signed, and what does not verify.

use std::sync::LazyLock;

use radcomp::certificate::{Certificate, Key, Statement, objections, objections_to_report, page};
use radcomp::certify::{Level, certify};
use radcomp::device::Builtin;
use radcomp::report::{Case, DeviceRecord, Report, sha256};

use crate::campaigns::{campaign, faulty, sound};

/// The report of the implementation on the whole of level 1.
fn whole() -> &'static Report {
    static REPORT: LazyLock<Report> = LazyLock::new(|| {
        let mut campaign = campaign("");
        campaign.programs = Level::One.programs();
        let outcome = certify(&campaign, || Builtin, |_| {});
        outcome.report(&DeviceRecord::named("builtin"), Some(1), &campaign)
    });
    &REPORT
}

fn hash(report: &Report) -> String {
    let mut text = Vec::new();
    report.write(&mut text).unwrap();
    sha256(&text)
}

fn signed(report: &Report) -> Certificate {
    Certificate::sign(Statement::of(report, &hash(report)), &Key::generate().unwrap()).unwrap()
}

/// What stands against a report that was changed: under the certificate of the report as it was, and under one that
/// whoever changed it has signed.
#[track_caller]
fn does_not_verify(change: impl Fn(&mut Report), because: &str) {
    let mut changed = whole().clone();
    change(&mut changed);
    let found = objections(&signed(whole()), &changed, &hash(&changed), false);
    assert!(found.iter().any(|found| found.contains("hashes differ")), "{found:?}");
    let found = objections(&signed(&changed), &changed, &hash(&changed), false);
    assert!(found.iter().any(|found| found.contains(because)), "{found:?}");
}

#[test]
fn a_whole_green_report_verifies() {
    let certificate = signed(whole());
    assert_eq!(objections(&certificate, whole(), &hash(whole()), false), Vec::<String>::new());
    let html = page(&certificate).unwrap();
    let theorem = certificate.statement.theorem.replace('\'', "&#x27;");
    assert!(html.contains(&theorem) && html.contains(&certificate.signature), "{html}");
}

#[test]
fn a_lowered_level_does_not_verify() {
    does_not_verify(|report| report.level = Some(2), "level 2 has 480000");
    does_not_verify(|report| report.level = None, "of no level");
    does_not_verify(|report| report.generated_programs -= 1, "level 1 has 24000");
    let fewer = |report: &mut Report| {
        report.tally.programs -= 1;
        report.counts.pass -= 1;
        *report.tally.verdicts.get_mut("exact").unwrap() -= 1;
    };
    does_not_verify(fewer, "the level has");
    // A run of fewer programs that is said to be a level.
    let short = Report { level: Some(1), ..sound().clone() };
    assert!(objections_to_report(&short, false).iter().any(|found| found.contains("24000")));
}

#[test]
fn a_removed_failure_does_not_verify() {
    let red = objections_to_report(faulty(), false);
    assert!(red.iter().any(|found| found.contains("red")), "{red:?}");
    let mut without = faulty().clone();
    without.causes.clear();
    without.broken.clear();
    without.cases.retain(|case: &Case| case.divergence.is_none() && case.fault.is_none());
    without.red = 0;
    let found = objections_to_report(&without, false);
    assert!(found.iter().any(|found| found.contains("said to fail")), "{found:?}");
}

#[test]
fn an_edited_count_does_not_verify() {
    does_not_verify(|report| report.counts.pass += 1, "said to pass");
    does_not_verify(|report| report.counts.unsupported += 1, "unsupported");
    does_not_verify(|report| report.tally.clauses.values_mut().for_each(|clause| clause.passed /= 2), "passed");
    does_not_verify(|report| report.red = 1, "red");
}

#[test]
fn counts_that_agree_but_are_not_the_models_do_not_verify() {
    let mut changed = whole().clone();
    changed.tally.corners += 1;
    changed.tally.clauses.values_mut().next().unwrap().elements += 1;
    changed.tally.decisions.values_mut().next().unwrap()[2] += 1;
    let (hash, certificate) = (hash(&changed), signed(&changed));
    assert_eq!(objections(&certificate, &changed, &hash, false), Vec::<String>::new());
    assert_eq!(objections(&certificate, &changed, &hash, true).len(), 3);
}

#[test]
fn an_edited_statement_or_another_key_does_not_verify() {
    let edited = |change: &dyn Fn(&mut Certificate)| {
        let mut certificate = signed(whole());
        change(&mut certificate);
        objections(&certificate, whole(), &hash(whole()), false)
    };
    for found in [
        edited(&|certificate| certificate.statement.theorem.push('!')),
        edited(&|certificate| certificate.statement.counts.pass += 1),
        edited(&|certificate| certificate.public_key = Key::generate().unwrap().public()),
        edited(&|certificate| certificate.signature = "00".repeat(64)),
        edited(&|certificate| certificate.signature.clear()),
    ] {
        assert!(found.iter().any(|found| found.contains("signature")), "{found:?}");
    }
}

#[test]
fn a_key_comes_back_from_its_file() {
    let key = Key::generate().unwrap();
    assert_eq!(Key::parse(&key.pem().unwrap()).unwrap().public(), key.public());
    assert!(Key::parse("no key").is_err());
}
