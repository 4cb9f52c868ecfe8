//! Signs and order of numbers that come near zero, are huge or tiny, or were made in many steps.

use core::cmp::Ordering;

use proptest::prelude::*;
use rug::Rational;
use rug::ops::Pow;

use super::{expression, int, root, tiny};
use crate::number::Real;

proptest! {
    #[test]
    fn order_agrees_with_enclosures(a in expression(), b in expression()) {
        let ((a_low, a_high), (b_low, b_high)) = (a.enclosure(400), b.enclosure(400));
        match a.cmp(&b) {
            Ordering::Less => prop_assert!(a_low < b_high),
            Ordering::Greater => prop_assert!(a_high > b_low),
            Ordering::Equal => prop_assert!(a_low <= b_high && b_low <= a_high),
        }
        prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        prop_assert_eq!((&a - &b).sign(), a.cmp(&b));
    }

    #[test]
    fn numbers_keep_the_separation_bound(x in expression(), y in expression()) {
        // Differences of squares: near to zero more often than sums are, and zero now and then.
        for value in [x.clone(), &x * &y - &y, (&x - &y) * (&x + &y) - x.square() + y.square()] {
            let bits = value.separation_bits();
            if bits > 20_000 {
                continue;
            }
            let (low, high) = value.enclosure(bits.max(0) as u32 + 64);
            let least = tiny(bits.max(0) as u32) - tiny(bits.max(0) as u32 + 60);
            let zero_inside = low <= 0 && high >= 0;
            prop_assert!(zero_inside || low >= least || high <= -least);
            prop_assert_eq!(value.is_zero(), zero_inside);
            if let Some(form) = value.closed_form() {
                // The normal form knows zero on its own.
                prop_assert_eq!(form == "0", zero_inside);
            }
        }
    }

    #[test]
    fn roots_next_to_integers(n in 1_i64..1_000_000_000) {
        // √(n² + 1) - n - 1/(2n) = -1/(8n³) + … is never zero.
        let square = Real::integer(n).square() + int(1);
        let half = Real::rational(Rational::from((1, 2 * n)));
        prop_assert_eq!((square.sqrt().unwrap() - int(n) - half).sign(), Ordering::Less);
    }

    #[test]
    fn powers_of_a_small_conjugate(power in 1_u32..200) {
        // (√2 - 1)^n > 0 as a + b√2, which cancels 2.54·n bits.
        let (mut a, mut b) = (Rational::from(1), Rational::from(0));
        for _ in 0..power {
            (a, b) = (Rational::from(&b * 2) - &a, Rational::from(&a - &b));
        }
        let value = Real::from(a) + Real::from(b) * root(2);
        prop_assert_eq!(value.sign(), Ordering::Greater);
        // Its conjugate's product with it is ±1.
        let inverse = int(1).checked_div(&value).unwrap();
        prop_assert!((inverse.to_f64().ln() / f64::from(power) - 0.881_373_587_019_543).abs() < 1e-12);
    }
}

#[test]
fn numbers_beyond_the_range_of_f64() {
    let huge = Real::from(Rational::from(10).pow(400_u32) + 1_u32).sqrt().unwrap();
    let square = &huge * &huge + &huge;
    assert!(huge.sign().is_gt() && square.sign().is_gt());
    let small = int(1).checked_div(&square).unwrap().square();
    assert!(small.sign().is_gt());
    assert_eq!(small.to_f64(), f64::from_bits(1));
    assert_eq!((-&small).to_f64(), -f64::from_bits(1));
    assert_eq!(square.to_f64(), f64::INFINITY);
    assert_eq!(&small.sqrt().unwrap() * &square, int(1));
    let back = int(1).checked_div(&small.sqrt().unwrap()).unwrap();
    assert_eq!(back, square);
    assert!(back > square - Real::rational(tiny(3000)));
}

#[test]
fn tiny_differences_are_seen() {
    let near = root(2) + Real::rational(tiny(5000));
    assert!(near > root(2));
    assert!((near - root(2)).sign().is_gt());
    // 10 m grid of 0.1 µm, nested twice, 300 bits from equal.
    let nested = (int(3) + int(2) * root(2) + Real::rational(tiny(300))).sqrt().unwrap();
    assert!(nested > int(1) + root(2));
}

#[test]
fn roots_of_negative_numbers_are_refused() {
    assert!(int(-1).sqrt().is_none());
    assert!((root(2) - root(3)).sqrt().is_none());
    assert!((root(2) - root(2)).sqrt().unwrap().is_zero());
    assert!((root(2) - root(3)).sqrt_or_zero().is_zero());
    assert_eq!((root(2) - root(3)).abs(), root(3) - root(2));
    assert_eq!(int(4).sqrt_or_zero().as_rational(), Some(&Rational::from(2)));
}

#[test]
fn folding() {
    assert_eq!(Real::rational(Rational::from((9, 16))).sqrt().unwrap().as_rational(), Some(&Rational::from((3, 4))));
    let x = root(2);
    assert_eq!((&x * &x).as_rational(), Some(&Rational::from(2)));
    assert_eq!(x.square().as_rational(), Some(&Rational::from(2)));
    assert!((&x - &x).as_rational().is_some());
    assert!((&x * int(0)).as_rational().is_some());
    assert_eq!(x.checked_div(&x).unwrap().as_rational(), Some(&Rational::from(1)));
    assert!(int(1).checked_div(&int(0)).is_none());
}

#[test]
fn eight_independent_roots() {
    let radicands = [2, 3, 5, 7, 11, 13, 17, 19];
    let sum = |order: &mut dyn Iterator<Item = &i64>| order.fold(int(0), |sum, n| sum + root(*n));
    let (forward, backward) = (sum(&mut radicands.iter()), sum(&mut radicands.iter().rev()));
    assert_eq!(forward, backward);
    assert!(forward < backward + Real::rational(tiny(1000)));
}

#[test]
fn long_sums_do_not_overflow_the_stack() {
    let step = root(3);
    let mut sum = root(2);
    for _ in 0..10_000 {
        sum = &sum + &step;
    }
    assert_eq!(sum.sign(), Ordering::Greater);
    let (low, high) = sum.enclosure(100);
    assert!(Rational::from(&high - &low) <= tiny(100));
    assert!(sum > int(17_321));
    assert!(sum.closed_form().is_none());
    assert_ne!(sum, int(10_000) * root(3) + root(2) + Real::rational(tiny(100)));
}

#[test]
fn a_long_sum_is_proved_equal_to_a_product() {
    let step = root(3);
    let sum = (0..1_000).fold(root(2), |sum, _| sum + &step);
    assert_eq!(sum, int(1_000) * root(3) + root(2));
}

#[test]
fn dropping_long_chains_does_not_overflow_the_stack() {
    let mut chain = root(2);
    for i in 0..200_000 {
        chain = if i % 2 == 0 { int(1) + chain } else { chain.checked_div(&int(2)).unwrap() };
    }
    assert!(chain > Real::rational(Rational::from((1, 2))) && chain < int(3));
    let shared = chain.clone();
    drop(chain);
    drop(shared);
}
