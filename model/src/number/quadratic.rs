//! Sums of square roots of whole numbers with rational coefficients: the normal form behind closed forms.

use std::collections::BTreeMap;

use rug::{Integer, Rational};

/// Σ c·√k over square-free positive k, none of the coefficients c zero. Square roots of different square-free numbers are
/// linearly independent over the rationals, so equal numbers have equal forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Form {
    terms: BTreeMap<Integer, Rational>,
}

/// A form of more terms than this has no short closed form that could be shown.
const MOST_TERMS: usize = 8;

/// Square factors are sought up to here.
const TRIAL_BOUND: u32 = 10_000;

impl Form {
    pub(super) fn rational(value: &Rational) -> Form {
        Form::term(Integer::from(1), value.clone())
    }

    fn term(radicand: Integer, coefficient: Rational) -> Form {
        let mut form = Form { terms: BTreeMap::new() };
        form.add_term(radicand, coefficient);
        form
    }

    fn add_term(&mut self, radicand: Integer, coefficient: Rational) {
        if coefficient.is_zero() {
            return;
        }
        let sum = self.terms.entry(radicand.clone()).or_default();
        *sum += coefficient;
        if sum.is_zero() {
            self.terms.remove(&radicand);
        }
    }

    /// The terms, by ascending radicand; the rational part has radicand 1.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&Integer, &Rational)> {
        self.terms.iter()
    }

    pub(super) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The form's value, if that is rational.
    pub(super) fn as_rational(&self) -> Option<Rational> {
        match self.terms.first_key_value() {
            None => Some(Rational::new()),
            Some((radicand, value)) => (self.terms.len() == 1 && *radicand == 1).then(|| value.clone()),
        }
    }

    pub(super) fn scale(&self, factor: &Rational) -> Form {
        let mut scaled = Form { terms: BTreeMap::new() };
        for (radicand, coefficient) in &self.terms {
            scaled.add_term(radicand.clone(), Rational::from(coefficient * factor));
        }
        scaled
    }

    /// The sum, none if it is too long.
    pub(super) fn add(&self, other: &Form) -> Option<Form> {
        let mut sum = self.clone();
        for (radicand, coefficient) in &other.terms {
            sum.add_term(radicand.clone(), coefficient.clone());
        }
        (sum.terms.len() <= MOST_TERMS).then_some(sum)
    }

    /// The product, none if it is too long.
    pub(super) fn multiply(&self, other: &Form) -> Option<Form> {
        let mut product = Form { terms: BTreeMap::new() };
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let (common, radicand) = product_of_roots(a, b);
                product.add_term(radicand, Rational::from(x * y) * common);
            }
        }
        (product.terms.len() <= MOST_TERMS).then_some(product)
    }

    /// One divided by the form, if it is not zero and lies in a field of at most two independent radicals.
    pub(super) fn invert(&self) -> Option<Form> {
        let radicals: Vec<&Integer> = self.terms.keys().filter(|radicand| **radicand != 1).collect();
        // The other images of the form under the automorphisms of its field, each by the radicals whose sign it changes.
        let images: &[&[&Integer]] = match radicals[..] {
            [] => &[],
            [a] => &[&[a]],
            [a, b] => &[&[a], &[b], &[a, b]],
            [a, b, c] if product_of_roots(a, b).1 == *c => &[&[a, c], &[b, c], &[a, b]],
            _ => return None,
        };
        // The product of all images is the norm, which is rational.
        let mut cofactor = Form::rational(&Rational::from(1));
        for negated in images {
            cofactor = cofactor.multiply(&self.conjugate(negated))?;
        }
        let norm = self.multiply(&cofactor)?.as_rational()?;
        if norm.is_zero() {
            return None;
        }
        Some(cofactor.scale(&norm.recip()))
    }

    /// The form with the signs of these radicals changed.
    fn conjugate(&self, negated: &[&Integer]) -> Form {
        let mut conjugate = self.clone();
        for (radicand, coefficient) in &mut conjugate.terms {
            if negated.contains(&radicand) {
                *coefficient *= -1;
            }
        }
        conjugate
    }

    /// The square root of a rational number that is not negative, none if no square-free radicand can be found.
    pub(super) fn sqrt_of_rational(value: &Rational) -> Option<Form> {
        if value.is_zero() {
            return Some(Form::rational(value));
        }
        // √(n/d) = √(n·d)/d.
        let (outside, radicand) = extract_square(Integer::from(value.numer() * value.denom()))?;
        Some(Form::term(radicand, Rational::from((outside, value.denom().clone()))))
    }

    /// The square root of a form a + b·√c that is not negative, if it is a form itself.
    ///
    /// With q = √(a² - b²·c) rational, √(a + b·√c) = √((a+q)/2) ± √((a-q)/2), the sign being that of b: the square of the
    /// right side is a ± √(a² - q²) = a ± |b|·√c, and as a ≥ q ≥ 0 it is not negative.
    pub(super) fn sqrt(&self) -> Option<Form> {
        if let Some(value) = self.as_rational() {
            return (!value.is_negative()).then(|| Form::sqrt_of_rational(&value))?;
        }
        let a = self.terms.get(&Integer::from(1))?;
        let mut others = self.terms.iter().filter(|(radicand, _)| **radicand != 1);
        let (c, b) = others.next()?;
        if others.next().is_some() || !a.is_positive() {
            return None;
        }
        let norm = Rational::from(a.square_ref()) - Rational::from(b.square_ref()) * c;
        if norm.is_negative() || !norm.numer().is_perfect_square() || !norm.denom().is_perfect_square() {
            return None;
        }
        let q = Rational::from((norm.numer().clone().sqrt(), norm.denom().clone().sqrt()));
        let greater = Form::sqrt_of_rational(&(Rational::from(a + &q) / 2))?;
        let lesser = Form::sqrt_of_rational(&(Rational::from(a - &q) / 2))?;
        greater.add(&if b.is_negative() { lesser.scale(&Rational::from(-1)) } else { lesser })
    }

    /// s and F with √(self) = s·√F, F having whole coefficients without a common square factor.
    pub(super) fn primitive_radicand(&self) -> Option<(Rational, Form)> {
        let mut divisor = Integer::new();
        let mut multiple = Integer::from(1);
        for coefficient in self.terms.values() {
            divisor.gcd_mut(coefficient.numer());
            multiple.lcm_mut(coefficient.denom());
        }
        // self = (divisor/multiple)·P, and √(n/d) = √(n·d)/d = outside·√(inside)/d.
        let (outside, inside) = extract_square(Integer::from(&divisor * &multiple))?;
        let content = Rational::from((divisor, multiple.clone()));
        let primitive = self.scale(&(Rational::from(inside) / content));
        Some((Rational::from((outside, multiple)), primitive))
    }
}

/// √a·√b as a whole number times the root of a square-free one, for square-free a and b.
fn product_of_roots(a: &Integer, b: &Integer) -> (Integer, Integer) {
    let common = Integer::from(a.gcd_ref(b));
    let radicand = Integer::from(a / &common) * Integer::from(b / &common);
    (common, radicand)
}

/// s and k with n = s²·k and k square-free, for positive n; none if that cannot be told by division up to the bound.
fn extract_square(mut n: Integer) -> Option<(Integer, Integer)> {
    if n.is_perfect_square() {
        return Some((n.sqrt(), Integer::from(1)));
    }
    let (mut outside, mut inside) = (Integer::from(1), Integer::from(1));
    for divisor in (2..3).chain((3..=TRIAL_BOUND).step_by(2)) {
        if n < divisor * divisor {
            break;
        }
        while n.is_divisible_u(divisor) {
            n.div_exact_u_mut(divisor);
            if n.is_divisible_u(divisor) {
                n.div_exact_u_mut(divisor);
                outside *= divisor;
            } else {
                inside *= divisor;
            }
        }
    }
    if n.is_perfect_square() {
        outside *= n.sqrt();
        return Some((outside, inside));
    }
    // Every prime factor left exceeds the bound, or n is prime. Below the cube of the bound there are at most two of
    // them, and they differ, as n is no square.
    let square_free = n < Integer::from(TRIAL_BOUND) * TRIAL_BOUND * TRIAL_BOUND;
    square_free.then(|| (outside, inside * n))
}
