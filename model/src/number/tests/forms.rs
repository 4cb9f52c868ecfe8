//! Closed forms and reading them back.

use proptest::prelude::*;
use rug::Rational;

use super::{expression, fraction, int, root};
use crate::number::{ParseRealError, Real};

fn form(text: &str) -> Option<String> {
    Real::parse(text).unwrap().closed_form()
}

proptest! {
    #[test]
    fn closed_forms_read_back_as_the_number(x in expression()) {
        if let Some(text) = x.closed_form() {
            let back = Real::parse(&text).unwrap();
            prop_assert_eq!(&back, &x, "{}", text);
            // Read back, a long radicand may be beyond the search for square factors.
            if let Some(again) = back.closed_form() {
                prop_assert_eq!(again, text);
            }
        }
    }

    #[test]
    fn binomials_have_closed_forms(a in fraction(), b in fraction(), c in 0_i64..40) {
        let x = Real::from(&a) + Real::from(&b) * root(c);
        let text = x.closed_form().unwrap();
        prop_assert_eq!(Real::parse(&text).unwrap(), x.clone());
        if let Some(inverse) = int(1).checked_div(&x) {
            prop_assert_eq!(Real::parse(&inverse.closed_form().unwrap()).unwrap(), inverse);
        }
        // The root of its square is denested.
        let square = Real::from(a.clone().square()) + Real::from(b.clone().square()) * int(c) + int(2) * Real::from(a * b) * root(c);
        prop_assert_eq!(square.sqrt().unwrap().closed_form(), x.abs().closed_form());
    }

    #[test]
    fn any_text_is_answered(text in "[0-9+*/().√·a-s -]{0,30}") {
        let _ = Real::parse(&text);
    }
}

#[test]
fn forms_people_expect() {
    for (text, expected) in [
        ("10 + 5*sqrt(2)", "10 + 5·√2"),
        ("-sqrt(3)/2", "-1/2·√3"),
        ("sqrt(8)", "2·√2"),
        ("sqrt(1/2)", "1/2·√2"),
        ("1/(1+√2)", "-1 + √2"),
        ("1/(√2+√3)", "-√2 + √3"),
        ("1/(1+√2+√3)", "1/2 + 1/4·√2 - 1/4·√6"),
        ("sqrt(3+2*sqrt(2))", "1 + √2"),
        ("sqrt(3-2*sqrt(2))", "-1 + √2"),
        ("sqrt(2+sqrt(3))", "1/2·√2 + 1/2·√6"),
        ("√(2 + √2)", "√(2 + √2)"),
        ("3 - √(8 + 4·√2)", "3 - 2·√(2 + √2)"),
        ("√√2", "√(√2)"),
        ("12.50", "25/2"),
        ("-3/4", "-3/4"),
        ("-0", "0"),
        ("2 - -3", "5"),
        ("sqrt(2)*sqrt(2)", "2"),
        ("√2·√2·√2", "2·√2"),
        ("(√2 + √3)·(√2 - √3)", "-1"),
        ("sqrt 5 × 2 − 1", "-1 + 2·√5"),
    ] {
        assert_eq!(form(text).as_deref(), Some(expected), "{text}");
    }
    assert_eq!(form("sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)+sqrt(11)+sqrt(13)+sqrt(17)+sqrt(19)"), None);
    assert_eq!(form("sqrt(10007*10009)/3").as_deref(), Some("1/3·√100160063"));
}

#[test]
fn display() {
    assert_eq!((int(1) + root(2)).to_string(), "1 + √2");
    let messy = root(2) + root(3) + root(5) + root(7) + root(11) + root(13) + root(17) + root(19);
    assert_eq!(messy.to_string(), "23.432264293484076");
    assert_eq!(format!("{:?}", int(3)), "Real(3)");
}

#[test]
fn errors_say_where() {
    let error = |text: &str| Real::parse(text).unwrap_err();
    assert_eq!(error(""), ParseRealError::UnexpectedEnd);
    assert_eq!(error("1 +"), ParseRealError::UnexpectedEnd);
    assert_eq!(error("(1"), ParseRealError::UnexpectedEnd);
    assert_eq!(error("1 2"), ParseRealError::Unexpected { at: 2, found: '2' });
    assert_eq!(error("√x"), ParseRealError::Unexpected { at: 3, found: 'x' });
    assert_eq!(error("1.2.3"), ParseRealError::Unexpected { at: 0, found: '1' });
    assert_eq!(error("1/(√2·√2 - 2)"), ParseRealError::DivisionByZero { at: 18 });
    assert_eq!(error("√(1-√2)"), ParseRealError::NegativeRadicand { at: 11 });
    assert!(matches!(error(&"(".repeat(100_000)), ParseRealError::TooDeep { .. }));
    assert!(matches!(error(&"-".repeat(100_000)), ParseRealError::TooDeep { .. }));
    assert_eq!(error("1/0").to_string(), "division by zero before byte 3");
    assert_eq!(Real::parse("0.1").unwrap().as_rational(), Some(&Rational::from((1, 10))));
}
