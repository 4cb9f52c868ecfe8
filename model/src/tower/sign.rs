//! Signs and comparisons, by repeated squaring.

use core::cmp::Ordering;

use super::{Number, Shape};

impl Number {
    /// The sign.
    ///
    /// # Exactness
    ///
    /// Exact, whether the roots are independent or not.
    pub fn sign(&self) -> Ordering {
        match &self.0 {
            Shape::Rational(value) => value.cmp0(),
            // A positive factor changes no sign, and whole numbers are quicker than fractions.
            Shape::Pair(_) => self.cleared().0.sign_of_cleared(),
        }
    }

    /// Whether the number is zero.
    ///
    /// # Exactness
    ///
    /// Exact, whether the roots are independent or not.
    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    /// The absolute value.
    ///
    /// # Exactness
    ///
    /// Exact, the decision included.
    pub fn abs(&self) -> Number {
        if self.sign().is_lt() { -self } else { self.clone() }
    }

    /// The sign of a number without denominators.
    fn sign_of_cleared(&self) -> Ordering {
        let pair = match &self.0 {
            Shape::Rational(value) => return value.cmp0(),
            Shape::Pair(pair) => pair,
        };
        // √c is positive: the sign of b√c is that of b.
        match (pair.plain.sign_of_cleared(), pair.factor.sign_of_cleared()) {
            (plain, Ordering::Equal) => plain,
            (Ordering::Equal, factor) => factor,
            (plain, factor) if plain == factor => plain,
            // Of opposite terms the one with the greater square wins; with equal squares they cancel.
            (plain, factor) => match pair.norm().primitive().sign_of_cleared() {
                Ordering::Greater => plain,
                Ordering::Less => factor,
                Ordering::Equal => Ordering::Equal,
            },
        }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Number) -> bool {
        (self - other).is_zero()
    }
}

impl Eq for Number {}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Number) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Number) -> Ordering {
        (self - other).sign()
    }
}
