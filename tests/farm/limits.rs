//! How much is judged.

use std::time::Duration;

use radcomp::certify::{Course, ROUND, certify, certify_on};
use radcomp::report::{DeviceRecord, Report};

use super::{Faulty, campaign, radcomp, text};

#[test]
fn a_run_for_a_time_is_the_run_of_as_many_programs() {
    let short = campaign(450);
    let course = Course { time: Some(Duration::from_secs(8)), ..Course::default() };
    let (outcome, _) = certify_on(&short, &course, || Faulty, |_| {});
    let programs = outcome.programs;
    // More than whole rounds of the least number.
    assert!(programs > 2 * ROUND && programs.is_multiple_of(ROUND), "{programs}");
    let report = |outcome: radcomp::certify::Outcome| -> Report {
        outcome.report(&DeviceRecord::named("faulty"), None, &campaign(programs))
    };
    let timed = report(outcome);
    assert_eq!(timed.generated_programs, programs);
    assert_eq!(timed, report(certify(&campaign(programs), || Faulty, |_| {})));
}

#[test]
fn time_that_is_up_at_once_does_not_lower_the_count() {
    let course = Course { time: Some(Duration::ZERO), ..Course::default() };
    let (outcome, _) = certify_on(&campaign(450), &course, || Faulty, |_| {});
    assert_eq!(outcome.programs, 2 * ROUND);
}

#[test]
fn a_level_is_never_lowered() {
    let folder = tempfile::tempdir().unwrap();
    let certify = ["certify", "builtin", "--profile", "seed-mill"];
    for (more, told) in [
        (&["--programs", "23999"][..], "level 1 judges at least 24000 programs; --programs can only raise that"),
        (&["--level", "2", "--programs", "479999"], "at least 480000"),
        (&["--level", "3", "--programs", "4799999"], "at least 4800000"),
        (&["--level", "3", "--for", "1s", "--programs", "480000"], "at least 4800000"),
        (&["--level", "3"], "level 3 takes --for"),
        (&["--level", "4"], "1..=3"),
        (&["--for", "soon"], "--for"),
        (&["--shard", "4/3"], "no number 4"),
        (&["--shard", "0/3"], "no number 0"),
        (&["--shard", "x"], "i/n"),
        (&["--shard", "1/2", "--for", "1h"], "cannot be used with"),
    ] {
        let output = radcomp(folder.path(), &[&certify[..], more].concat());
        assert!(output.status.code() == Some(2) && text(&output).contains(told), "{more:?}: {}", text(&output));
    }
}
