//! Quotients, by conjugates.

use rug::Rational;

use super::{Number, Pair, Shape};

impl Number {
    /// The quotient, or none if the divisor is zero.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included.
    pub fn checked_div(&self, by: &Number) -> Option<Number> {
        by.reciprocal().map(|reciprocal| self * &reciprocal)
    }

    /// 1 over the number, or none if it is zero.
    fn reciprocal(&self) -> Option<Number> {
        match &self.0 {
            Shape::Rational(value) => (!value.is_zero()).then(|| Number::rational(Rational::from(value.recip_ref()))),
            Shape::Pair(pair) => match pair.norm().reciprocal() {
                Some(norm) => Some(&pair.conjugate() * &norm),
                None => pair.of_norm_zero()?.reciprocal(),
            },
        }
    }
}

impl Pair {
    /// The value of a + b√c if its norm a² - b²c is zero, which takes a dependent root: either it is itself zero, or
    /// its conjugate a - b√c is, and it is 2a.
    fn of_norm_zero(&self) -> Option<Number> {
        // |a| = |b|√c: with unlike signs they cancel. Both may be zero, which the reciprocal of 2a will see.
        (self.plain.sign() == self.factor.sign()).then(|| &self.plain + &self.plain)
    }
}
