//! No bit pattern panics, and none makes a coordinate that is not finite; the engine is small.

mod common;

use common::{SEED_MILL, run};
use proptest::prelude::*;
use radcomp_impl::Engine;
use radcomp_spec::parameters::*;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Segment, Side, Step};

#[test]
fn the_engine_is_small() {
    assert!(size_of::<Engine>() <= 4096, "{}", size_of::<Engine>());
}

/// Numbers of every bit pattern; numbers of a small grid, which make degenerate geometry; and numbers in between.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => any::<u64>().prop_map(f64::from_bits),
        1 => prop::sample::select(vec![1e9, -1e9, 1e-9, 5e-324, -1e-200, 1e-150, 0.0, -0.0, f64::NAN, f64::INFINITY]),
        12 => (-6_i32..=6).prop_map(f64::from),
        3 => -100.0..100.0,
        2 => (-1e9..1e9, -320_i32..0).prop_map(|(value, power)| value * 10_f64.powi(power)),
    ]
}

fn movement() -> impl Strategy<Value = Movement<f64>> {
    let point = || [number(), number()];
    let sense = prop_oneof![Just(Direction::Clockwise), Just(Direction::Counterclockwise)];
    let centre = prop_oneof![point().prop_map(Centre::FromStart), number().prop_map(Centre::Radius)];
    prop_oneof![
        1 => Just(Movement::None),
        4 => point().prop_map(|end| Movement::Line { end }),
        1 => point().prop_map(|vector| Movement::Dummy { vector }),
        3 => (point(), centre, sense).prop_map(|(end, centre, direction)| Movement::Arc { end, centre, direction }),
    ]
}

fn block() -> impl Strategy<Value = Block<f64>> {
    let code = prop_oneof![
        12 => Just(None),
        1 => Just(Some(Compensation::Off)),
        2 => Just(Some(Compensation::On(Side::Left))),
        2 => Just(Some(Compensation::On(Side::Right))),
    ];
    let corner = prop::sample::select(vec![None, Some(OuterCorner::Arc), Some(OuterCorner::Intersection)]);
    let radius = prop_oneof![30 => Just(None), 1 => number().prop_map(Some)];
    (movement(), any::<bool>(), code, radius, corner).prop_map(|(movement, rapid, compensation, radius, corner)| {
        Block { movement, rapid, compensation, radius, corner }
    })
}

fn parameters() -> impl Strategy<Value = Parameters> {
    let pick = |count: usize| 0..count;
    ((pick(2), pick(2), pick(2), pick(3), pick(2)), (0_u8..=8, pick(2), pick(2), 0_u32..200)).prop_map(
        |((lost, outer, reversal, side, after), (non_moving_allowed, owner, reversed, tolerance))| Parameters {
            start_up_lost: StartUpLost::VALUES[lost].1,
            outer_corner: OuterCorner::VALUES[outer].1,
            reversal: Reversal::VALUES[reversal].1,
            side_change: SideChange::VALUES[side].1,
            side_change_after_start_up: SideChangeAfterStartUp::VALUES[after].1,
            non_moving_allowed,
            corner_owner: CornerOwner::VALUES[owner].1,
            reversed_path: ReversedPath::VALUES[reversed].1,
            arc_end_tolerance: Ratio { numerator: tolerance * tolerance, denominator: 1000 },
            ..SEED_MILL
        },
    )
}

fn is_finite(step: &Step<f64>) -> bool {
    match step.segment {
        Segment::Line { end } => end.iter().all(|number| number.is_finite()),
        Segment::Arc { end, centre, .. } => end.iter().chain(&centre).all(|number| number.is_finite()),
        Segment::Hold => true,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_step_is_finite_and_in_order(
        parameters in parameters(),
        tool in (0_i32..4).prop_map(f64::from),
        mut blocks in prop::collection::vec(block(), 1..24),
    ) {
        // Most programs are to get as far as the offset mode.
        blocks.insert(0, Block { radius: Some(tool), compensation: Some(Compensation::On(Side::Left)), ..Block::empty() });
        let (steps, alarm) = run(&parameters, &blocks);
        prop_assert!(steps.iter().all(is_finite));
        prop_assert!(steps.is_sorted_by_key(|step| step.block));
        // Every block before the alarm has its own step; none of the alarm's block is emitted.
        let emitted = alarm.map_or(blocks.len(), |alarm| alarm.block);
        let own = steps.iter().filter(|step| step.main || step.segment == Segment::Hold);
        prop_assert!(own.map(|step| step.block).eq(0..emitted));
        prop_assert!(steps.iter().all(|step| step.block < emitted));
    }
}
