//! Sums, differences and products.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};
use std::rc::Rc;

use rug::Rational;

use super::{Number, Pair, Root, Shape};

/// Two numbers over the younger of their youngest roots.
enum Over<'a> {
    Rationals(&'a Rational, &'a Rational),
    /// The second number does not have the first one's youngest root.
    First(&'a Pair),
    /// The first number does not have the second one's youngest root.
    Second(&'a Pair),
    Both(&'a Pair, &'a Pair),
}

fn over<'a>(left: &'a Number, right: &'a Number) -> Over<'a> {
    match (&left.0, &right.0) {
        (Shape::Rational(a), Shape::Rational(b)) => Over::Rationals(a, b),
        (Shape::Pair(pair), Shape::Rational(_)) => Over::First(pair),
        (Shape::Rational(_), Shape::Pair(pair)) => Over::Second(pair),
        (Shape::Pair(a), Shape::Pair(b)) => match a.root.age.cmp(&b.root.age) {
            Ordering::Greater => Over::First(a),
            Ordering::Less => Over::Second(b),
            Ordering::Equal => Over::Both(a, b),
        },
    }
}

impl Add for &Number {
    type Output = Number;

    fn add(self, other: &Number) -> Number {
        match over(self, other) {
            Over::Rationals(a, b) => Number::rational(Rational::from(a + b)),
            Over::First(a) => Number::pair(&a.plain + other, a.factor.clone(), &a.root),
            Over::Second(b) => Number::pair(self + &b.plain, b.factor.clone(), &b.root),
            Over::Both(a, b) => Number::pair(&a.plain + &b.plain, &a.factor + &b.factor, &a.root),
        }
    }
}

impl Sub for &Number {
    type Output = Number;

    fn sub(self, other: &Number) -> Number {
        match over(self, other) {
            Over::Rationals(a, b) => Number::rational(Rational::from(a - b)),
            Over::First(a) => Number::pair(&a.plain - other, a.factor.clone(), &a.root),
            Over::Second(b) => Number::pair(self - &b.plain, -&b.factor, &b.root),
            Over::Both(a, b) => Number::pair(&a.plain - &b.plain, &a.factor - &b.factor, &a.root),
        }
    }
}

impl Neg for &Number {
    type Output = Number;

    fn neg(self) -> Number {
        match &self.0 {
            Shape::Rational(value) => Number::rational(Rational::from(-value)),
            Shape::Pair(pair) => Number::pair(-&pair.plain, -&pair.factor, &pair.root),
        }
    }
}

impl Mul for &Number {
    type Output = Number;

    fn mul(self, other: &Number) -> Number {
        if self.is_written_zero() || other.is_written_zero() {
            return Number::zero();
        }
        match over(self, other) {
            Over::Rationals(a, b) => Number::rational(Rational::from(a * b)),
            Over::First(a) => Number::pair(&a.plain * other, &a.factor * other, &a.root),
            Over::Second(b) => Number::pair(self * &b.plain, self * &b.factor, &b.root),
            Over::Both(a, b) => product(a, b, &a.root),
        }
    }
}

/// Three products below instead of four: the mixed ones together are (a + b)(a' + b') - aa' - bb'.
fn product(left: &Pair, right: &Pair, root: &Rc<Root>) -> Number {
    let plain = &left.plain * &right.plain;
    let factor = &left.factor * &right.factor;
    let whole = &(&left.plain + &left.factor) * &(&right.plain + &right.factor);
    let mixed = &(&whole - &plain) - &factor;
    Number::pair(&plain + &(&factor * &root.radicand), mixed, root)
}

impl Number {
    /// The number times itself.
    ///
    /// # Exactness
    ///
    /// Exact.
    pub fn square(&self) -> Number {
        match &self.0 {
            Shape::Rational(value) => Number::rational(value.clone().square()),
            Shape::Pair(pair) => {
                let (plain, factor) = (pair.plain.square(), pair.factor.square());
                let whole = (&pair.plain + &pair.factor).square();
                let mixed = &(&whole - &plain) - &factor;
                Number::pair(&plain + &(&factor * &pair.root.radicand), mixed, &pair.root)
            }
        }
    }

    /// Every rational coefficient times a rational other than 0.
    pub(super) fn scaled(&self, by: &Rational) -> Number {
        match &self.0 {
            Shape::Rational(value) => Number::rational(Rational::from(value * by)),
            Shape::Pair(pair) => Number::pair(pair.plain.scaled(by), pair.factor.scaled(by), &pair.root),
        }
    }
}

impl Pair {
    /// The number times its conjugate: a² - b²c, made of older roots only.
    pub(super) fn norm(&self) -> Number {
        &self.plain.square() - &(&self.factor.square() * &self.root.radicand)
    }

    /// The conjugate a - b√c.
    pub(super) fn conjugate(&self) -> Number {
        Number::pair(self.plain.clone(), -&self.factor, &self.root)
    }
}
