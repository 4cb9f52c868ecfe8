//! Exact real numbers: the rationals closed under `+`, `-`, `×`, `÷` and `√`.
//!
//! A [`Real`] is an expression. Operations on rationals are folded at once; what involves a root is kept as a node of a
//! directed acyclic graph. Its sign is found in three steps, each exact and each dearer than the one before:
//!
//! 1. a double-precision interval, computed as the node is made, excludes zero (`filter`);
//! 2. approximations to more and more bits exclude zero (`refine`);
//! 3. an approximation beyond the separation bound proves zero (`bound`).
//!
//! ```
//! use radcomp_model::number::Real;
//! let two = Real::integer(2);
//! let nested = (Real::integer(3) + Real::integer(2) * two.sqrt().unwrap()).sqrt().unwrap();
//! assert_eq!(nested, Real::one() + two.sqrt().unwrap());
//! ```

mod bound;
mod closed_form;
mod decimal;
mod expression;
mod filter;
mod node;
mod operators;
mod parse;
mod patience;
mod quadratic;
mod reach;
mod refine;
mod sign;
#[cfg(test)]
mod tests;

use std::rc::Rc;

use rug::{Integer, Rational};

pub use decimal::{format_decimal, nearest_f64, parse_decimal};
pub use expression::{Expression, Identity};
pub use parse::ParseRealError;
pub use patience::within_bits;

use filter::Interval;
use node::{Node, Shape};

/// An exact real number, built from rationals by `+`, `-`, `×`, `÷` and `√`.
///
/// Cheap to clone: a clone shares the expression and everything learnt about its value. Not `Send`: what is learnt is
/// kept without locks.
///
/// # Exactness
///
/// All operations, comparisons and signs are exact. The time of a sign grows with the number of bits that decide it; for
/// a number that is zero without being a folded rational these are as many as the separation bound asks for, which
/// doubles with each further independent square root in the expression.
#[derive(Clone)]
pub struct Real(Rc<Node>);

impl Real {
    /// The number 0.
    pub fn zero() -> Real {
        Real::integer(0)
    }

    /// The number 1.
    pub fn one() -> Real {
        Real::integer(1)
    }

    /// A whole number.
    pub fn integer(value: i64) -> Real {
        Real::rational(Rational::from(value))
    }

    /// A rational number.
    pub fn rational(value: Rational) -> Real {
        Real::node(Interval::of_rational(&value), Shape::Rational(value))
    }

    /// A rational number that [`Real::reach`] may move.
    ///
    /// # Exactness
    ///
    /// Exact, and in every other respect that rational; operations on it are not folded, which makes signs dearer.
    pub fn input(value: &Rational) -> Real {
        Real::node(Interval::of_rational(value), Shape::Input(value.clone()))
    }

    /// The square root, or none if the number is negative.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included. The root of a rational square is folded into a rational.
    pub fn sqrt(&self) -> Option<Real> {
        match self.sign() {
            core::cmp::Ordering::Less => None,
            core::cmp::Ordering::Equal => Some(Real::zero()),
            core::cmp::Ordering::Greater => Some(self.positive_sqrt()),
        }
    }

    /// The square root of the greater of the number and 0, for callers that have overridden a decision.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included.
    pub fn sqrt_or_zero(&self) -> Real {
        self.sqrt().unwrap_or_else(Real::zero)
    }

    /// The square root of a number proved positive.
    fn positive_sqrt(&self) -> Real {
        match &self.0.shape {
            Shape::Rational(value) => {
                if let Some(root) = rational_sqrt(value) {
                    return Real::rational(root);
                }
            }
            Shape::Square(a) => return a.abs(),
            _ => {}
        }
        Real::node(self.0.filter.get().sqrt(), Shape::Root(self.clone()))
    }

    /// The number times itself.
    ///
    /// # Exactness
    ///
    /// Exact. The square of a root is folded into the radicand.
    pub fn square(&self) -> Real {
        match &self.0.shape {
            Shape::Rational(value) => Real::rational(value.clone().square()),
            Shape::Root(a) => a.clone(),
            Shape::Negation(a) => a.square(),
            _ => Real::node(self.0.filter.get().square(), Shape::Square(self.clone())),
        }
    }

    /// The absolute value.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included.
    pub fn abs(&self) -> Real {
        if self.sign().is_lt() { -self } else { self.clone() }
    }

    /// The quotient, or none if the divisor is zero.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included.
    pub fn checked_div(&self, by: &Real) -> Option<Real> {
        if by.is_zero() {
            return None;
        }
        Some(match (&self.0.shape, &by.0.shape) {
            (Shape::Rational(a), Shape::Rational(b)) => Real::rational(Rational::from(a / b)),
            _ if self.same_node(by) => Real::one(),
            _ if self.known_zero() => Real::zero(),
            _ if by.as_rational().is_some_and(|b| *b == 1) => self.clone(),
            _ => {
                let filter = self.0.filter.get().divide(by.0.filter.get());
                Real::node(filter, Shape::Quotient(self.clone(), by.clone(), by.nonzero_floor()))
            }
        })
    }

    /// The f64 interval, low end first, that is certain to hold the number. No work beyond what is known already.
    ///
    /// # Exactness
    ///
    /// The number lies in the closed interval; nothing is promised of its width, and an end may be infinite. It may be
    /// narrower at a later call, after other questions have been answered.
    pub fn filter(&self) -> (f64, f64) {
        let Interval { low, high } = self.0.filter.get();
        (low, high)
    }

    /// A rational interval, low end first, that contains the number.
    ///
    /// # Exactness
    ///
    /// At most 2^-`bits` wide; a point if the number is a folded rational.
    pub fn enclosure(&self, bits: u32) -> (Rational, Rational) {
        if let Some(value) = self.as_rational() {
            return (value.clone(), value.clone());
        }
        let mantissa = self.approximate(i64::from(bits) + 1);
        let unit = Integer::from(1) << bits << 1_u32;
        (Rational::from((Integer::from(&mantissa - 1), unit.clone())), Rational::from((mantissa + 1, unit)))
    }

    /// The number as a rational, if it was folded into one.
    ///
    /// # Exactness
    ///
    /// Exact. None does not mean that the number is irrational: `(√2 - 1)·(√2 + 1)` is not folded.
    pub fn as_rational(&self) -> Option<&Rational> {
        match &self.0.shape {
            Shape::Rational(value) => Some(value),
            _ => None,
        }
    }

    fn node(filter: Interval, shape: Shape) -> Real {
        Real(Rc::new(Node::new(filter, shape)))
    }

    fn address(&self) -> *const Node {
        Rc::as_ptr(&self.0)
    }

    fn same_node(&self, other: &Real) -> bool {
        Rc::ptr_eq(&self.0, &other.0)
    }

    /// Whether the number is zero, as far as is known without work.
    fn known_zero(&self) -> bool {
        self.0.filter.get().is_zero()
    }
}

/// The root of a positive rational that is the square of a rational.
fn rational_sqrt(value: &Rational) -> Option<Rational> {
    // In lowest terms both parts must be squares.
    if !value.numer().is_perfect_square() || !value.denom().is_perfect_square() {
        return None;
    }
    Some(Rational::from((value.numer().clone().sqrt(), value.denom().clone().sqrt())))
}
