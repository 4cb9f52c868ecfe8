//! The harnesses of rounded signs, over pairs of extreme numbers and at random.

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Exhaustive};
use radcomp_proofs::rounding::{not_a_number, odd, sound};

const NUMBERS: &[f64] = &[
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-15,
    -1e-13,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    1e9,
    1e308,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

#[test]
fn every_pair() {
    let visited = Exhaustive::search(NUMBERS, |choice| sound(choice));
    println!("signs: {} pairs of numbers", visited.runs);
    assert_eq!(visited.reached.len(), 3);
    assert_eq!(Exhaustive::search(NUMBERS, |choice| odd(choice)).runs, 256);
    assert_eq!(Exhaustive::search(NUMBERS, |choice| not_a_number(choice)).runs, 16);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bit_pattern(bytes in any::<[u8; 18]>()) {
        odd(&mut Bytes(&bytes));
        sound(&mut Bytes(&bytes));
        not_a_number(&mut Bytes(&bytes));
    }
}
