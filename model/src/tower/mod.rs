//! Exact real numbers a second time: towers of square roots, signs by repeated squaring.
//!
//! [`number`](crate::number) finds signs with intervals and a separation bound. This module finds them by algebra alone
//! and shares nothing with it, so that either checks the other. It is no part of the model's own work: it is slow where
//! many independent roots meet.
//!
//! A [`Number`] is a rational, or a pair a + b·√c whose a, b and c are made of older roots only. Roots are ordered by
//! age, so that a number belongs to a tower of fields Q = K₀ ⊂ K₁ ⊂ … with Kₙ = Kₙ₋₁(√cₙ), its youngest root on top.
//! The sign follows from the signs of a and b if they agree, and otherwise from the sign of a² - b²c, a number without
//! the youngest root (`sign`).
//!
//! A root may be *dependent*: cₙ the square of a number below, √cₙ no news. Then (a, b) ↦ a + b√cₙ is no longer one to
//! one, and a pair that is not (0, 0) may stand for 0. What is promised for any tower, dependent roots or not:
//!
//! - an operation on pairs gives a pair that stands for the result, since it uses nothing but √c·√c = c;
//! - the sign rule reads values, never whether a coefficient is written as 0: it yields "zero" when a = -b√c;
//! - a divisor whose conjugate a - b√c is 0 is 2a (`divide`).
//!
//! So independence is no condition of exactness, only of speed. [`Tower::sqrt`] looks for a root among the numbers made
//! of the tower's roots before it makes a new one, and finds it if it is there (`root`): the roots of one tower are
//! independent. Where numbers of different towers are mixed they need not be.
//!
//! ```
//! use radcomp_model::tower::{Number, Tower};
//! let mut tower = Tower::new(8);
//! let two = tower.sqrt(&Number::integer(2)).unwrap();
//! let nested = tower.sqrt(&(&Number::integer(3) + &(&Number::integer(2) * &two))).unwrap();
//! assert_eq!(nested, &Number::integer(1) + &two);
//! assert_eq!(tower.height(), 1);
//! ```

mod convert;
mod divide;
mod integral;
mod operators;
mod root;
mod sign;
#[cfg(test)]
mod tests;

use std::rc::Rc;

use rug::Rational;

pub use root::Tower;

/// An exact real number: a rational, or a + b·√c.
///
/// # Exactness
///
/// All operations, comparisons and signs are exact. The time of a sign doubles, roughly, with each root in the number.
#[derive(Clone)]
pub struct Number(Shape);

#[derive(Clone)]
enum Shape {
    Rational(Rational),
    Pair(Rc<Pair>),
}

/// The number `plain` + `factor`·√radicand.
///
/// Both parts are made of roots older than `root`, and `factor` is not written as 0.
struct Pair {
    plain: Number,
    factor: Number,
    root: Rc<Root>,
}

/// A square root that numbers are made of.
struct Root {
    /// A radicand is made of older roots only: their ages are smaller.
    age: u64,
    /// A positive number without denominators.
    radicand: Number,
}

/// Why there is no number.
///
/// # Exactness
///
/// Decided exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Refusal {
    /// The caller's limit: the tower would have more roots than it may.
    TooManyRoots,
    /// The caller asked for the square root of a negative number.
    NegativeRadicand,
    /// The caller asked for a quotient by zero.
    ZeroDivisor,
}

impl core::fmt::Display for Refusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Refusal::TooManyRoots => "the tower may have no further root",
            Refusal::NegativeRadicand => "the square root of a negative number",
            Refusal::ZeroDivisor => "a quotient by zero",
        })
    }
}

impl core::error::Error for Refusal {}

impl Number {
    /// A rational number.
    ///
    /// # Exactness
    ///
    /// Exact.
    pub fn rational(value: Rational) -> Number {
        Number(Shape::Rational(value))
    }

    /// A whole number.
    ///
    /// # Exactness
    ///
    /// Exact.
    pub fn integer(value: i64) -> Number {
        Number::rational(Rational::from(value))
    }

    fn zero() -> Number {
        Number::rational(Rational::new())
    }

    /// `plain` + `factor`·√radicand; the caller's parts are made of older roots than `root`.
    fn pair(plain: Number, factor: Number, root: &Rc<Root>) -> Number {
        if factor.is_written_zero() {
            return plain;
        }
        Number(Shape::Pair(Rc::new(Pair { plain, factor, root: Rc::clone(root) })))
    }

    /// Whether the number is the rational 0. A pair may be 0 as well, if its root is dependent.
    fn is_written_zero(&self) -> bool {
        matches!(&self.0, Shape::Rational(value) if value.is_zero())
    }
}

impl core::fmt::Display for Number {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match &self.0 {
            Shape::Rational(value) => write!(f, "{value}"),
            Shape::Pair(pair) => write!(f, "({} + {}·√{})", pair.plain, pair.factor, pair.root.radicand),
        }
    }
}

impl core::fmt::Debug for Number {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        core::fmt::Display::fmt(self, f)
    }
}
