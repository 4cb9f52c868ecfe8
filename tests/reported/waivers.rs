//! Waivers.

use radcomp::certify::Waivers;
use radcomp::verify::verify;

use crate::campaigns::{faulty, faulty_with};

#[test]
fn a_waived_failure_is_an_expected_one() {
    let waiver = "[[waiver]]\nclause = \"TRC-CORNER-08\"\nreason = \"rounded off\"\n";
    let report = faulty_with(waiver);
    assert!(report.counts.expected_failure > 0);
    assert_eq!(report.counts.fail + report.counts.expected_failure, faulty().counts.fail);
    assert_eq!(report.expected_failures[0].programs, report.counts.expected_failure);
    assert!(report.causes.iter().all(|cause| !cause.cause.starts_with("TRC-CORNER-08")));
    assert_eq!(verify(&report, |_, _| {}).contradictions, Vec::<String>::new());
    assert!(radcomp::report::junit(&report, "r.json").unwrap().contains("rounded off"));
}

#[test]
fn a_waiver_may_be_for_one_program_or_one_difference() {
    let name = &faulty().cases.iter().find(|case| case.divergence.is_some()).expect("a failure").name;
    let clause = faulty().cases.iter().find_map(|case| case.divergence.as_ref()).expect("a failure").clause.0;
    let waiver = |more: &str| format!("[[waiver]]\nclause = \"{clause}\"\n{more}\nreason = \"known\"\n");
    let one = faulty_with(&waiver(&format!("program = {name:?}")));
    assert!((1..=3).contains(&one.counts.expected_failure), "{:?}", one.counts);
    assert_eq!(faulty_with(&waiver("difference = \"no such\"")).counts, faulty().counts);
}

#[test]
fn a_file_that_is_wrong_is_told_by_its_line() {
    for (text, line, told) in [
        ("[[waiver]]\nclause = \"TRC-NONE-01\"\nreason = \"x\"\n", 2, "no clause TRC-NONE-01"),
        ("[[waiver]]\nclause = \"TRC-CORNER-08\"\nreason = \" \"\n", 3, "needs a reason"),
        ("\n[[waiver]]\nclause = \"TRC-CORNER-08\"\n", 2, "reason"),
        ("[[waiver]]\nclaus = \"TRC-CORNER-08\"\nreason = \"x\"\n", 2, "claus"),
    ] {
        let error = Waivers::parse(text).unwrap_err();
        assert!(error.line == line && error.reason.contains(told), "{text}{error}");
    }
}
