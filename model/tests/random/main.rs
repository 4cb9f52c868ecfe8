//! Random programs under random choices of every parameter: what holds whatever the rules are.
//!
//! Coordinates are small whole numbers, so that touching curves, right angles, reversals and points that fall together
//! are common.

mod program;

use core::cmp::Ordering;
use std::collections::BTreeSet;

use program::Case;
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;
use radcomp_model::number::Real;
use radcomp_model::{Run, run, run_with};
use radcomp_spec::parameters::{Interference, NegativeRadius, PendingAtAlarm, ReversedPath};
use radcomp_spec::{Advisory, AdvisoryKind, AlarmKind, DecisionKind, Segment, Step, clause};

/// Choices that a case is made of.
fn choices() -> impl Strategy<Value = Vec<u16>> {
    prop::collection::vec(any::<u16>(), 200)
}

/// The block of a step, if the step is the block's own: its move, or a block without movement that is executed.
fn own(step: &Step<Real>) -> Option<usize> {
    (step.main || step.segment == Segment::Hold).then_some(step.block)
}

/// A step without its numbers, and its numbers.
type Told = (String, Vec<Real>);

/// What a run answers, as it is or seen from the other side of the first axis: steps and advisories.
fn told(run: &Run, mirrored: bool) -> Vec<Told> {
    let point = |[a, b]: &[Real; 2]| [a.clone(), if mirrored { -b } else { b.clone() }];
    let step = |step: &Step<Real>| {
        let (shape, numbers) = match &step.segment {
            Segment::Hold => ("hold".to_owned(), Vec::new()),
            Segment::Line { end } => ("line".to_owned(), point(end).to_vec()),
            Segment::Arc { end, centre, direction, full } => {
                let direction = if mirrored { direction.reversed() } else { *direction };
                (format!("{direction:?} {full}"), [point(end), point(centre)].concat())
            }
        };
        (format!("{} {} {} {} {shape}", step.block, step.clause, step.rapid, step.main), numbers)
    };
    let steps = run.steps.iter().map(step);
    let advisory = |told: &Advisory<Real>| (format!("{} {}", told.block, told.kind.id()), vec![told.amount.clone()]);
    let advisories = run.advisories.iter().map(advisory);
    steps.chain(advisories).collect()
}

/// Whether two numbers lie in one interval of 2⁻⁶⁰. To prove them equal would take long where many roots meet.
fn alike(x: &Real, y: &Real) -> bool {
    let ((low, high), (other_low, other_high)) = (x.enclosure(61), y.enclosure(61));
    low <= other_high && other_low <= high
}

/// The first difference of two runs, if they differ.
fn difference(left: Vec<Told>, right: Vec<Told>) -> Option<String> {
    if left.len() != right.len() {
        return Some(format!("{left:#?}\n{right:#?}"));
    }
    let differ =
        |(left, right): &(Told, Told)| left.0 != right.0 || left.1.iter().zip(&right.1).any(|(x, y)| !alike(x, y));
    left.into_iter().zip(right).find(differ).map(|differing| format!("{differing:#?}"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, max_shrink_iters: 300, failure_persistence: None, ..ProptestConfig::default() })]

    /// A block ends in its outcome or in an alarm, in the order of blocks.
    #[test]
    fn every_block_has_one_outcome(choices in choices()) {
        let case = Case::new(&choices);
        let run = run(&case.parameters, &case.blocks);
        prop_assert!(!run.contradiction);
        prop_assert!(run.steps.is_sorted_by_key(|step| step.block), "{:#?}", run.steps);
        let executed: Vec<usize> = run.steps.iter().filter_map(own).collect();
        let until = run.alarm.map_or(case.blocks.len(), |alarm| alarm.block);
        let lost = run.alarm.is_some() && case.parameters.pending_at_alarm == PendingAtAlarm::Lost;
        let until_lost = if lost { executed.len().min(until) } else { until };
        prop_assert_eq!(executed, (0..until_lost).collect::<Vec<_>>());
        // [TRC-MODE-10] the corner moves of the block of the alarm may stand.
        let stands = |step: &Step<Real>| step.block < until || (lost && step.block == until && own(step).is_none());
        prop_assert!(run.steps.iter().all(stands));
    }

    /// A margin has the sign of its decision.
    #[test]
    fn margins_have_the_signs_of_their_decisions(choices in choices()) {
        let case = Case::new(&choices);
        for (decision, answer) in run(&case.parameters, &case.blocks).decisions {
            prop_assert_eq!(answer, decision.exact);
            // An arc that runs backwards at its boundary is decided by the clause.
            let at_boundary = decision.margin.is_zero() && ["arc-forward", "arc-interference"].contains(&decision.kind.id());
            prop_assert!(at_boundary || decision.margin.sign() == decision.exact, "{decision:?}");
        }
    }

    /// The mirror image of a program has the mirror image of its path.
    #[test]
    fn mirrored_programs_have_mirrored_paths(choices in choices()) {
        let case = Case::new(&choices);
        let (plain, mirrored) = (run(&case.parameters, &case.blocks), run(&case.parameters, &case.mirrored()));
        prop_assert_eq!(plain.alarm, mirrored.alarm);
        prop_assert_eq!(difference(told(&plain, true), told(&mirrored, false)), None);
    }

    /// [TRC-SIDE-07] negative radii with exchanged codes change nothing, where they are allowed.
    #[test]
    fn negative_radii_exchange_the_sides(choices in choices()) {
        let mut case = Case::new(&choices);
        case.parameters.negative_radius = NegativeRadius::SwapsSides;
        // A radius of 0 has no sign.
        for radius in case.blocks.iter_mut().filter_map(|block| block.radius.as_mut()) {
            if radius.is_zero() {
                *radius += 1;
            }
        }
        let (plain, negative) = (run(&case.parameters, &case.blocks), run(&case.parameters, &case.negated()));
        prop_assert_eq!(plain.alarm, negative.alarm);
        prop_assert_eq!(difference(told(&plain, false), told(&negative, false)), None);
    }

    /// [TRC-INT-04] with `alarm` the path is the one without the comparison, up to the alarm.
    #[test]
    fn interference_only_cuts_the_path(choices in choices()) {
        let mut case = Case::new(&choices);
        case.parameters.interference = Interference::Alarm;
        let compared = run(&case.parameters, &case.blocks);
        case.parameters.interference = Interference::Off;
        case.parameters.reversed_path = ReversedPath::Advisory;
        let plain = run(&case.parameters, &case.blocks);
        let cut = compared.alarm.filter(|alarm| alarm.kind == AlarmKind::Interference);
        prop_assert!(compared.steps.len() <= plain.steps.len());
        prop_assert!(cut.is_some() || (compared.alarm, compared.steps.len()) == (plain.alarm, plain.steps.len()));
        let made = plain.steps.into_iter().take(compared.steps.len()).collect();
        let path = |steps: Vec<Step<Real>>| told(&Run { steps, ..Run::default() }, false);
        prop_assert_eq!(difference(path(compared.steps), path(made)), None);
    }

    /// Whatever a judge answers, the engine goes on or says that no geometry answers so.
    #[test]
    fn other_answers_are_borne(choices in choices(), answers in prop::collection::vec(-1..2_i8, 30)) {
        let case = Case::new(&choices);
        let mut answers = answers.into_iter();
        run_with(&case.parameters, &case.blocks, |decision| match answers.next() {
            Some(-1) => Ordering::Less,
            Some(0) => Ordering::Equal,
            Some(1) => Ordering::Greater,
            _ => decision.exact,
        });
    }
}

/// The cases are fit for their purpose: between them they come through every clause that makes an end point and every
/// alarm that the engine raises, but for the moves of [TRC-INT-03], which need a short block behind an acute corner.
#[test]
fn random_programs_reach_every_clause() {
    let mut runner = TestRunner::deterministic();
    let mut reached = BTreeSet::new();
    for _ in 0..20_000 {
        let choices = choices().new_tree(&mut runner).expect("choices are never refused").current();
        let case = Case::new(&choices);
        let run = run(&case.parameters, &case.blocks);
        reached.extend(run.steps.iter().map(|step| step.clause.id()));
        reached.extend(run.decisions.iter().map(|(decision, _)| decision.kind.id()));
        reached.extend(run.alarm.map(|alarm| alarm.kind.id()));
        reached.extend(run.advisories.iter().map(|advisory| advisory.kind.id()));
    }
    let of_steps = [
        "TRC-MODE-01 TRC-MODE-04 TRC-MODE-05 TRC-MODE-06",
        "TRC-START-02 TRC-START-04 TRC-START-05 TRC-START-06 TRC-START-08",
        "TRC-CORNER-02 TRC-CORNER-03 TRC-CORNER-04 TRC-CORNER-06 TRC-CORNER-07 TRC-CORNER-08 TRC-CORNER-09",
        "TRC-CORNER-10 TRC-CORNER-13 TRC-CORNER-14 TRC-CORNER-16 TRC-CORNER-17",
        "TRC-SIDE-02 TRC-SIDE-03 TRC-SIDE-05 TRC-SIDE-06",
        "TRC-CANCEL-01 TRC-CANCEL-02 TRC-CANCEL-03 TRC-CANCEL-05 TRC-CANCEL-06",
        "TRC-START-10 TRC-START-11 TRC-CANCEL-08 TRC-VEC-02 TRC-VEC-03 TRC-VEC-04 TRC-VEC-05 TRC-VEC-06",
        "TRC-LOOK-01 TRC-LOOK-02 TRC-LOOK-03 TRC-LOOK-05 TRC-DUMMY-02 TRC-INT-05",
    ];
    // Of the alarms of codes in mode, which one is raised is the program reader's to say.
    let in_mode = |kind: &AlarmKind| kind.clause() != clause::TRC_MODE_08 || *kind == AlarmKind::ToolChangeInMode;
    let alarms = AlarmKind::ALL.iter().filter(|kind| in_mode(kind)).map(|kind| kind.id());
    let decisions = DecisionKind::ALL.iter().map(|kind| kind.id());
    let advisories = AdvisoryKind::ALL.iter().map(|kind| kind.id());
    let wanted = of_steps.iter().flat_map(|ids| ids.split(' ')).chain(alarms).chain(decisions).chain(advisories);
    let missing: Vec<_> = wanted.filter(|id| !reached.contains(id)).collect();
    assert!(missing.is_empty(), "never reached: {missing:?}");
}
