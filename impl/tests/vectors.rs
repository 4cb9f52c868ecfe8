//! Vectors that the program gives, where the worked examples are silent: rates, places, order of alarms, a tool without a
//! radius. [TRC-VEC-01] to [TRC-VEC-06], [TRC-START-10]

mod common;

use common::{SEED_MILL, run};
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, AlarmKind, Block, Clause, Compensation, Movement, Parameters, Segment, Side, clause};

fn line(x: f64, y: f64) -> Block<f64> {
    Block::moving(Movement::Line { end: [x, y] })
}

fn start(radius: f64) -> Block<f64> {
    Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(radius), ..line(5.0, 0.0) }
}

fn corner(vector: Option<[f64; 2]>) -> Block<f64> {
    Block::moving(Movement::CornerArc { vector })
}

fn new_vector(vector: [f64; 2]) -> Block<f64> {
    Block::moving(Movement::NewVector { vector })
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
fn a_corner_arc_that_waits_keeps_its_rate() {
    let blocks = [start(1.0), line(10.0, 0.0), rapid(corner(None)), Block::empty(), rapid(line(10.0, -9.0))];
    let expected: [Flags; 5] = [
        (0, clause::TRC_START_02, false, true),
        (1, clause::TRC_VEC_03, false, true),
        (2, clause::TRC_VEC_03, true, true),
        (3, clause::TRC_LOOK_02, false, false),
        (4, clause::TRC_MODE_04, true, true),
    ];
    assert_eq!(flags(&SEED_MILL, &blocks), expected);
}

#[test]
fn a_tool_without_a_radius_makes_no_corner_arc() {
    for vector in [None, Some([0.0, -1.0])] {
        let (steps, alarm) = run(&SEED_MILL, &[start(0.0), line(10.0, 0.0), corner(vector), line(10.0, -9.0)]);
        assert_eq!((alarm, steps[2].segment.clone()), (None, Segment::Hold));
    }
}

#[test]
fn of_two_vector_blocks_the_one_that_waits_moves_nothing() {
    let blocks = [start(1.0), line(10.0, 0.0), corner(None), new_vector([0.0, -1.0]), line(10.0, -9.0)];
    let (steps, alarm) = run(&SEED_MILL, &blocks);
    assert_eq!(alarm, None);
    assert_eq!((steps[2].segment.clone(), steps[2].clause), (Segment::Hold, clause::TRC_VEC_03));
    assert_eq!(steps[3].segment, Segment::Line { end: [11.0, 0.0] });
}

#[test]
fn a_vector_block_counts_for_a_change_of_side() {
    let right = Block { compensation: Some(Compensation::On(Side::Right)), ..Block::empty() };
    let corner = corner(Some([0.0, -1.0]));
    // The first element behind the start-up block: the alarm; behind a settled junction it is none.
    let (_, alarm) = run(&SEED_MILL, &[start(1.0), right.clone(), corner.clone()]);
    assert_eq!(alarm, Some(Alarm { block: 2, kind: AlarmKind::SideChangeAfterStartUp }));
    let none = Parameters { non_moving_allowed: Some(0), ..*SEED_MILL };
    let (steps, alarm) = run(&none, &[start(1.0), right, corner]);
    assert_eq!((alarm, steps.last().unwrap().segment.clone()), (None, Segment::Hold));
}

#[test]
fn a_held_vector_of_no_length_is_a_vector_block_in_cancel_mode() {
    let held = Block::moving(Movement::HeldVector { end: [0.0, 0.0] });
    let (_, alarm) = run(&SEED_MILL, &[held]);
    assert_eq!(alarm, Some(Alarm { block: 0, kind: AlarmKind::VectorCodeOutsideMode }));
    let held = Block::moving(Movement::HeldVector { end: [10.0, 0.0] });
    let blocks = [start(1.0), line(10.0, 0.0), held, line(10.0, 9.0)];
    assert_eq!(flags(&SEED_MILL, &blocks)[2], (2, clause::TRC_LOOK_02, false, false));
}

#[test]
fn a_vector_at_right_angles_to_the_start_up_block_is_no_entry_move() {
    let parameters =
        Parameters { start_up: StartUp::EntryNormal, side_code_vector: SideCodeVector::RightAngles, ..*SEED_MILL };
    // The entry is shorter than the radius.
    let (_, alarm) = run(&parameters, &[start(9.0), line(10.0, 0.0)]);
    assert_eq!(alarm, Some(Alarm { block: 0, kind: AlarmKind::EntryTooShort }));
    let (steps, alarm) = run(&parameters, &[Block { vector: Some([2.0, 0.0]), ..start(9.0) }, line(10.0, 0.0)]);
    assert_eq!((alarm, steps[0].segment.clone()), (None, Segment::Line { end: [5.0, 9.0] }));
}

#[test]
fn a_new_vector_has_the_value_before_it_or_that_in_force() {
    let parameters = Parameters { offset_change: OffsetChange::EndOfBlock, ..*SEED_MILL };
    let larger = Block { radius: Some(2.0), ..new_vector([0.0, -1.0]) };
    let (steps, alarm) = run(&parameters, &[start(1.0), line(10.0, 0.0), larger.clone()]);
    assert_eq!((alarm, steps[1].segment.clone()), (None, Segment::Line { end: [11.0, 0.0] }));
    assert_eq!(steps[2].segment, Segment::Hold);
    // The junction is settled already.
    let blocks = [start(1.0), line(10.0, 0.0), new_vector([0.0, -1.0]), larger];
    let (steps, alarm) = run(&parameters, &blocks);
    assert_eq!((alarm, steps[3].segment.clone()), (None, Segment::Line { end: [12.0, 0.0] }));
}

/// [TRC-MODE-11] the junction has the value of the block before it, also where that block puts another in force itself.
#[test]
fn each_block_ends_at_its_own_value() {
    let parameters = Parameters { offset_change: OffsetChange::EndOfBlock, ..*SEED_MILL };
    let larger = Block { radius: Some(2.0), ..line(20.0, 0.0) };
    let (steps, alarm) = run(&parameters, &[start(1.0), line(10.0, 0.0), larger, line(30.0, 0.0), line(30.0, -9.0)]);
    let ends: Vec<_> = steps.iter().map(|step| step.segment.clone()).collect();
    let to = |x: f64, y: f64| Segment::Line { end: [x, y] };
    assert_eq!((alarm, ends), (None, vec![to(5.0, 1.0), to(10.0, 1.0), to(20.0, 2.0), to(32.0, 2.0), to(32.0, -9.0)]));
    let (_, alarm) = run(&SEED_MILL, &[start(1.0), line(10.0, 0.0), Block { radius: Some(2.0), ..line(20.0, 0.0) }]);
    assert_eq!(alarm, Some(Alarm { block: 2, kind: AlarmKind::OffsetChangedInMode }));
}

/// The vector is carried from (-700, ...) to a place where coordinates are finer, and is that which G38 gives there.
#[test]
fn a_held_vector_is_not_left_by_its_rounding() {
    for (radius, x) in [0.0, 0.3, 1.7].into_iter().flat_map(|radius| (1..50).map(move |step| (radius, f64::from(step))))
    {
        let held = Block::moving(Movement::HeldVector { end: [x * 0.01, 0.07] });
        let blocks = [start(radius), new_vector([3.0, 4.0]), line(-700.3 + x, 9.1), new_vector([-0.7, 1.1]), held];
        let (steps, alarm) = run(&SEED_MILL, &[blocks.to_vec(), vec![new_vector([-0.7, 1.1])]].concat());
        assert_eq!(alarm, None);
        assert_eq!(steps[5].segment, Segment::Hold, "{radius} {x}");
    }
}
