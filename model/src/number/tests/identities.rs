//! Numbers that are zero by an identity, which no filter and no refinement can show, only the separation bound.

use proptest::prelude::*;

use rug::Rational;

use super::{decimal, expression, fraction, int, length, root, tiny};
use crate::number::Real;

proptest! {
    #[test]
    fn square_of_a_sum_of_roots(a in length(), b in length()) {
        let (x, y) = (Real::from(&a).sqrt().unwrap(), Real::from(&b).sqrt().unwrap());
        let xy = Real::from(&a * b.clone()).sqrt().unwrap();
        // The factors are made apart, so that they are not folded as one square.
        let square = (&x + &y) * (&y + &x);
        prop_assert!((square - Real::from(a) - Real::from(b) - int(2) * xy).is_zero());
    }

    #[test]
    fn mitre_is_at_the_radius_from_both_lines(
        u in (decimal(), decimal()), v in (decimal(), decimal()), radius in length(),
    ) {
        let [ux, uy, vx, vy, r] = [u.0, u.1, v.0, v.1, radius].map(Real::from);
        let (lu, lv) = ((ux.square() + uy.square()).sqrt().unwrap(), (vx.square() + vy.square()).sqrt().unwrap());
        prop_assume!(!lu.is_zero() && !lv.is_zero());
        let unit = |x: &Real, y: &Real, l: &Real| (-y.checked_div(l).unwrap(), x.checked_div(l).unwrap());
        let (n, m) = (unit(&ux, &uy, &lu), unit(&vx, &vy, &lv));
        let denominator = int(1) + &n.0 * &m.0 + &n.1 * &m.1;
        prop_assume!(!denominator.is_zero());
        let factor = r.checked_div(&denominator).unwrap();
        let corner = ((&n.0 + &m.0) * &factor, (&n.1 + &m.1) * &factor);
        for (normal, (dx, dy)) in [(&n, (&ux, &uy)), (&m, (&vx, &vy))] {
            let distance = &corner.0 * &normal.0 + &corner.1 * &normal.1;
            prop_assert_eq!(&distance, &r);
            // The corner lies on the parallel of the line through its offset start.
            let offset = (&corner.0 - &r * &normal.0, &corner.1 - &r * &normal.1);
            prop_assert!((offset.0 * dy - offset.1 * dx).is_zero());
        }
    }

    #[test]
    fn nested_roots_denest(a in 1_i64..2000, b in 1_i64..2000) {
        // √(a + b + 2√(ab)) = √a + √b
        let nested = (int(a + b) + int(2) * root(a * b)).sqrt().unwrap();
        prop_assert_eq!(nested, root(a) + root(b));
    }

    #[test]
    fn quotients_undo_products(a in expression(), b in expression()) {
        if let Some(quotient) = a.checked_div(&b) {
            // A clone of the value with another history, so that nothing folds.
            prop_assert_eq!(quotient * (&b + int(0)), a);
        }
    }

    #[test]
    fn rational_rules(a in decimal(), b in decimal(), c in decimal()) {
        let [x, y, z] = [&a, &b, &c].map(Real::from);
        let value = (&x + &y) * &z - &x * &z;
        prop_assert_eq!(value.as_rational(), Some(&(b * c)));
    }
}

/// A rational that does not know it is one.
fn hidden(value: &Rational) -> Real {
    Real::rational(Rational::from(value / 2)) * (root(2) * root(2))
}

/// A rational in plain sight, and the same made by the same operations from hidden ones.
fn hidden_expression() -> impl Strategy<Value = (Real, Real)> {
    let leaf = fraction().prop_map(|value| (hidden(&value), Real::rational(value)));
    leaf.prop_recursive(4, 12, 2, |inner| {
        (inner.clone(), inner, 0..6).prop_map(|((a, x), (b, y), operation)| match operation {
            0 => (a + b, x + y),
            1 => (a - b, x - y),
            2 => (a * b, x * y),
            3 => (a.checked_div(&b).unwrap_or(a), x.checked_div(&y).unwrap_or(x)),
            // The product with the plain number keeps the square from folding.
            4 => ((&a * &x).sqrt().unwrap(), x.abs()),
            _ => (-a.square(), -x.square()),
        })
    })
}

proptest! {
    #[test]
    fn hidden_rationals_are_found((hidden, plain) in hidden_expression(), nudge in -1_i64..2) {
        let value = plain.as_rational().unwrap();
        for bits in [0, 1, 5, 60, 200, 1000] {
            let (low, high) = hidden.enclosure(bits);
            prop_assert!(low <= *value && *value <= high);
        }
        let (low, high) = hidden.filter();
        prop_assert!(low <= value.to_f64().next_up() && value.to_f64().next_down() <= high);
        prop_assert_eq!(hidden.sign(), plain.sign());
        prop_assert_eq!(hidden.to_f64(), plain.to_f64());
        prop_assert_eq!(hidden.to_decimal(20), plain.to_decimal(20));
        let beside = &plain + int(nudge) * Real::rational(tiny(400));
        prop_assert_eq!(hidden.cmp(&beside), 0.cmp(&nudge));
    }
}

#[test]
fn three_plus_two_roots_of_two() {
    let nested = (int(3) + int(2) * root(2)).sqrt().unwrap();
    assert_eq!(nested, int(1) + root(2));
}

#[test]
fn sums_of_four_roots() {
    // √2 + √5 and √(7 + 2√10); √6 + √7 - √2·√3 - √7
    assert!((root(2) + root(5) - (int(7) + int(2) * root(10)).sqrt().unwrap()).is_zero());
    assert!((root(6) + root(7) - root(2) * root(3) - root(7)).is_zero());
    // (√2 + √3 + √5)(-√2 + √3 + √5)(√2 - √3 + √5)(√2 + √3 - √5) = 24
    let (a, b, c) = (root(2), root(3), root(5));
    let heron = (&a + &b + &c) * (&b + &c - &a) * (&a + &c - &b) * (&a + &b - &c);
    assert_eq!(heron, int(24));
    assert_ne!(heron, int(24) + Real::rational(tiny(900)));
}

#[test]
fn golden_ratio() {
    let phi = (int(1) + root(5)).checked_div(&int(2)).unwrap();
    assert_eq!(phi.square(), &phi + int(1));
    assert_eq!(int(1).checked_div(&phi).unwrap(), &phi - int(1));
}

#[test]
fn a_proved_zero_is_remembered_and_simplifies() {
    let zero = (root(2) + root(3)).square() - int(5) - int(2) * root(6);
    assert!(zero.is_zero());
    assert_eq!(zero.filter(), (0.0, 0.0));
    assert!(int(1).checked_div(&zero).is_none());
    assert_eq!((&zero * root(7)).as_rational(), int(0).as_rational());
    assert_eq!(zero.to_f64(), 0.0);
    assert_eq!(zero.to_decimal(3), "0.000");
    assert_eq!(zero.closed_form().as_deref(), Some("0"));
}
