//! Doubles and decimals.

use proptest::prelude::*;
use rug::Rational;

use super::{decimal, expression, int, root};
use crate::number::{Real, format_decimal, nearest_f64, parse_decimal};

proptest! {
    #[test]
    fn nearest_double_is_what_the_standard_library_reads(text in "-?[0-9]{1,40}\\.[0-9]{0,40}") {
        prop_assert_eq!(nearest_f64(&parse_decimal(&text).unwrap()).to_bits() << 1, text.parse::<f64>().unwrap().to_bits() << 1);
    }

    #[test]
    fn nearest_double_of_extreme_decimals(digits in "[0-9]{1,25}", zeros in 0_usize..345, above: bool) {
        let text = if above { digits + &"0".repeat(zeros) } else { format!("0.{}{digits}", "0".repeat(zeros)) };
        prop_assert_eq!(nearest_f64(&parse_decimal(&text).unwrap()), text.parse::<f64>().unwrap());
    }

    #[test]
    fn ties_go_to_even(bits in 0..f64::MAX.to_bits(), nudge in -1_i32..2) {
        let (low, high) = (f64::from_bits(bits), f64::from_bits(bits + 1));
        let middle = (Rational::from_f64(low).unwrap() + Rational::from_f64(high).unwrap()) / 2;
        let value = middle + (Rational::from(nudge) >> 2000_u32);
        let expected = match nudge { -1 => low, 1 => high, _ => if bits % 2 == 0 { low } else { high } };
        prop_assert_eq!(nearest_f64(&value), expected);
        prop_assert_eq!(nearest_f64(&-value), -expected);
    }

    #[test]
    fn doubles_survive(x in any::<f64>().prop_filter("finite", |x| x.is_finite())) {
        prop_assert_eq!(nearest_f64(&Rational::from_f64(x).unwrap()), x);
    }

    #[test]
    fn to_f64_is_nearest(x in expression()) {
        let (low, high) = x.enclosure(600);
        let value = x.to_f64();
        prop_assert!(nearest_f64(&low) <= value && value <= nearest_f64(&high));
        prop_assert_eq!(value.partial_cmp(&0.0).unwrap(), x.sign());
    }

    #[test]
    fn decimals_round_trip(value in decimal()) {
        let text = format_decimal(&value).unwrap();
        prop_assert_eq!(parse_decimal(&text).unwrap(), value);
        prop_assert!(!text.contains('.') || !text.ends_with('0'));
    }

    #[test]
    fn to_decimal_is_within_half_a_unit(x in expression(), digits in 0_usize..40) {
        let shown = parse_decimal(&x.to_decimal(digits)).unwrap();
        let half = Real::rational(Rational::from((1, 2)) / Rational::from(rug::Integer::from(10).pow(digits as u32)));
        prop_assert!((x - Real::from(shown)).abs() <= half);
    }
}

use rug::ops::Pow;

#[test]
fn exact_decimals() {
    for (text, value) in [("-12.5", (-25, 2)), (".5", (1, 2)), ("5.", (5, 1)), ("+3", (3, 1)), ("-0.0", (0, 1))] {
        assert_eq!(parse_decimal(text), Some(Rational::from(value)), "{text}");
    }
    for text in ["", ".", "-", "+.", "1e3", "1,5", " 1", "1 ", "--1", "+-1", "1.2.3", "٣", "1_000", "inf"] {
        assert_eq!(parse_decimal(text), None, "{text:?}");
    }
    let long = "123456789012345678901234567890.000000000000000000000000000001";
    assert_eq!(format_decimal(&parse_decimal(long).unwrap()).as_deref(), Some(long));
    assert_eq!(format_decimal(&Rational::from((1, 3))), None);
    assert_eq!(format_decimal(&Rational::from((-1, 16))).as_deref(), Some("-0.0625"));
    assert_eq!(format_decimal(&Rational::from(0)).as_deref(), Some("0"));
    assert_eq!(format_decimal(&Rational::from(1200)).as_deref(), Some("1200"));
}

#[test]
fn ties_round_away_from_zero() {
    let shown = |text: &str, digits| Real::from(parse_decimal(text).unwrap()).to_decimal(digits);
    assert_eq!(shown("0.125", 2), "0.13");
    assert_eq!(shown("-0.125", 2), "-0.13");
    assert_eq!(shown("2.5", 0), "3");
    assert_eq!(shown("-2.5", 0), "-3");
    assert_eq!(shown("0.12499999999999999999999999", 2), "0.12");
    assert_eq!(shown("-0.004", 2), "0.00");
    assert_eq!(shown("999.9999", 3), "1000.000");
    // A tie that is not a folded rational: (√2 + √3)² - 2√6 - 4.5 = 0.5.
    let tie = (root(2) + root(3)).square() - int(2) * root(6) - Real::from(Rational::from((9, 2)));
    assert_eq!(tie.as_rational(), None);
    assert_eq!(tie.to_decimal(0), "1");
    assert_eq!((-&tie).to_decimal(0), "-1");
    assert_eq!((&tie + int(1)).to_decimal(0), "2");
    assert_eq!((&tie - Real::rational(super::tiny(200))).to_decimal(0), "0");
    assert_eq!(root(2).to_decimal(50), "1.41421356237309504880168872420969807856967187537695");
}
