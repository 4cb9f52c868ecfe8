//! Points and vectors with rational coordinates.

use rug::Rational;

/// A point or vector of the plane.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Point {
    pub(super) a: Rational,
    pub(super) b: Rational,
}

/// The quotient of two whole numbers; the divisor is not zero.
pub(super) fn ratio(over: i64, under: i64) -> Rational {
    Rational::from((over, under))
}

/// The square root, if it is rational.
pub(super) fn root(square: &Rational) -> Option<Rational> {
    let roots = square.is_positive() && square.numer().is_perfect_square() && square.denom().is_perfect_square();
    roots.then(|| Rational::from((square.numer().clone().sqrt(), square.denom().clone().sqrt())))
}

impl Point {
    pub(super) fn new(a: impl Into<Rational>, b: impl Into<Rational>) -> Self {
        Point { a: a.into(), b: b.into() }
    }

    pub(super) fn origin() -> Self {
        Point::new(0, 0)
    }

    pub(super) fn plus(&self, other: &Point) -> Point {
        Point::new(&self.a + &other.a, &self.b + &other.b)
    }

    pub(super) fn minus(&self, other: &Point) -> Point {
        Point::new(&self.a - &other.a, &self.b - &other.b)
    }

    pub(super) fn times(&self, factor: &Rational) -> Point {
        Point::new(&self.a * factor, &self.b * factor)
    }

    pub(super) fn opposite(&self) -> Point {
        Point { a: -self.a.clone(), b: -self.b.clone() }
    }

    /// A quarter turn counter-clockwise.
    pub(super) fn perp(&self) -> Point {
        Point { a: -self.b.clone(), b: self.a.clone() }
    }

    pub(super) fn dot(&self, other: &Point) -> Rational {
        Rational::from(&self.a * &other.a) + Rational::from(&self.b * &other.b)
    }

    pub(super) fn cross(&self, other: &Point) -> Rational {
        Rational::from(&self.a * &other.b) - Rational::from(&self.b * &other.a)
    }

    pub(super) fn length_squared(&self) -> Rational {
        self.dot(self)
    }

    /// Turned by the angle of a unit vector, counter-clockwise.
    pub(super) fn turned(&self, by: &Point) -> Point {
        Point { a: self.dot(&by.mirrored()), b: self.mirrored().cross(by) }
    }

    /// Mirrored in the first axis; of a unit vector, the angle to the other side.
    pub(super) fn mirrored(&self) -> Point {
        Point { a: self.a.clone(), b: -self.b.clone() }
    }
}

impl<A: Into<Rational>, B: Into<Rational>> From<(A, B)> for Point {
    fn from((a, b): (A, B)) -> Self {
        Point::new(a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_counter_clockwise() {
        let (u, v) = (Point::new(3, 4), Point::new(ratio(5, 13), ratio(12, 13)));
        assert_eq!(u.turned(&Point::new(0, 1)), u.perp());
        assert_eq!(u.turned(&v), Point::new(ratio(15 - 48, 13), ratio(36 + 20, 13)));
        assert_eq!(u.turned(&v).turned(&v.mirrored()), u);
    }
}
