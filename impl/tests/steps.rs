//! What the worked examples do not show of a step: main and rapid flags; and numbers out of range.

mod common;

use common::{SEED_MILL, run};
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Block, Centre, Clause, Compensation, Direction, Movement, Side, clause};

fn line(x: f64, y: f64) -> Block<f64> {
    Block::moving(Movement::Line { end: [x, y] })
}

fn start() -> Block<f64> {
    Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(5.0), ..line(5.0, 0.0) }
}

fn rapid(block: Block<f64>) -> Block<f64> {
    Block { rapid: true, ..block }
}

/// Block, clause, rapid, main.
type Flags = (usize, Clause, bool, bool);

fn flags(parameters: &Parameters, blocks: &[Block<f64>]) -> Vec<Flags> {
    let (steps, alarm) = run(parameters, blocks);
    assert_eq!(alarm, None);
    steps.iter().map(|step| (step.block, step.clause, step.rapid, step.main)).collect()
}

#[test]
fn a_move_takes_the_rate_of_its_owner() {
    let blocks = [start(), line(10.0, 0.0), rapid(Block::empty()), rapid(line(4.0, -8.0))];
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_CORNER_08, false, true),
        (2, clause::TRC_LOOK_02, true, false),
        (3, clause::TRC_CORNER_08, true, false),
        (3, clause::TRC_MODE_04, true, true),
    ];
    assert_eq!(flags(&SEED_MILL, &blocks), expected);
    let previous = Parameters { corner_owner: CornerOwner::Previous, ..SEED_MILL };
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_CORNER_08, false, true),
        (1, clause::TRC_CORNER_08, false, false),
        (2, clause::TRC_LOOK_02, true, false),
        (3, clause::TRC_MODE_04, true, true),
    ];
    assert_eq!(flags(&previous, &blocks), expected);
}

#[test]
fn a_dummy_block_owns_its_corner_moves() {
    let dummy = rapid(Block::moving(Movement::Dummy { vector: [-3.0, -4.0] }));
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_CORNER_08, false, true),
        (2, clause::TRC_CORNER_08, true, false),
        (2, clause::TRC_DUMMY_02, true, false),
        (3, clause::TRC_MODE_04, false, true),
    ];
    assert_eq!(flags(&SEED_MILL, &[start(), line(10.0, 0.0), dummy, line(4.0, -8.0)]), expected);
}

#[test]
fn blocks_without_movement_behind_the_last_move_lose_the_look_ahead() {
    let blocks = [start(), line(10.0, 0.0), Block::empty(), rapid(Block::empty())];
    let expected: [Flags; 4] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_MODE_04, false, true),
        (2, clause::TRC_LOOK_03, false, false),
        (3, clause::TRC_LOOK_03, true, false),
    ];
    assert_eq!(flags(&SEED_MILL, &blocks), expected);
}

#[test]
fn g40_settles_the_junction_that_its_block_would_lose() {
    // The block with G40 is the third without movement, of two allowed. [TRC-CANCEL-01]
    let g40 = Block { compensation: Some(Compensation::Off), ..Block::empty() };
    let blocks = [start(), line(10.0, 0.0), Block::empty(), Block::empty(), g40, Block::empty()];
    let expected: [Flags; 6] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_CANCEL_01, false, true),
        (2, clause::TRC_LOOK_02, false, false),
        (3, clause::TRC_LOOK_02, false, false),
        (4, clause::TRC_CANCEL_03, false, false),
        (5, clause::TRC_LOOK_01, false, false),
    ];
    assert_eq!(flags(&SEED_MILL, &blocks), expected);
}

#[test]
fn numbers_out_of_range() {
    let arc = |centre| Block::moving(Movement::Arc { end: [9.0, 9.0], centre, direction: Direction::Clockwise });
    for number in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e9_f64.next_up(), -1e9_f64.next_up()] {
        let blocks = [
            line(number, 0.0),
            line(0.0, number),
            arc(Centre::FromStart([number, 0.0])),
            arc(Centre::Radius(number)),
            Block::moving(Movement::Dummy { vector: [0.0, number] }),
            Block { radius: Some(number), ..Block::empty() },
        ];
        for block in blocks {
            for before in [vec![], vec![start()], vec![start(), line(10.0, 0.0), Block::empty()]] {
                let program = [before, vec![block.clone()]].concat();
                let (steps, alarm) = run(&SEED_MILL, &program);
                let expected = Alarm { block: program.len() - 1, kind: AlarmKind::OutOfRange };
                assert_eq!(alarm, Some(expected));
                assert_eq!(steps.len(), program.len() - 1);
            }
        }
    }
    let negative = Block { radius: Some(-5e-324), ..Block::empty() };
    assert_eq!(run(&SEED_MILL, &[negative]).1, Some(Alarm { block: 0, kind: AlarmKind::OutOfRange }));
    assert_eq!(run(&SEED_MILL, &[line(1e9, -1e9), Block { radius: Some(-0.0), ..Block::empty() }]).1, None);
}
