//! How a number was made, for those who compute its value in another way.

use rug::Rational;

use super::Real;
use super::node::{Node, Shape};

/// The last step in the making of a number.
///
/// The steps below are the operands' own expressions; an operand that is used twice has one [`Identity`].
///
/// # Exactness
///
/// The value of the step on the exact values of its operands is the number.
#[derive(Clone, Copy, Debug)]
pub enum Expression<'a> {
    /// A rational number.
    Rational(&'a Rational),
    /// The number with the other sign.
    Negation(&'a Real),
    /// The first plus the second.
    Sum(&'a Real, &'a Real),
    /// The first less the second.
    Difference(&'a Real, &'a Real),
    /// The first times the second.
    Product(&'a Real, &'a Real),
    /// The number times itself.
    Square(&'a Real),
    /// The first over the second, which is not zero.
    Quotient(&'a Real, &'a Real),
    /// The square root of a number that is not negative.
    Root(&'a Real),
}

/// Tells the nodes of an expression apart; good as long as the number it was asked of, or one made from it, is kept.
///
/// # Exactness
///
/// Numbers of one identity are equal; equal numbers may have different ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Identity(*const Node);

impl Real {
    /// How the number was made: its last step, with the numbers it was made from.
    ///
    /// # Exactness
    ///
    /// Exact: the number is the value of the expression. It need not be the one that was written: operations on
    /// rationals are folded, and a step that is not needed (`√` of a square, a number over itself) may be left out.
    pub fn expression(&self) -> Expression<'_> {
        match &self.0.shape {
            Shape::Rational(value) | Shape::Input(value) => Expression::Rational(value),
            Shape::Negation(a) => Expression::Negation(a),
            Shape::Sum(a, b) => Expression::Sum(a, b),
            Shape::Difference(a, b) => Expression::Difference(a, b),
            Shape::Product(a, b) => Expression::Product(a, b),
            Shape::Square(a) => Expression::Square(a),
            Shape::Quotient(a, b, _) => Expression::Quotient(a, b),
            Shape::Root(a) => Expression::Root(a),
        }
    }

    /// The node of the expression that this number is.
    ///
    /// # Exactness
    ///
    /// Numbers of one identity are equal; equal numbers may have different ones.
    pub fn identity(&self) -> Identity {
        Identity(self.address())
    }
}

impl<'a> Expression<'a> {
    /// The numbers this one was made from.
    pub fn operands(self) -> impl Iterator<Item = &'a Real> {
        let (first, second) = match self {
            Expression::Rational(_) => (None, None),
            Expression::Negation(a) | Expression::Square(a) | Expression::Root(a) => (Some(a), None),
            Expression::Sum(a, b)
            | Expression::Difference(a, b)
            | Expression::Product(a, b)
            | Expression::Quotient(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }
}
