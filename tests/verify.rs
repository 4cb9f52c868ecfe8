//! Reports, and the checker that shares no code with the judge: what is true in a report is confirmed, what is not is
//! found.

#[path = "verify/command.rs"]
mod command;
#[path = "verify/reports.rs"]
mod reports;
#[path = "verify/schema.rs"]
mod schema;

use std::cmp::Ordering;
use std::fs;
use std::path::Path;

use radcomp::certify::Level;
use radcomp::device::Builtin;
use radcomp::judge::{Budget, Grade};
use radcomp::report::{Binary, Case, Exact, Report, SCHEMA};
use radcomp::verify::{Finding, LEAST_PROGRAMS, verify};
use radcomp_model::number::parse_decimal;
use radcomp_model::run_with;
use radcomp_spec::{Alarm, AlarmKind, Block, Centre, DecisionKind, Direction, Movement, Segment, Step};
use rug::Rational;

use reports::{DELTA, Tampered, answer, by_hand, end, inner, judged, profile, report, with_witness};

/// What the checker says of one case, after the report has been written and read.
fn finding(case: Case) -> Finding {
    let mut findings = Vec::new();
    let report = reread(&report(vec![case]));
    let summary = verify(&report, |_, finding| findings.push(finding.clone()));
    assert_eq!(summary.contradictions, Vec::<String>::new());
    findings.pop().expect("one case")
}

#[track_caller]
fn is_confirmed(case: Case) {
    assert_eq!(finding(case), Finding::Confirmed);
}

#[track_caller]
fn is_refuted(case: Case, because: &str) {
    let Finding::NotConfirmed(reason) = finding(case) else { panic!("confirmed") };
    assert!(reason.contains(because), "{reason}");
}

fn reread(report: &Report) -> Report {
    let mut text = Vec::new();
    report.write(&mut text).unwrap();
    let read = Report::parse(std::str::from_utf8(&text).unwrap()).unwrap();
    // A NaN is not equal to itself.
    assert_eq!(format!("{read:?}"), format!("{report:?}"));
    read
}

/// The inner contour with the first coordinate of its second block so many ten-thousandths farther.
fn moved(by: i64) -> Vec<Block<Rational>> {
    let mut blocks = inner();
    let Movement::Line { end } = &mut blocks[1].movement else { panic!("a line") };
    end[0] += Rational::from((by, 10_000));
    blocks
}

#[test]
fn a_true_witness_is_confirmed() {
    is_confirmed(with_witness(&inner(), &moved(4), &answer(&moved(4))));
    // β itself lies within β, exactly: 0.0005 is no f64, and β is the nearest one, which is larger.
    is_confirmed(with_witness(&inner(), &moved(5), &answer(&moved(5))));
    let mut said = with_witness(&inner(), &moved(4), &answer(&moved(4)));
    said.change_mm = Some(Binary(0.0004));
    is_confirmed(said);
}

#[test]
fn a_witness_beyond_the_band_is_found() {
    is_refuted(with_witness(&inner(), &moved(6), &answer(&moved(6))), "0.0006 mm from the program's");
    let mut wider = with_witness(&inner(), &moved(6), &answer(&moved(6)));
    wider.beta_mm = Binary(0.0007);
    is_refuted(wider, "the grade gives 0.0005 mm");
    let mut understated = with_witness(&inner(), &moved(4), &answer(&moved(4)));
    understated.change_mm = Some(Binary(0.0003));
    is_refuted(understated, "by more than 0.0003 mm");
}

#[test]
fn a_witness_of_another_program_is_found() {
    let mut other = inner();
    other[1].rapid = true;
    is_refuted(with_witness(&inner(), &other, &answer(&other)), "N2 of the witness is another one");
    other.pop();
    is_refuted(with_witness(&inner(), &other, &answer(&other)), "3 blocks, the program 4");
    is_refuted(by_hand("admissible", &inner(), &answer(&inner())), "no witness");
}

#[test]
fn a_tampered_answer_is_found() {
    let mut off = answer(&moved(4));
    end(&mut off, 1)[1] += 2.0 * DELTA;
    is_refuted(with_witness(&inner(), &moved(4), &off), "part at N2");
    let mut alarmed = answer(&moved(4));
    alarmed.alarm = Some(Alarm { block: 3, kind: AlarmKind::Reversal });
    is_refuted(with_witness(&inner(), &moved(4), &alarmed), "another alarm");
    let mut silent = answer(&moved(4));
    silent.steps.pop();
    is_refuted(with_witness(&inner(), &moved(4), &silent), "part at N4");
    let mut without = by_hand("inadmissible", &inner(), &answer(&inner()));
    without.answer = None;
    is_refuted(without, "does not give the device's answer");
}

#[test]
fn distances_are_compared_exactly() {
    let near = |by: f64| {
        let mut near = answer(&inner());
        end(&mut near, 3)[0] = by;
        by_hand("exact", &inner(), &near)
    };
    // The last move ends at (0, 50). So far off, with two units in the last place of 50 for the judge's rounding, and by one
    // unit of the sum more.
    let most = DELTA + 2.0 * 50.0 * f64::EPSILON;
    is_confirmed(near(most.next_down()));
    is_refuted(near(most.next_up()), "part at N4");
    // A refusal gets no allowance.
    let refused = |by: f64| {
        let mut off = answer(&inner());
        end(&mut off, 3)[0] = by;
        by_hand("inadmissible", &inner(), &off)
    };
    is_refuted(refused(DELTA), "is the exact outcome");
    is_confirmed(refused(DELTA.next_up()));
}

#[test]
fn a_verdict_of_inadmissible_is_checked_both_ways() {
    is_refuted(by_hand("inadmissible", &inner(), &answer(&inner())), "is the exact outcome");
    let mut off = answer(&inner());
    end(&mut off, 1)[0] += 0.1;
    is_confirmed(by_hand("inadmissible", &inner(), &off));
    end(&mut off, 1)[0] = f64::NAN;
    is_confirmed(by_hand("inadmissible", &inner(), &off));
    is_refuted(by_hand("exact", &inner(), &off), "not finite");
}

#[test]
fn other_branches_in_the_band_are_looked_at() {
    // The arc's end lies off it by 0.01 mm, exactly the tolerance, which a device may take for more.
    let arc = |end: &str| {
        let end = [parse_decimal(end).unwrap(), Rational::from(5)];
        let centre = Centre::FromStart([Rational::new(), Rational::from(5)]);
        [Block::moving(Movement::Arc { end, centre, direction: Direction::Counterclockwise })]
    };
    let tight = arc("5.01");
    let refused = run_with(&profile().parameters, &tight, |decision| match decision.kind {
        DecisionKind::EndOnArc => Ordering::Less,
        _ => decision.exact,
    });
    let refused = radcomp::device::Answer::from(&refused);
    is_refuted(by_hand("exact", &tight, &refused), "part at N1");
    is_confirmed(by_hand("admissible-without-witness", &tight, &refused));
    is_refuted(by_hand("inadmissible", &tight, &refused), "on other branches");
    // β is 0.0005 mm: an end, a centre and a start moved by that much change the difference of the radii by three times
    // as much, and no input within β changes it by more.
    for (end, confirmed) in [("5.0086", true), ("5.0084", false)] {
        let case = by_hand("admissible-without-witness", &arc(end), &refused);
        if confirmed { is_confirmed(case) } else { is_refuted(case, "no combination") }
    }
}

/// An answer with a straight step more, before its second one.
fn with_stop(at: [f64; 2]) -> Case {
    let mut split = answer(&inner());
    let step = split.steps[1].clone();
    split.steps.insert(1, Step { segment: Segment::Line { end: at }, ..step });
    by_hand("exact", &inner(), &split)
}

#[test]
fn how_a_straight_move_is_split_does_not_matter() {
    // The second block's own move goes from (10, 2) to (28, 2).
    is_confirmed(with_stop([15.0, 2.0]));
    is_confirmed(with_stop([10.0, 2.0]));
    is_confirmed(with_stop([28.0, 2.0]));
    is_confirmed(with_stop([28.0 + DELTA / 2.0, 2.0 - DELTA / 2.0]));
    is_refuted(with_stop([15.0, 2.0 + 2.0 * DELTA]), "part at N2");
    is_refuted(with_stop([28.0 + 2.0 * DELTA, 2.0]), "part at N2");
    is_refuted(with_stop([9.0, 2.0]), "part at N2");
}

#[test]
fn a_report_that_contradicts_itself_is_found() {
    let mut report = report(vec![with_witness(&inner(), &moved(4), &answer(&moved(4)))]);
    report.tally.verdicts.insert("inadmissible".to_owned(), 1);
    let summary = verify(&report, |_, _| {});
    assert_eq!(summary.contradictions.len(), 4, "{:?}", summary.contradictions);
    assert!(!summary.is_confirmed());
}

/// What the checker says of a report's head after one change of it.
#[track_caller]
fn is_contradicted(by: impl Fn(&mut Report), because: &str) {
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: DELTA };
    let mut faulty = Tampered(|answer| answer.steps.truncate(2));
    let mut report = judged(&mut faulty, &budget, 60);
    let found = |report: &Report| verify(report, |_, _| {}).contradictions;
    assert_eq!(found(&report), Vec::<String>::new());
    by(&mut report);
    let found = found(&report);
    assert!(found.iter().any(|contradiction| contradiction.contains(because)), "{found:?}");
}

#[test]
fn every_edited_count_is_found() {
    is_contradicted(|report| report.counts.pass += 1, "said to pass");
    is_contradicted(|report| report.counts.fail -= 1, "failures are told");
    is_contradicted(|report| report.counts.expected_failure += 1, "expected failures are counted");
    is_contradicted(|report| report.counts.unsupported += 1, "unsupported");
    is_contradicted(|report| report.tally.programs += 1, "programs were judged");
    is_contradicted(|report| report.tally.broken += 1, "relations are broken");
    is_contradicted(|report| drop(report.cases.pop()), "cases are given or left out");
    is_contradicted(|report| report.causes.clear(), "by the causes");
    is_contradicted(
        |report| report.tally.clauses.values_mut().for_each(|clause| clause.failed = 0),
        "programs diverge at some clause",
    );
    is_contradicted(|report| report.tally.clauses.values_mut().for_each(|clause| clause.programs = 0), "of 0 programs");
    is_contradicted(|report| report.tally.decisions.clear(), "decisions of one side");
    is_contradicted(|report| report.tally.sides.clear(), "0 programs take");
}

#[test]
fn another_profile_or_level_is_found() {
    is_contradicted(|report| report.profile_file.push(' '), "hash");
    is_contradicted(|report| report.profile = "seed-mill".to_owned(), "name");
    is_contradicted(|report| report.least_increment_mm = Binary(0.01), "least increment");
    is_contradicted(|report| report.parameters.non_moving_allowed = Some(5), "parameters");
    is_contradicted(|report| report.level = Some(1), "level 1 has 24000 generated programs, not 60");
    is_contradicted(|report| report.level = Some(3), "level 3 has 4800000 generated programs, not 60");
    is_contradicted(|report| report.level = Some(4), "no level 4");
    assert_eq!(LEAST_PROGRAMS, [Level::One, Level::Two, Level::Three].map(Level::programs));
}

#[test]
fn a_faulty_devices_report_is_confirmed_all_but_ties_and_fits_the_schema() {
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: DELTA };
    let mut faulty = Tampered(|answer| {
        let last = answer.steps.iter_mut().rev().find_map(|step| match &mut step.segment {
            Segment::Line { end } | Segment::Arc { end, .. } => Some(end),
            Segment::Hold => None,
        });
        last.into_iter().for_each(|end| end[0] += 1e-5);
    });
    let report = reread(&judged(&mut faulty, &budget, 300));
    assert!(report.red > 200, "{}", report.red);
    // Where nearly every corner of a program is an exact tie, there are more combinations of branches than are tried.
    let mut left_open = 0;
    let summary = verify(&report, |case, finding| {
        if let Finding::NotConfirmed(reason) = finding {
            assert!(
                reason.contains("combinations of branches in the band"),
                "{} {}: {reason}",
                case.name,
                case.verdict
            );
            left_open += 1;
        }
    });
    assert_eq!(summary.contradictions, Vec::<String>::new());
    assert!(left_open * 50 <= report.red, "{left_open} of {}", report.red);
    fits_the_schema(&report);
}

#[test]
fn a_sound_devices_report_is_confirmed_and_fits_the_schema() {
    // Points so exact that the implementation needs witnesses; and a corner 22 km off, where half a unit in the last place
    // of an f64 is more than δ.
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-9 };
    let report = reread(&judged(&mut Builtin, &budget, 3_000));
    assert!(report.cases.iter().any(|case| case.verdict == "admissible"), "{:?}", report.tally.verdicts);
    everything_is_confirmed(&report);
}

#[track_caller]
fn everything_is_confirmed(report: &Report) {
    let mut refuted = Vec::new();
    let summary = verify(report, |case, finding| {
        if let Finding::NotConfirmed(reason) = finding {
            refuted.push(format!("{} {}: {reason}", case.name, case.verdict));
        }
    });
    assert!(summary.is_confirmed(), "{:?}\n{}", summary.contradictions, refuted.join("\n"));
    fits_the_schema(report);
}

fn fits_the_schema(report: &Report) {
    let schema = serde_json::from_str(SCHEMA).unwrap();
    assert_eq!(schema::violation(&schema, &serde_json::to_value(report).unwrap()), None);
}

#[test]
fn the_schema_refuses_what_is_no_report() {
    let schema = serde_json::from_str(SCHEMA).unwrap();
    let good = serde_json::to_value(report(vec![by_hand("exact", &inner(), &answer(&inner()))])).unwrap();
    assert_eq!(schema::violation(&schema, &good), None);
    let mut bad = good.clone();
    bad["cases"][0]["program"][1]["movement"]["line"]["end"][0] = 30.into();
    assert!(schema::violation(&schema, &bad).unwrap().starts_with("$.cases[0].program[1].movement: "));
    let mut bad = good;
    bad["surprise"] = true.into();
    assert_eq!(schema::violation(&schema, &bad).unwrap(), "$: surprise is not known");
}

#[test]
fn numbers_come_back_as_they_were() {
    for value in [0.1, -0.0, 1e-300, f64::MIN_POSITIVE / 3.0, f64::MAX, f64::INFINITY, f64::NEG_INFINITY] {
        let read = Binary::parse(&Binary(value).text()).unwrap();
        assert_eq!(read.0.to_bits(), value.to_bits());
    }
    assert!(Binary::parse(&Binary(f64::NAN).text()).unwrap().0.is_nan());
    for (value, text) in [(Rational::from((-25, 2)), "-12.5"), (Rational::from((1, 3)), "1/3")] {
        assert_eq!(Exact(value.clone()).text(), text);
        assert_eq!(Exact::parse(text).unwrap().0, value);
    }
    for text in ["", "1/0", "1/-2", "1e3", "NaN", "1 ", "1/2/3", "0x1"] {
        assert_eq!(Exact::parse(text), None, "{text}");
    }
    for text in ["", "+1", "infinity", "nan", "1 ", "--1", "e"] {
        assert_eq!(Binary::parse(text), None, "{text}");
    }
}

#[test]
fn the_checker_uses_nothing_of_the_judge() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/verify");
    for file in fs::read_dir(folder).unwrap() {
        let text = fs::read_to_string(file.unwrap().path()).unwrap();
        let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
        let uses: Vec<_> = code.filter(|line| line.contains("judge::") || line.contains("certify::")).collect();
        assert_eq!(uses, Vec::<&str>::new());
    }
}
