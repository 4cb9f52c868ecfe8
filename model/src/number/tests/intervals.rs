//! Filters and enclosures contain the number; enclosures are as narrow as asked.

use proptest::prelude::*;
use rug::Rational;

use super::{expression, tiny};
use crate::number::Real;
use crate::number::filter::Interval;

/// Whether the interval holds a value between the two rationals.
fn meets(filter: (f64, f64), low: &Rational, high: &Rational) -> bool {
    let below = filter.0 == f64::NEG_INFINITY || Rational::from_f64(filter.0).unwrap() <= *high;
    let above = filter.1 == f64::INFINITY || Rational::from_f64(filter.1).unwrap() >= *low;
    below && above
}

/// Ends of intervals that try the special cases.
fn end() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(f64::MAX),
        Just(f64::MIN),
        Just(5e-324),
        Just(-5e-324),
        Just(1.0),
        Just(f64::MIN_POSITIVE),
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        -1e3..1e3,
    ]
}

fn holds(interval: Interval, value: &Rational) -> bool {
    !interval.low.is_nan() && !interval.high.is_nan() && meets((interval.low, interval.high), value, value)
}

proptest! {
    #[test]
    fn filters_and_enclosures_contain(x in expression()) {
        let filter = x.filter();
        let (low, high) = x.enclosure(300);
        prop_assert!(low <= high);
        prop_assert!(Rational::from(&high - &low) <= tiny(300));
        prop_assert!(meets(filter, &low, &high), "{:?} misses {}", filter, low.to_f64());
        for bits in [0, 10, 64, 200, 299] {
            let (wide_low, wide_high) = x.enclosure(bits);
            prop_assert!(Rational::from(&wide_high - &wide_low) <= tiny(bits));
            prop_assert!(wide_low <= high && low <= wide_high);
        }
        let (low, high) = (Real::from(low), Real::from(high));
        prop_assert!(low <= x && x <= high);
        prop_assert!(meets(x.filter(), low.as_rational().unwrap(), high.as_rational().unwrap()));
    }

    #[test]
    fn interval_operations_hold_the_exact_results(a in end(), b in end(), c in end(), d in end(), s in 0..3, t in 0..3) {
        let [x, y] = [(a, b), (c, d)].map(|(p, q)| Interval { low: p.min(q), high: p.max(q) });
        // A point of each interval: an end or the middle.
        let point = |i: Interval, which| {
            let (low, high) = (Rational::from_f64(i.low).unwrap(), Rational::from_f64(i.high).unwrap());
            match which { 0 => low, 1 => high, _ => (low + high) / 2 }
        };
        let (p, q) = (point(x, s), point(y, t));
        prop_assert!(holds(x.add(y), &Rational::from(&p + &q)));
        prop_assert!(holds(x.subtract(y), &Rational::from(&p - &q)));
        prop_assert!(holds(x.multiply(y), &Rational::from(&p * &q)));
        prop_assert!(holds(x.square(), &Rational::from(p.square_ref())));
        if !q.is_zero() {
            prop_assert!(holds(x.divide(y), &Rational::from(&p / &q)), "{:?} / {:?} = {:?}", x, y, x.divide(y));
        }
        if !p.is_negative() {
            let root = x.sqrt();
            prop_assert!(Rational::from_f64(root.low).unwrap().square() <= p);
            prop_assert!(root.high.is_infinite() || Rational::from_f64(root.high).unwrap().square() >= p);
        }
        for (interval, value) in [(x, &p), (y, &q)] {
            prop_assert!(holds(interval, value));
            if let Some(e) = interval.ceiling() {
                let size = value.clone().abs();
                prop_assert!(size <= Rational::from(1) << e as i32);
            }
            if let Some(e) = interval.floor() {
                prop_assert!(value.clone().abs() >= Rational::from(1) << e as i32);
            }
        }
    }

    #[test]
    fn rationals_lie_in_their_interval(n in any::<i128>(), d in 1..i128::MAX, e in -2400_i32..2400) {
        let value = Rational::from((n, d)) << e;
        prop_assert!(holds(Interval::of_rational(&value), &value));
        let small = Rational::from((n >> 80, (d >> 90) + 1));
        prop_assert!(holds(Interval::of_rational(&small), &small));
        for mantissa in [n, n >> 70, n >> 74, n >> 75, n >> 76, n >> 120, 1 << 53, (1 << 53) - 1, -1 << 60, 0] {
            let scaled = Interval::of_scaled(&rug::Integer::from(mantissa), i64::from(e));
            let unit = Rational::from(1) >> e;
            prop_assert!(holds(scaled, &(Rational::from(mantissa) * &unit + &unit)));
            prop_assert!(holds(scaled, &(Rational::from(mantissa) * &unit - &unit)));
        }
    }
}

#[test]
fn a_rational_is_its_own_enclosure() {
    let third = Rational::from((1, 3));
    assert_eq!(Real::from(&third).enclosure(5), (third.clone(), third));
}
