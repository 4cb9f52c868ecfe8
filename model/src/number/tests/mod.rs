//! Tests of the exact numbers, one file to a subject.

mod conversions;
mod forms;
mod identities;
mod intervals;
mod reach;
mod signs;
mod speed;

use proptest::prelude::*;
use rug::{Integer, Rational};

use super::Real;

/// Decimals as in programs: up to four digits after the point.
fn decimal() -> impl Strategy<Value = Rational> {
    (-2_000_000_i64..2_000_000, 0_u32..5).prop_map(|(n, digits)| Rational::from((n, 10_i64.pow(digits))))
}

/// Decimals that are not negative.
fn length() -> impl Strategy<Value = Rational> {
    decimal().prop_map(|value| value.abs())
}

/// Small fractions of either sign.
fn fraction() -> impl Strategy<Value = Rational> {
    (-60_i64..60, 1_i64..13).prop_map(Rational::from)
}

/// Expressions of every operation; those that divide by zero or take the root of a negative number avoid it.
fn expression() -> impl Strategy<Value = Real> {
    let leaf = prop_oneof![fraction().prop_map(Real::from), length().prop_map(|x| Real::from(x).sqrt().unwrap())];
    leaf.prop_recursive(4, 12, 2, |inner| {
        (inner.clone(), inner, 0..7).prop_map(|(a, b, operation)| match operation {
            0 => a + b,
            1 => a - b,
            2 => a * b,
            3 => a.checked_div(&b).unwrap_or(a),
            4 => a.abs().sqrt().unwrap(),
            5 => a.square(),
            _ => -a,
        })
    })
}

fn root(value: i64) -> Real {
    Real::integer(value).sqrt().unwrap()
}

fn int(value: i64) -> Real {
    Real::integer(value)
}

/// 2^-bits.
fn tiny(bits: u32) -> Rational {
    Rational::from((Integer::from(1), Integer::from(1) << bits))
}
