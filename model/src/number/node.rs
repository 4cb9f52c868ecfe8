//! The nodes of an expression: how a number was made, and what is known of its value so far.

use core::cell::{Cell, RefCell};
use std::rc::Rc;

use rug::{Integer, Rational};

use super::Real;
use super::filter::Interval;

/// One number of an expression. What it is never changes; what is known of its value grows.
pub(super) struct Node {
    /// The f64 interval that holds the value.
    pub(super) filter: Cell<Interval>,
    /// An exponent e with |value| ≤ 2^e; the filter may know a better one.
    pub(super) ceiling: i64,
    /// The longest chain of operations below.
    depth: u32,
    /// The best approximation computed so far.
    pub(super) approximation: RefCell<Option<Approximation>>,
    /// How the number was made.
    pub(super) shape: Shape,
}

/// A number m·2^-`bits` at most 2^-`bits` away from the value.
#[derive(Clone)]
pub(super) struct Approximation {
    pub(super) mantissa: Integer,
    pub(super) bits: i64,
}

/// How a number was made from others.
pub(super) enum Shape {
    /// A rational number: every operation on rationals alone is folded into one of these.
    Rational(Rational),
    /// A rational number of the program: no operation on it is folded.
    Input(Rational),
    Negation(Real),
    Sum(Real, Real),
    Difference(Real, Real),
    Product(Real, Real),
    Square(Real),
    /// Numerator, denominator, and an exponent e with |denominator| ≥ 2^e.
    Quotient(Real, Real, i64),
    /// The square root of a number proved not to be negative.
    Root(Real),
}

impl Shape {
    /// The numbers this one was made from.
    pub(super) fn operands(&self) -> [Option<&Real>; 2] {
        match self {
            Shape::Rational(_) | Shape::Input(_) => [None, None],
            Shape::Negation(a) | Shape::Square(a) | Shape::Root(a) => [Some(a), None],
            Shape::Sum(a, b) | Shape::Difference(a, b) | Shape::Product(a, b) | Shape::Quotient(a, b, _) => {
                [Some(a), Some(b)]
            }
        }
    }

    fn into_operands(self) -> [Option<Real>; 2] {
        match self {
            Shape::Rational(_) | Shape::Input(_) => [None, None],
            Shape::Negation(a) | Shape::Square(a) | Shape::Root(a) => [Some(a), None],
            Shape::Sum(a, b) | Shape::Difference(a, b) | Shape::Product(a, b) | Shape::Quotient(a, b, _) => {
                [Some(a), Some(b)]
            }
        }
    }

    /// An exponent e with |value| ≤ 2^e, from the operands' own. Saturation is harmless: a number of 2⁶³ bits is out
    /// of reach of any approximation, which then stops the program for want of memory before it could say a word.
    fn ceiling(&self) -> i64 {
        match self {
            Shape::Rational(value) | Shape::Input(value) => {
                // |n| < 2^bits(n) and d ≥ 2^(bits(d) - 1).
                let numerator = i64::from(value.numer().significant_bits());
                numerator - i64::from(value.denom().significant_bits()) + 1
            }
            Shape::Negation(a) => a.ceiling(),
            Shape::Sum(a, b) | Shape::Difference(a, b) => a.ceiling().max(b.ceiling()).saturating_add(1),
            Shape::Product(a, b) => a.ceiling().saturating_add(b.ceiling()),
            Shape::Square(a) => a.ceiling().saturating_mul(2),
            Shape::Quotient(a, _, floor) => a.ceiling().saturating_sub(*floor),
            Shape::Root(a) => a.ceiling().div_euclid(2).saturating_add(1),
        }
    }
}

/// Chains of operations longer than this are taken apart step by step when dropped, so that the stack does not overflow.
const SHALLOW: u32 = 500;

impl Node {
    pub(super) fn new(filter: Interval, shape: Shape) -> Node {
        let [left, right] = shape.operands();
        let depth = |operand: Option<&Real>| operand.map_or(0, |real| real.0.depth + 1);
        Node {
            filter: Cell::new(filter),
            ceiling: filter.ceiling().unwrap_or_else(|| shape.ceiling()),
            depth: depth(left).max(depth(right)),
            approximation: RefCell::new(None),
            shape,
        }
    }

    /// The longest chain of operations below.
    pub(super) fn depth(&self) -> u32 {
        self.depth
    }

    /// Takes the operands out of a node about to be dropped.
    fn dismantle(&mut self) -> impl Iterator<Item = Real> + use<> {
        let shape = core::mem::replace(&mut self.shape, Shape::Rational(Rational::new()));
        shape.into_operands().into_iter().flatten()
    }
}

impl Drop for Node {
    fn drop(&mut self) {
        if self.depth <= SHALLOW {
            return;
        }
        self.depth = 0;
        let mut pending: Vec<Real> = self.dismantle().collect();
        while let Some(mut real) = pending.pop() {
            // A node that others still use stays whole.
            if let Some(node) = Rc::get_mut(&mut real.0)
                && node.depth > SHALLOW
            {
                node.depth = 0;
                pending.extend(node.dismantle());
            }
        }
    }
}
