//! Gates of the generators: what bytes lead to must reach comparison, and no shape may starve a clause or a decision.
//! A fuzzer whose programs stop at their first block finds nothing, and nobody notices.

use std::collections::BTreeMap;

use radcomp::edited::Edited;
use radcomp::generate::{Reach, Shape, program};
use radcomp_fuzz::ledger;
use radcomp_fuzz::ordinary::Dice;
use radcomp_model::{Run, run};
use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Block, Clause, DecisionKind, Movement, clause};
use rug::Rational;

const INPUTS: u32 = 40_000;

/// What a path's steps cite, by the text: every clause that makes a vector.
const CLAUSES: [Clause; 20] = [
    clause::TRC_MODE_01,
    clause::TRC_MODE_04,
    clause::TRC_MODE_06,
    clause::TRC_START_02,
    clause::TRC_CORNER_02,
    clause::TRC_CORNER_03,
    clause::TRC_CORNER_04,
    clause::TRC_CORNER_06,
    clause::TRC_CORNER_07,
    clause::TRC_CORNER_08,
    clause::TRC_CORNER_09,
    clause::TRC_CORNER_10,
    clause::TRC_SIDE_02,
    clause::TRC_SIDE_03,
    clause::TRC_CANCEL_01,
    clause::TRC_CANCEL_02,
    clause::TRC_CANCEL_03,
    clause::TRC_LOOK_03,
    clause::TRC_LOOK_05,
    clause::TRC_DUMMY_02,
];

/// Sides that no geometry has: lengths and distances are not negative.
const IMPOSSIBLE: [(DecisionKind, usize); 5] = [
    (DecisionKind::Moves, 0),
    (DecisionKind::CentreDistance, 0),
    (DecisionKind::WholeTurn, 0),
    (DecisionKind::CentresApart, 0),
    (DecisionKind::InterferenceApart, 0),
];

#[test]
fn programs_reach_comparison_and_no_clause_starves() {
    let seeds: Vec<_> = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/seeds/programs"))
        .unwrap()
        .map(|entry| std::fs::read(entry.unwrap().path()).unwrap())
        .collect();
    let mut dice = Dice(1);
    let (mut made, mut compared) = (0, 0);
    let mut clauses: BTreeMap<Clause, u32> = BTreeMap::new();
    for _ in 0..INPUTS {
        let Some(Edited { profile, blocks }) = Edited::from_bytes(&dice.input(&seeds)) else { continue };
        let run = run(&profile.parameters, &blocks);
        ledger::note(&run);
        made += 1;
        compared += u32::from(reaches_comparison(&run));
        for step in run.steps {
            *clauses.entry(step.clause).or_default() += 1;
        }
    }
    println!("{compared} of {made} programs reach comparison, of {INPUTS} inputs; {clauses:?}");
    assert!(made * 10 >= INPUTS * 9, "of {INPUTS} inputs only {made} are programs");
    assert!(compared * 10 >= made * 9, "of {made} programs only {compared} reach comparison");
    for clause in CLAUSES {
        assert!(clauses.get(&clause).is_some_and(|count| *count >= 10), "{clause} starves: {:?}", clauses.get(&clause));
    }
    for kind in DecisionKind::ALL {
        for (side, taken) in ledger::taken(*kind).into_iter().enumerate() {
            assert!(taken > 0 || IMPOSSIBLE.contains(&(*kind, side)), "{} is never on side {side}", kind.id());
        }
    }
}

/// Compensation has made a vector, or refused to.
fn reaches_comparison(run: &Run) -> bool {
    let shaped = |clause| clause != clause::TRC_MODE_01 && clause != clause::TRC_LOOK_01;
    run.alarm.is_some() || run.steps.iter().any(|step| shaped(step.clause))
}

/// The clauses that a shape is there for.
fn purpose(shape: Shape) -> &'static [Clause] {
    match shape {
        Shape::SingleCorner => &[
            clause::TRC_CORNER_02,
            clause::TRC_CORNER_03,
            clause::TRC_CORNER_04,
            clause::TRC_CORNER_06,
            clause::TRC_CORNER_07,
            clause::TRC_CORNER_08,
            clause::TRC_CORNER_10,
        ],
        Shape::CornerChain => {
            &[clause::TRC_CORNER_02, clause::TRC_CORNER_03, clause::TRC_CORNER_06, clause::TRC_CORNER_08]
        }
        Shape::ArcChain => &[clause::TRC_CORNER_02, clause::TRC_CORNER_04, clause::TRC_CORNER_07],
        Shape::Slot => &[clause::TRC_CORNER_03, clause::TRC_CORNER_06],
        Shape::StartUp => &[clause::TRC_START_02],
        Shape::Cancel => &[clause::TRC_CANCEL_01, clause::TRC_CANCEL_02, clause::TRC_CANCEL_03],
        Shape::SideChange => &[clause::TRC_SIDE_02, clause::TRC_SIDE_03],
        Shape::WithoutMovement => &[clause::TRC_MODE_04, clause::TRC_LOOK_03, clause::TRC_DUMMY_02],
        Shape::Lathe => &[clause::TRC_CORNER_02, clause::TRC_CORNER_03, clause::TRC_CORNER_04, clause::TRC_CORNER_06],
        Shape::WholeProgram => &CLAUSES,
    }
}

/// Programs of each shape and built-in profile.
const PROGRAMS: u64 = 400;
/// The longest program of a single feature, without the blocks that do not move.
const SHORT: usize = 16;

#[test]
fn programs_of_each_shape_reach_comparison_and_starve_none_of_its_clauses() {
    for shape in Shape::SINGLE.into_iter().chain([Shape::WholeProgram]) {
        let (mut made, mut compared, mut blocks) = (0, 0, 0);
        let mut clauses: BTreeMap<Clause, u32> = BTreeMap::new();
        for (name, _) in BUILTIN {
            let profile = Profile::builtin(name).unwrap();
            let numbers = (0..).filter(|number| Shape::of(*number) == shape);
            for program in numbers.take(PROGRAMS as usize).map(|number| program(2, number, Reach::of(&profile))) {
                let still = |block: &Block<Rational>| block.movement == Movement::None;
                let moving = program.iter().filter(|block| !still(block)).count();
                assert!(shape == Shape::WholeProgram || moving <= SHORT, "{}: {moving} moves", shape.name());
                let run = run(&profile.parameters, &program);
                (made, blocks) = (made + 1, blocks + program.len());
                compared += u32::from(reaches_comparison(&run));
                run.steps.iter().for_each(|step| *clauses.entry(step.clause).or_default() += 1);
            }
        }
        let share = f64::from(compared) / f64::from(made);
        let length = blocks as f64 / f64::from(made);
        println!(
            "{}: {:.1} % of {made} programs reach comparison, {length:.1} blocks each",
            shape.name(),
            share * 100.0
        );
        assert!(share >= 0.9, "{}: only {compared} of {made} reach comparison", shape.name());
        for clause in purpose(shape) {
            let count = clauses.get(clause).copied().unwrap_or(0);
            assert!(count >= 10, "{}: {clause} starves: {count}; {clauses:?}", shape.name());
        }
    }
}
