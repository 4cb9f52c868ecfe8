//! What becomes of numbers when the program's numbers move, and signs that take too many bits.

use proptest::prelude::*;
use rug::Rational;

use super::super::{Real, within_bits};
use super::decimal;

/// The same expression of three numbers, of which one is zero where they happen to be right.
fn expression([a, b, c]: [&Real; 3]) -> Real {
    let length = (a.square() + b.square()).sqrt_or_zero();
    let quotient = (a * c).checked_div(&(length.clone() + Real::integer(3))).expect("at least 3");
    (quotient - b).square() + (&length - c) * b
}

proptest! {
    #[test]
    fn every_moved_expression_lies_within_reach(
        numbers in [decimal(), decimal(), decimal()],
        moves in [-1000_i64..=1000, -1000_i64..=1000, -1000_i64..=1000],
    ) {
        const SPREAD: f64 = 1.0 / 1024.0;
        let inputs = numbers.each_ref().map(Real::input);
        let (low, high) = expression(inputs.each_ref()).reach(SPREAD);
        let mut moved = numbers.clone();
        for (number, share) in moved.iter_mut().zip(moves) {
            *number += Rational::from((share, 1000)) / 1024;
        }
        let moved = expression(moved.map(Real::rational).each_ref());
        let at = |end: f64| Real::rational(Rational::from_f64(end).expect("finite"));
        prop_assert!(at(low) <= moved && moved <= at(high), "{low:e} {high:e}");
    }

    #[test]
    fn an_input_is_the_rational_that_it_is(numbers in [decimal(), decimal(), decimal()]) {
        let inputs = numbers.each_ref().map(Real::input);
        let plain = numbers.map(Real::rational);
        prop_assert_eq!(expression(inputs.each_ref()), expression(plain.each_ref()));
    }
}

#[test]
fn what_is_zero_by_chance_is_followed() {
    let [a, b] = [3, 3].map(|value| Real::input(&Rational::from(value)));
    let zero = &a - &b;
    assert!(zero.is_zero());
    // Its sign is known now, and yet its place in a product is kept.
    let (low, high) = (zero * Real::integer(5)).reach(0.5);
    assert!((-5.001..=-5.0).contains(&low) && (5.0..5.001).contains(&high), "{low} {high}");
}

#[test]
fn a_sign_that_takes_too_many_bits_is_given_up_and_not_learnt() {
    let root = |value: Real| value.sqrt().expect("positive");
    let [p, q] = [1_000_003, 1_000_033];
    // √(p + √q)·√(p - √q) = √(p² - q)
    let zero = || {
        let inner = root(Real::integer(q));
        let product = root(Real::integer(p) + &inner) * root(Real::integer(p) - &inner);
        product - root(Real::integer(p * p - q))
    };
    let number = zero();
    assert_eq!(within_bits(16, || number.is_zero()), None);
    assert_eq!(within_bits(1_000_000, || number.is_zero()), Some(true));
    assert_eq!(within_bits(16, || Real::one().is_zero()), Some(false));
    assert!(zero().is_zero());
}
