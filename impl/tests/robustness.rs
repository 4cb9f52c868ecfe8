//! No bit pattern panics, and none makes a coordinate that is not finite; the engine is small.

mod common;

use common::{SEED_MILL, run};
use proptest::prelude::*;
use radcomp_impl::Engine;
use radcomp_spec::parameters::*;
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, Segment, Side, Step};

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
        1 => point().prop_map(|end| Movement::HeldVector { end }),
        1 => point().prop_map(|vector| Movement::NewVector { vector }),
        1 => prop::option::of(point()).prop_map(|vector| Movement::CornerArc { vector }),
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
    let corner = prop_oneof![12 => Just(None), 3 => (0..3_usize).prop_map(|pick| Some(OuterCorner::VALUES[pick].1))];
    let radius = prop_oneof![
        30 => Just(None),
        1 => number().prop_map(Some),
        2 => prop::sample::select(vec![Some(1.0), Some(-1.0)]),
    ];
    let approach = prop::option::weighted(0.1, any_of(Approach::VALUES));
    let stops = prop::bool::weighted(0.05);
    let not_in_mode = prop_oneof![60 => Just(None), 1 => Just(Some(AlarmKind::ToolChangeInMode))];
    // Beside an arc too, where no reader gives one.
    let vector = prop::option::weighted(0.3, [number(), number()]);
    (movement(), any::<bool>(), code, vector, radius, (corner, approach), stops, not_in_mode).prop_map(
        |(movement, rapid, compensation, vector, radius, (corner, approach), stops_look_ahead, not_in_mode)| Block {
            movement,
            rapid,
            compensation,
            vector,
            radius,
            corner,
            approach,
            stops_look_ahead,
            not_in_mode,
        },
    )
}

/// One of the values of a parameter; the count is that of all of them, so that a new value is not left out.
fn any_of<T: Copy + std::fmt::Debug>(values: &'static [(&'static str, T)]) -> impl Strategy<Value = T> {
    (0..values.len()).prop_map(|pick| values[pick].1)
}

/// 0, or a number between 0 and `most` in thousandths.
fn ratio(most: u32) -> impl Strategy<Value = Ratio> {
    prop_oneof![Just(0), 0..=most * 1000].prop_map(|numerator| Ratio { numerator, denominator: 1000 })
}

fn parameters() -> impl Strategy<Value = Parameters> {
    let start = (
        any_of(StartUp::VALUES),
        any_of(StartUpLost::VALUES),
        any_of(StartUpB::VALUES),
        any_of(StartUpWithoutMovement::VALUES),
        any_of(StartUpArc::VALUES),
        any_of(Cancel::VALUES),
        any_of(CancelWithoutMovement::VALUES),
    );
    let corners = (
        any_of(OuterCorner::VALUES),
        any_of(Reversal::VALUES),
        any_of(CornerOwner::VALUES),
        any_of(ArcExtension::VALUES),
        any_of(ArcOnRapid::VALUES),
    );
    let limits = (ratio(1), ratio(1), ratio(1), ratio(20), ratio(40));
    let rest = (
        any_of(SideChange::VALUES),
        any_of(SideChangeAfterStartUp::VALUES),
        any_of(ReversedPath::VALUES),
        any_of(SameCode::VALUES),
        any_of(NegativeRadius::VALUES),
        any_of(EqualRadius::VALUES),
        any_of(ZeroLengthMove::VALUES),
        prop::option::weighted(0.9, 0_u8..=8),
    );
    let vectors = (any_of(SideCodeVector::VALUES), any_of(CancelVector::VALUES), any_of(OffsetChange::VALUES));
    let several = (
        any_of(Interference::VALUES),
        any_of(InterferenceBlocks::VALUES),
        any_of(InterferenceBoundary::VALUES),
        ratio(20),
        ratio(20),
    );
    (start, corners, limits, rest, vectors, several).prop_map(|(start, corners, limits, rest, vectors, several)| {
        Parameters {
            start_up: start.0,
            start_up_lost: start.1,
            start_up_b: start.2,
            start_up_without_movement: start.3,
            start_up_arc: start.4,
            cancel: start.5,
            cancel_without_movement: start.6,
            outer_corner: corners.0,
            reversal: corners.1,
            corner_owner: corners.2,
            arc_extension: corners.3,
            arc_on_rapid: corners.4,
            corner_limit_cosine: limits.0,
            smallest_corner_cosine: limits.1,
            straight_band_cosine: limits.2,
            small_vector_limit: limits.3,
            arc_end_tolerance: limits.4,
            side_change: rest.0,
            side_change_after_start_up: rest.1,
            reversed_path: rest.2,
            same_code: rest.3,
            negative_radius: rest.4,
            equal_radius: rest.5,
            zero_length_move: rest.6,
            non_moving_allowed: rest.7,
            side_code_vector: vectors.0,
            cancel_vector: vectors.1,
            offset_change: vectors.2,
            interference: several.0,
            interference_blocks: several.1,
            interference_boundary: several.2,
            chord_tolerance: several.3,
            centre_tolerance: several.4,
            ..*SEED_MILL
        }
    })
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
