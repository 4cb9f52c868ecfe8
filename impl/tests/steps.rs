//! What the worked examples do not show of a step: main and rapid flags; and numbers out of range.

mod common;

use common::{SEED_MILL, run};
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Block, Centre, Clause, Compensation, Direction, Movement, Segment, Side, clause};

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
    let previous = Parameters { corner_owner: CornerOwner::Previous, ..*SEED_MILL };
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

fn code(code: Compensation) -> Block<f64> {
    Block { compensation: Some(code), ..Block::empty() }
}

const LEFT: Compensation = Compensation::On(Side::Left);

#[test]
fn a_start_up_block_without_movement_moves_at_its_own_rate() {
    let shift = Parameters {
        start_up_without_movement: StartUpWithoutMovement::Shift,
        cancel_without_movement: CancelWithoutMovement::Shift,
        ..*SEED_MILL
    };
    let on = rapid(Block { radius: Some(5.0), ..code(LEFT) });
    let off = code(Compensation::Off);
    let blocks = [on.clone(), Block::empty(), line(10.0, 0.0), rapid(off.clone()), off.clone()];
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_08, true, true),
        (1, clause::TRC_LOOK_02, false, false),
        (2, clause::TRC_CANCEL_01, false, true),
        (3, clause::TRC_CANCEL_06, true, true),
        (4, clause::TRC_LOOK_01, false, false),
    ];
    assert_eq!(flags(&shift, &blocks), expected);
    // G40, the end of the program, and a stop in the block leave no shift.
    let expected: [Flags; 4] = [
        (0, clause::TRC_LOOK_01, true, false),
        (1, clause::TRC_LOOK_01, false, false),
        (2, clause::TRC_LOOK_01, false, false),
        (3, clause::TRC_MODE_01, false, true),
    ];
    assert_eq!(flags(&shift, &[on.clone(), Block::empty(), off, line(10.0, 0.0)]), expected);
    assert_eq!(flags(&shift, &[on.clone(), Block::empty()]), expected[..2]);
    let stopped = Block { stops_look_ahead: true, ..on.clone() };
    assert_eq!(flags(&shift, &[stopped, line(10.0, 0.0), line(20.0, 0.0)])[1].1, clause::TRC_START_02);
    // An alarm before the junction is settled.
    let off_arc = Movement::Arc { end: [9.0, 9.0], centre: Centre::Radius(1.0), direction: Direction::Clockwise };
    let (steps, alarm) = run(&shift, &[on, Block::moving(off_arc)]);
    assert_eq!((steps.len(), steps[0].clause), (1, clause::TRC_LOOK_01));
    assert_eq!(alarm, Some(Alarm { block: 1, kind: AlarmKind::NoSuchArc }));
}

#[test]
fn a_tool_that_stands_at_the_programmed_point_stays() {
    let shift = Parameters { cancel_without_movement: CancelWithoutMovement::Shift, ..*SEED_MILL };
    let start = Block { radius: Some(0.0), ..start() };
    let expected: [Flags; 2] = [(0, clause::TRC_START_05, false, true), (1, clause::TRC_LOOK_01, false, false)];
    assert_eq!(flags(&shift, &[start, code(Compensation::Off)]), expected);
}

#[test]
fn any_number_of_blocks_without_movement_keeps_its_rates() {
    let unbounded = Parameters { non_moving_allowed: None, ..*SEED_MILL };
    let mut blocks = vec![start(), line(10.0, 0.0)];
    let rate = |block: usize| block / 100 % 2 == 1;
    blocks.extend((2..1500).map(|block| Block { rapid: rate(block), ..Block::empty() }));
    blocks.push(line(20.0, 0.0));
    let flags = flags(&unbounded, &blocks);
    assert_eq!(flags.len(), blocks.len());
    for (block, step) in flags.iter().enumerate().take(1500).skip(2) {
        assert_eq!(*step, (block, clause::TRC_LOOK_02, rate(block), false));
    }
}

#[test]
fn a_block_that_moves_and_stops_loses_the_look_ahead_behind_it() {
    let stops = |block| Block { stops_look_ahead: true, ..block };
    let no_vector = Parameters { start_up_lost: StartUpLost::NoVector, ..*SEED_MILL };
    let blocks = [stops(start()), Block::empty(), line(10.0, 0.0), stops(line(20.0, 0.0)), line(20.0, 10.0)];
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_04, false, true),
        (1, clause::TRC_LOOK_03, false, false),
        (2, clause::TRC_START_02, false, true),
        (3, clause::TRC_LOOK_03, false, true),
        (4, clause::TRC_MODE_04, false, true),
    ];
    assert_eq!(flags(&no_vector, &blocks), expected);
}

#[test]
fn movement_words_beside_a_code_that_is_not_for_offset_mode_are_not_looked_at() {
    let refused = Block { not_in_mode: Some(AlarmKind::MachineCoordinatesInMode), ..line(f64::NAN, 0.0) };
    let (steps, alarm) = run(&SEED_MILL, &[start(), refused.clone()]);
    assert_eq!(alarm, Some(Alarm { block: 1, kind: AlarmKind::MachineCoordinatesInMode }));
    assert_eq!((steps.len(), steps[0].clause), (1, clause::TRC_MODE_06));
    // Another radius comes first.
    let (_, alarm) = run(&SEED_MILL, &[start(), Block { radius: Some(4.0), ..refused }]);
    assert_eq!(alarm, Some(Alarm { block: 1, kind: AlarmKind::OffsetChangedInMode }));
}

#[test]
fn the_last_start_up_block_without_movement_counts() {
    let shift = Parameters { start_up_without_movement: StartUpWithoutMovement::Shift, ..*SEED_MILL };
    let on = |radius| Block { radius: Some(radius), ..code(LEFT) };
    let (steps, alarm) = run(&shift, &[on(5.0), on(4.0), line(10.0, 0.0)]);
    assert_eq!((alarm, steps[1].segment.clone()), (None, Segment::Line { end: [0.0, 4.0] }));
    // Behind it another radius is an alarm, and no shift is made.
    let radius = Block { radius: Some(4.0), ..Block::empty() };
    let (steps, alarm) = run(&shift, &[on(5.0), radius, line(10.0, 0.0)]);
    assert_eq!((steps.len(), steps[0].segment.clone()), (1, Segment::Hold));
    assert_eq!(alarm, Some(Alarm { block: 1, kind: AlarmKind::OffsetChangedInMode }));
}

#[test]
fn no_entry_arc_while_the_tool_stands_off_the_program() {
    // After G40 without movement the tool stands at (5, 5), the program at (5, 0).
    let entry = Parameters { start_up_arc: StartUpArc::MovedCentre, arc_end_tolerance: WIDE, ..*SEED_MILL };
    let arc = Movement::Arc { end: [15.0, 10.0], centre: Centre::FromStart([0.0, 10.0]), direction: COUNTER };
    let enters = Block { compensation: Some(LEFT), ..Block::moving(arc) };
    let (steps, alarm) = run(&entry, &[start(), code(Compensation::Off), enters.clone(), line(15.0, 30.0)]);
    assert_eq!((steps.len(), alarm), (2, Some(Alarm { block: 2, kind: AlarmKind::ArcAtCancel })));
    // Where the two are one it enters: V = (10, 10), and (-5/2, 10) is 25/2 from (5, 0) and from V.
    let on = Block { radius: Some(5.0), ..enters };
    let (steps, alarm) = run(&entry, &[line(5.0, 0.0), on, line(15.0, 30.0)]);
    assert_eq!((alarm, steps[1].clause), (None, clause::TRC_CORNER_02));
    let Segment::Arc { end, centre, .. } = steps[1].segment else { panic!("an arc") };
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 1e-12 && (a[1] - b[1]).abs() < 1e-12;
    assert!(near(end, [10.0, 10.0]) && near(centre, [-2.5, 10.0]), "{end:?} {centre:?}");
}

const COUNTER: Direction = Direction::Counterclockwise;
const WIDE: Ratio = Ratio { numerator: 1, denominator: 1 };

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
            Block::moving(Movement::HeldVector { end: [0.0, number] }),
            Block::moving(Movement::NewVector { vector: [number, 0.0] }),
            Block::moving(Movement::CornerArc { vector: Some([0.0, number]) }),
            Block { vector: Some([number, 1.0]), ..code(LEFT) },
            Block { vector: Some([0.0, number]), compensation: Some(LEFT), ..line(9.0, 9.0) },
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
