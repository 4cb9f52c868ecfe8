//! Closed forms for people: `10 + 5·√2` where a number has one that is short.
//!
//! Only exact transformations are made, so a closed form that is shown is the number.

use core::fmt;
use std::collections::HashMap;

use rug::Rational;

use super::Real;
use super::node::{Node, Shape};
use super::quadratic::Form;

/// Closed forms longer than this many characters are not worth reading.
const LONGEST: usize = 40;

/// Expressions deeper than this are not tried; it also bounds the recursion.
const DEEPEST: u32 = 64;

/// Rationals of more bits than this are given up on: no form that contains one is short.
const MOST_BITS: u32 = 512;

/// flat + c·√(radicand), where the nested root may be missing.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Closed {
    flat: Form,
    nested: Option<(Rational, Form)>,
}

impl Real {
    /// The number in closed form, such as `10 + 5·√2`, `-1/2·√3` or `√(2 + √2)`, if there is one of at most 40 characters
    /// that can be found by normalising sums of square roots, rationalising, and denesting.
    ///
    /// # Exactness
    ///
    /// What is shown equals the number, and [`Real::parse`] reads it back.
    pub fn closed_form(&self) -> Option<String> {
        if self.0.depth() > DEEPEST {
            return None;
        }
        let text = closed(self, &mut HashMap::new())?.to_string();
        (text.chars().count() <= LONGEST).then_some(text)
    }
}

/// The closed form of a node; nodes already visited are looked up, so shared parts are done once.
fn closed(real: &Real, done: &mut HashMap<*const Node, Option<Closed>>) -> Option<Closed> {
    if let Some(known) = done.get(&real.address()) {
        return known.clone();
    }
    let result = match &real.0.shape {
        _ if real.known_zero() => Some(Closed::flat(Form::rational(&Rational::new()))),
        Shape::Rational(value) | Shape::Input(value) => Some(Closed::flat(Form::rational(value))),
        Shape::Negation(a) => closed(a, done).map(|a| a.scale(&Rational::from(-1))),
        Shape::Sum(a, b) => closed(a, done).zip(closed(b, done)).and_then(|(a, b)| a.add(&b)),
        Shape::Difference(a, b) => {
            closed(a, done).zip(closed(b, done)).and_then(|(a, b)| a.add(&b.scale(&Rational::from(-1))))
        }
        Shape::Product(a, b) => closed(a, done).zip(closed(b, done)).and_then(|(a, b)| a.multiply(&b)),
        Shape::Square(a) => closed(a, done).and_then(|a| a.square()),
        Shape::Quotient(a, b, _) => closed(a, done).zip(closed(b, done)).and_then(|(a, b)| a.divide(&b)),
        Shape::Root(a) => closed(a, done).and_then(|a| a.sqrt()),
    };
    let result = result.filter(Closed::is_small);
    done.insert(real.address(), result.clone());
    result
}

impl Closed {
    fn flat(flat: Form) -> Closed {
        Closed { flat, nested: None }
    }

    fn is_small(&self) -> bool {
        let nested = self.nested.iter().flat_map(|(factor, radicand)| {
            radicand.terms().map(|(_, coefficient)| coefficient).chain(core::iter::once(factor))
        });
        let mut numbers = self.flat.terms().map(|(_, coefficient)| coefficient).chain(nested);
        numbers.all(|number| {
            number.numer().significant_bits() <= MOST_BITS && number.denom().significant_bits() <= MOST_BITS
        })
    }

    fn scale(&self, factor: &Rational) -> Closed {
        if factor.is_zero() {
            return Closed::flat(Form::rational(factor));
        }
        let nested = self.nested.as_ref().map(|(c, radicand)| (Rational::from(c * factor), radicand.clone()));
        Closed { flat: self.flat.scale(factor), nested }
    }

    fn add(&self, other: &Closed) -> Option<Closed> {
        let nested = match (&self.nested, &other.nested) {
            (None, nested) | (nested, None) => nested.clone(),
            (Some((c, radicand)), Some((d, same))) if radicand == same => {
                let sum = Rational::from(c + d);
                (!sum.is_zero()).then(|| (sum, radicand.clone()))
            }
            _ => return None,
        };
        Some(Closed { flat: self.flat.add(&other.flat)?, nested })
    }

    fn multiply(&self, other: &Closed) -> Option<Closed> {
        match (&self.nested, &other.nested) {
            (None, None) => Some(Closed::flat(self.flat.multiply(&other.flat)?)),
            (None, Some(_)) => Some(other.scale(&self.flat.as_rational()?)),
            (Some(_), None) => Some(self.scale(&other.flat.as_rational()?)),
            (Some((c, radicand)), Some((d, same)))
                if self.flat.is_zero() && other.flat.is_zero() && radicand == same =>
            {
                Some(Closed::flat(radicand.scale(&Rational::from(c * d))))
            }
            _ => None,
        }
    }

    fn square(&self) -> Option<Closed> {
        self.multiply(self)
    }

    fn divide(&self, by: &Closed) -> Option<Closed> {
        if by.nested.is_some() {
            return None;
        }
        self.multiply(&Closed::flat(by.flat.invert()?))
    }

    /// The root of a form that is not negative.
    fn sqrt(&self) -> Option<Closed> {
        if self.nested.is_some() {
            return None;
        }
        if let Some(flat) = self.flat.sqrt() {
            return Some(Closed::flat(flat));
        }
        if self.flat.as_rational().is_some() {
            return None;
        }
        let nested = self.flat.primitive_radicand()?;
        Some(Closed { flat: Form::rational(&Rational::new()), nested: Some(nested) })
    }
}

impl fmt::Display for Closed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.flat.is_zero() && self.nested.is_none() {
            return f.write_str("0");
        }
        let mut first = true;
        write_flat(f, &self.flat, &mut first)?;
        if let Some((coefficient, radicand)) = &self.nested {
            write_coefficient(f, coefficient, &mut first)?;
            f.write_str("√(")?;
            write_flat(f, radicand, &mut true)?;
            f.write_str(")")?;
        }
        Ok(())
    }
}

fn write_flat(f: &mut fmt::Formatter<'_>, form: &Form, first: &mut bool) -> fmt::Result {
    for (radicand, coefficient) in form.terms() {
        if *radicand == 1 {
            write_sign(f, coefficient, first)?;
            write!(f, "{}", coefficient.clone().abs())?;
        } else {
            write_coefficient(f, coefficient, first)?;
            write!(f, "√{radicand}")?;
        }
    }
    Ok(())
}

/// The factor in front of a root, with its dot; a factor 1 is not written.
fn write_coefficient(f: &mut fmt::Formatter<'_>, coefficient: &Rational, first: &mut bool) -> fmt::Result {
    write_sign(f, coefficient, first)?;
    let magnitude = coefficient.clone().abs();
    if magnitude == 1 { Ok(()) } else { write!(f, "{magnitude}·") }
}

/// The sign of a term: in front of the first, between spaces after that.
fn write_sign(f: &mut fmt::Formatter<'_>, coefficient: &Rational, first: &mut bool) -> fmt::Result {
    let sign = match (core::mem::replace(first, false), coefficient.is_negative()) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    };
    f.write_str(sign)
}

impl fmt::Display for Real {
    /// The closed form if there is a short one, else 17 significant digits; without a closed form, numbers beyond the
    /// range of f64 are shown as that shows them.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(text) = self.closed_form() {
            return f.write_str(&text);
        }
        let value = self.to_f64();
        let magnitude = value.abs().log10().floor();
        if (-6.0..16.0).contains(&magnitude) {
            // Only the number of digits comes from the double; the digits are exact.
            f.write_str(&self.to_decimal((16.0 - magnitude) as usize))
        } else {
            write!(f, "{value:.16e}")
        }
    }
}

impl fmt::Debug for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Real({self})")
    }
}
