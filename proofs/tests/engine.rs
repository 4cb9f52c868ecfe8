//! The engine's harnesses over all choices of small scopes, and at random beyond.

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Exhaustive, Visited};
use radcomp_proofs::engine::{after_an_alarm, one_block, parameters, plain, programs, programs_with_vectors};
use radcomp_spec::Parameters;
use radcomp_spec::parameters::*;

/// Whole, extreme, and no numbers.
const NUMBERS: &[f64] = &[0.0, 1.0, -2.5, 1e9, -1.0000001e9, 5e-324, f64::INFINITY, f64::NAN];

fn tell(what: &str, visited: &Visited, places: &[&str]) {
    println!("engine, {what}: {} programs", visited.runs);
    assert!(visited.reached.iter().eq(places), "{:?}", visited.reached);
}

#[test]
fn every_block() {
    let visited = Exhaustive::search(NUMBERS, |choice| one_block(choice, 4));
    tell("one block of any kind", &visited, &["a block is refused", "a block is taken"]);
}

#[test]
fn every_block_after_an_alarm() {
    let visited = Exhaustive::search(&[1.0, f64::NAN], |choice| after_an_alarm(choice, 3));
    tell("a block after an alarm", &visited, &["an alarm"]);
}

/// Sixteen profiles that mix the rules of corners, changes of side, start-up and cancel: each value written below comes in
/// some of them, beside others of each of the other parameters.
fn profiles() -> impl Iterator<Item = Parameters> {
    (0..16_usize).map(|number| {
        let bit = |mask: usize| (number & mask).count_ones() % 2 == 1;
        let sides =
            [SideChange::IntersectionWithin, SideChange::Intersection, SideChange::Crossing, SideChange::TwoNormals];
        let limit = |mask| Ratio { numerator: if bit(mask) { 3 } else { 0 }, denominator: 5 };
        Parameters {
            outer_corner: match (bit(1), bit(2)) {
                (false, false) => OuterCorner::Intersection,
                (false, true) => OuterCorner::LimitAngle,
                (true, _) => OuterCorner::Arc,
            },
            start_up: match (bit(4), bit(8)) {
                (false, _) => StartUp::TypeA,
                (true, false) => StartUp::TypeB,
                (true, true) => StartUp::EntryNormal,
            },
            side_change: sides[number / 2 % 4],
            reversal: if bit(3) { Reversal::Alarm } else { Reversal::Outer },
            corner_owner: if bit(5) { CornerOwner::Previous } else { CornerOwner::Next },
            reversed_path: if bit(6) { ReversedPath::Alarm } else { ReversedPath::Advisory },
            cancel: if bit(7) { Cancel::TypeB } else { Cancel::TypeA },
            cancel_without_movement: if bit(9) { CancelWithoutMovement::Shift } else { CancelWithoutMovement::None },
            start_up_without_movement: if bit(10) {
                StartUpWithoutMovement::Shift
            } else {
                StartUpWithoutMovement::None
            },
            start_up_arc: if bit(11) { StartUpArc::MovedCentre } else { StartUpArc::Alarm },
            arc_extension: if bit(12) { ArcExtension::Curve } else { ArcExtension::Tangent },
            start_up_b: if bit(13) { StartUpB::Direct } else { StartUpB::ViaNormal },
            equal_radius: if bit(14) { EqualRadius::DegeneratePoint } else { EqualRadius::Alarm },
            same_code: if bit(15) { SameCode::Normal } else { SameCode::Ordinary },
            corner_limit_cosine: limit(8),
            smallest_corner_cosine: limit(10),
            straight_band_cosine: limit(13),
            small_vector_limit: limit(14),
            ..plain()
        }
    })
}

#[test]
fn every_program_of_three_lines_and_dummies() {
    let mut visited = Visited::default();
    for profile in profiles() {
        Exhaustive::search_on(&[0.0, 1.0, -1.0], &mut visited, |choice| programs(choice, &profile, 3, 3));
    }
    tell("three lines or dummy blocks on a grid", &visited, &["a corner move", "an alarm", "an end without alarm"]);
}

#[test]
fn every_program_of_three_lines_and_arcs() {
    let mut visited = Visited::default();
    for profile in profiles() {
        Exhaustive::search_on(&[0.0, 2.0], &mut visited, |choice| programs(choice, &profile, 3, 4));
    }
    tell(
        "three lines, dummy blocks or arcs on a small grid",
        &visited,
        &["a corner move", "an alarm", "an end without alarm"],
    );
}

#[test]
fn every_program_of_three_blocks_with_vectors() {
    let mut visited = Visited::default();
    for side_code_vector in [SideCodeVector::RightAngles, SideCodeVector::ImaginaryLine] {
        let parameters = Parameters { side_code_vector, cancel_vector: CancelVector::ImaginaryLine, ..plain() };
        Exhaustive::search_on(&[0.0, 1.0], &mut visited, |choice| programs_with_vectors(choice, &parameters, 3));
    }
    tell("three blocks with vectors", &visited, &["a corner move", "an alarm", "an end without alarm"]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 50_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bit_pattern(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let mut choice = Bytes(&bytes);
        let parameters = parameters(&mut choice);
        programs(&mut choice, &parameters, 12, 4);
        programs_with_vectors(&mut choice, &parameters, 12);
        one_block(&mut choice, 4);
        after_an_alarm(&mut choice, 4);
    }
}
