//! Ten faulty devices and some more, each behind a pipe.

use radcomp::certify::Outcome;
use radcomp::device::Builtin;
use radcomp::device::pipe::Pipe;

use super::smallest::Sizes;
use super::{RADCOMP, campaign, campaign_on, hasty, limits, profile, repository};

/// The first programs of level 1 are enough to find each fault.
const PROGRAMS: u64 = 300;

fn outcome(fault: &str) -> Outcome {
    outcome_on(2, fault)
}

fn outcome_on(threads: usize, fault: &str) -> Outcome {
    let command = format!("exec python3 '{}' {fault} '{RADCOMP}'", repository("tests/devices/faulty.py"));
    campaign_on(threads, PROGRAMS, || {
        Pipe::shell(&command, &profile(), if fault == "hang" { hasty() } else { limits() })
    })
}

/// The fault is found, and every program has been judged all the same.
#[track_caller]
fn is_found(fault: &str, verdict: &str) -> Outcome {
    let outcome = outcome(fault);
    let judged = outcome.tally.verdicts.get(verdict).copied().unwrap_or_default();
    assert!(judged > 0, "{fault}: {:?}", outcome.tally.verdicts);
    assert_eq!(outcome.tally.programs, campaign(PROGRAMS, || Builtin).tally.programs, "{fault} ended the run");
    outcome
}

/// As [`is_found`], and only a few programs are charged.
#[track_caller]
fn is_found_alone(fault: &str, verdict: &str) {
    let outcome = is_found(fault, verdict);
    let judged = outcome.tally.verdicts[verdict];
    assert_eq!(outcome.tally.red(), judged + outcome.tally.broken, "{fault}: {:?}", outcome.tally.verdicts);
    assert!(judged < outcome.tally.programs / 8, "{fault} is charged {judged} times");
}

#[test]
fn the_proxy_itself_is_sound() {
    assert_eq!(outcome("none").tally, campaign(PROGRAMS, || Builtin).tally);
}

#[test]
fn the_wrong_side() {
    is_found("wrong-side", "inadmissible");
}

#[test]
fn a_mitre_without_a_limit() {
    is_found("mitre-without-limit", "inadmissible");
}

#[test]
fn an_arc_of_negative_radius() {
    is_found("negative-radius", "inadmissible");
}

#[test]
fn compensation_lost_on_a_block_that_moves_the_normal_axis_only() {
    is_found("lost-on-z-only", "inadmissible");
}

#[test]
fn look_ahead_one_block_too_short() {
    is_found("short-look-ahead", "inadmissible");
}

#[test]
fn drift() {
    is_found("drift", "inadmissible");
}

#[test]
fn a_number_that_is_none() {
    is_found_alone("nan", "garbled");
}

#[test]
fn a_hang() {
    is_found_alone("hang", "timeout");
}

#[test]
fn a_crash() {
    is_found_alone("crash", "crash");
}

#[test]
fn what_is_found_does_not_depend_on_the_number_of_threads() {
    let [one, three] = [1, 3].map(|threads| outcome_on(threads, "crash"));
    assert_eq!(one.tally, three.tally);
    let names = |outcome: Outcome| outcome.failures.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(names(one), names(three));
}

#[test]
fn an_answer_for_another_id() {
    is_found_alone("other-id", "garbled");
}

#[test]
fn half_a_line() {
    is_found_alone("half-line", "no-answer");
}

#[test]
fn output_without_end() {
    is_found_alone("flood", "garbled");
}

#[test]
fn two_answers_to_one_request() {
    is_found("twice", "garbled");
}

#[test]
fn messages_among_the_answers() {
    is_found_alone("chatter", "garbled");
}

#[test]
fn causes_are_told_by_small_programs() {
    let mut sizes = Sizes::default();
    let ten = [
        "wrong-side",
        "mitre-without-limit",
        "negative-radius",
        "lost-on-z-only",
        "short-look-ahead",
        "drift",
        "nan",
        "hang",
        "crash",
        "other-id",
    ];
    ten.into_iter().for_each(|fault| sizes.add(fault, &outcome(fault)));
    sizes.are_small();
}
