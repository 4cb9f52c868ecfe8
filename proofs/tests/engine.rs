//! The engine's harnesses over all choices of small scopes, and at random beyond.

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Exhaustive, Visited};
use radcomp_proofs::engine::{after_an_alarm, one_block, parameters, plain, programs};
use radcomp_spec::Parameters;
use radcomp_spec::parameters::{CornerOwner, OuterCorner, Reversal, ReversedPath, SideChange};

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

/// The choices of a profile that the shape of corners hangs on.
fn profiles() -> impl Iterator<Item = Parameters> {
    (0..16).map(|bits| Parameters {
        outer_corner: if bits & 1 == 0 { OuterCorner::Intersection } else { OuterCorner::Arc },
        reversal: if bits & 2 == 0 { Reversal::Outer } else { Reversal::Alarm },
        corner_owner: if bits & 4 == 0 { CornerOwner::Next } else { CornerOwner::Previous },
        reversed_path: if bits & 8 == 0 { ReversedPath::Advisory } else { ReversedPath::Alarm },
        side_change: if bits & 1 == 0 { SideChange::IntersectionWithin } else { SideChange::TwoNormals },
        ..plain()
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

proptest! {
    #![proptest_config(ProptestConfig { cases: 50_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bit_pattern(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let mut choice = Bytes(&bytes);
        let parameters = parameters(&mut choice);
        programs(&mut choice, &parameters, 24, 4);
        one_block(&mut choice, 4);
        after_an_alarm(&mut choice, 4);
    }
}
