//! The operators of [`Real`]: `+`, `-`, `*`, and exact order. There is no `/`: see [`Real::checked_div`].

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use rug::Rational;

use super::Real;
use super::node::Shape;

fn sum(a: &Real, b: &Real) -> Real {
    match (&a.0.shape, &b.0.shape) {
        (Shape::Rational(x), Shape::Rational(y)) => Real::rational(Rational::from(x + y)),
        _ if a.known_zero() => b.clone(),
        _ if b.known_zero() => a.clone(),
        _ => Real::node(a.0.filter.get().add(b.0.filter.get()), Shape::Sum(a.clone(), b.clone())),
    }
}

fn difference(a: &Real, b: &Real) -> Real {
    match (&a.0.shape, &b.0.shape) {
        (Shape::Rational(x), Shape::Rational(y)) => Real::rational(Rational::from(x - y)),
        _ if a.known_zero() => negation(b),
        _ if b.known_zero() => a.clone(),
        _ if a.same_node(b) => Real::zero(),
        _ => Real::node(a.0.filter.get().subtract(b.0.filter.get()), Shape::Difference(a.clone(), b.clone())),
    }
}

fn product(a: &Real, b: &Real) -> Real {
    match (&a.0.shape, &b.0.shape) {
        (Shape::Rational(x), Shape::Rational(y)) => return Real::rational(Rational::from(x * y)),
        (Shape::Rational(x), _) if *x == 1 => return b.clone(),
        (_, Shape::Rational(y)) if *y == 1 => return a.clone(),
        _ => {}
    }
    if a.known_zero() || b.known_zero() {
        return Real::zero();
    }
    if a.same_node(b) {
        return a.square();
    }
    Real::node(a.0.filter.get().multiply(b.0.filter.get()), Shape::Product(a.clone(), b.clone()))
}

fn negation(a: &Real) -> Real {
    match &a.0.shape {
        Shape::Rational(x) => Real::rational(Rational::from(-x)),
        Shape::Negation(x) => x.clone(),
        Shape::Difference(x, y) => Real::node(a.0.filter.get().negate(), Shape::Difference(y.clone(), x.clone())),
        _ => Real::node(a.0.filter.get().negate(), Shape::Negation(a.clone())),
    }
}

macro_rules! operator {
    ($($trait:ident, $method:ident, $function:ident;)*) => {$(
        impl $trait<&Real> for &Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                $function(self, other)
            }
        }
        impl $trait<Real> for &Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                $function(self, &other)
            }
        }
        impl $trait<&Real> for Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                $function(&self, other)
            }
        }
        impl $trait<Real> for Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                $function(&self, &other)
            }
        }
    )*};
}

operator! {
    Add, add, sum;
    Sub, sub, difference;
    Mul, mul, product;
}

impl Neg for &Real {
    type Output = Real;
    fn neg(self) -> Real {
        negation(self)
    }
}

impl Neg for Real {
    type Output = Real;
    fn neg(self) -> Real {
        negation(&self)
    }
}

impl Ord for Real {
    fn cmp(&self, other: &Real) -> Ordering {
        if self.same_node(other) {
            return Ordering::Equal;
        }
        let (a, b) = (self.0.filter.get(), other.0.filter.get());
        if a.high < b.low {
            return Ordering::Less;
        }
        if a.low > b.high {
            return Ordering::Greater;
        }
        match (&self.0.shape, &other.0.shape) {
            (Shape::Rational(x), Shape::Rational(y)) => x.cmp(y),
            _ => difference(self, other).sign(),
        }
    }
}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Real) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Real) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Real {}

impl From<Rational> for Real {
    fn from(value: Rational) -> Real {
        Real::rational(value)
    }
}

impl From<&Rational> for Real {
    fn from(value: &Rational) -> Real {
        Real::rational(value.clone())
    }
}

impl From<i64> for Real {
    fn from(value: i64) -> Real {
        Real::integer(value)
    }
}
