//! Exact vectors of the plane.

use core::cmp::Ordering;

use radcomp_spec::Side;
use rug::Rational;

use crate::number::Real;

/// A point or vector in the plane `(a, b)`, exact, in millimetres.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vector {
    /// First coordinate.
    pub a: Real,
    /// Second coordinate.
    pub b: Real,
}

impl Vector {
    /// A vector from its coordinates.
    pub fn new(a: Real, b: Real) -> Self {
        Vector { a, b }
    }

    /// The exact vector of a pair of rationals.
    pub fn rational(point: &[Rational; 2]) -> Self {
        Vector::new(Real::from(&point[0]), Real::from(&point[1]))
    }

    /// A pair of numbers of the program.
    pub(crate) fn read(point: &[Rational; 2], number: fn(&Rational) -> Real) -> Self {
        Vector::new(number(&point[0]), number(&point[1]))
    }

    /// The zero vector.
    pub fn zero() -> Self {
        Vector::new(Real::zero(), Real::zero())
    }

    /// Sum.
    pub fn plus(&self, other: &Vector) -> Vector {
        Vector::new(&self.a + &other.a, &self.b + &other.b)
    }

    /// Difference.
    pub fn minus(&self, other: &Vector) -> Vector {
        Vector::new(&self.a - &other.a, &self.b - &other.b)
    }

    /// Multiple.
    pub fn times(&self, factor: &Real) -> Vector {
        Vector::new(&self.a * factor, &self.b * factor)
    }

    /// `self + direction·factor`.
    pub fn along(&self, direction: &Vector, factor: &Real) -> Vector {
        self.plus(&direction.times(factor))
    }

    /// The vector turned by a half turn.
    pub fn opposite(&self) -> Vector {
        Vector::new(-&self.a, -&self.b)
    }

    /// The vector turned by a quarter turn counter-clockwise, `(-b, a)`.
    pub fn perp(&self) -> Vector {
        Vector::new(-&self.b, self.a.clone())
    }

    /// The vector turned by a quarter turn toward a side: to the left, or to the right.
    pub fn toward(&self, side: Side) -> Vector {
        match side {
            Side::Left => self.perp(),
            Side::Right => Vector::new(self.b.clone(), -&self.a),
        }
    }

    /// Scalar product.
    pub fn dot(&self, other: &Vector) -> Real {
        &self.a * &other.a + &self.b * &other.b
    }

    /// Cross product, positive when `other` points to the left of `self`.
    pub fn cross(&self, other: &Vector) -> Real {
        &self.a * &other.b - &self.b * &other.a
    }

    /// Square of the length.
    pub fn length_squared(&self) -> Real {
        self.dot(self)
    }

    /// Length.
    pub fn length(&self) -> Real {
        // A sum of squares is never negative, so nothing is cut off.
        self.length_squared().sqrt_or_zero()
    }

    /// Whether both coordinates are exactly zero.
    pub fn is_zero(&self) -> bool {
        self.a.is_zero() && self.b.is_zero()
    }
}

/// `value` with the sign `+1` for the left side and `-1` for the right.
pub fn signed(side: Side, value: &Real) -> Real {
    match side {
        Side::Left => value.clone(),
        Side::Right => -value,
    }
}

/// The smaller of two numbers.
pub fn smaller(x: Real, y: Real) -> Real {
    if y.cmp(&x) == Ordering::Less { y } else { x }
}

/// The larger of two numbers.
pub fn larger(x: &Real, y: &Real) -> Real {
    if y.cmp(x) == Ordering::Greater { y.clone() } else { x.clone() }
}
