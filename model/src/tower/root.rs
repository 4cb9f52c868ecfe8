//! Square roots: found among the numbers that exist, or made new.

use core::cmp::Ordering;
use core::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::rc::Rc;

use rug::{Integer, Rational};

use super::{Number, Pair, Refusal, Root, Shape};

/// The square roots that numbers may be made of, each independent of those before it.
///
/// # Exactness
///
/// Numbers of different towers mix and stay exact, but a tower knows its own roots only: to it the root of a number
/// made of others is always a new one, which may depend on its own.
pub struct Tower {
    roots: Vec<Rc<Root>>,
    most: usize,
}

impl Tower {
    /// The rationals, and room for at most this many independent roots.
    ///
    /// # Exactness
    ///
    /// The limit makes nothing inexact: beyond it there is no number.
    pub fn new(most: usize) -> Tower {
        Tower { roots: Vec::new(), most }
    }

    /// How many independent roots there are by now.
    ///
    /// # Exactness
    ///
    /// The field that the roots make is of degree 2 to this power over the rationals, unless numbers of other towers were
    /// mixed in.
    pub fn height(&self) -> usize {
        self.roots.len()
    }

    /// The square root that is not negative.
    ///
    /// If the number is the square of a number made of the tower's roots, that number is found. Otherwise the tower grows.
    ///
    /// # Errors
    ///
    /// [`Refusal::NegativeRadicand`], or [`Refusal::TooManyRoots`] if the root is independent of those there are and
    /// these are already as many as may be.
    ///
    /// # Exactness
    ///
    /// Exact, both decisions included.
    pub fn sqrt(&mut self, number: &Number) -> Result<Number, Refusal> {
        match number.sign() {
            Ordering::Less => return Err(Refusal::NegativeRadicand),
            Ordering::Equal => return Ok(Number::zero()),
            Ordering::Greater => {}
        }
        // The number is c/d with c free of denominators, and √(c/d) = √(cd)/d.
        let (cleared, denominator) = number.cleared();
        let radicand = cleared.scaled(&Rational::from(&denominator));
        let root = match root_within(&radicand, &self.roots) {
            Some(root) => root.abs(),
            None if self.roots.len() >= self.most => return Err(Refusal::TooManyRoots),
            None => self.adjoin(radicand),
        };
        Ok(root.scaled(&Rational::from((Integer::from(1), denominator))))
    }

    /// A new root, of a positive number without denominators; nothing is asked about its independence.
    pub(super) fn adjoin(&mut self, radicand: Number) -> Number {
        // Only the order within one number matters, and a radicand is there before its root.
        static AGE: AtomicU64 = AtomicU64::new(0);
        let root = Rc::new(Root { age: AGE.fetch_add(1, Relaxed), radicand });
        let number = Number::pair(Number::zero(), Number::integer(1), &root);
        self.roots.push(root);
        number
    }
}

/// A number of either sign in the field of these roots, oldest first, whose square this is; none if there is none.
///
/// Let c = a + b√d with d the youngest radicand. If c = (x + y√d)² in a field where √d is independent, then
/// a = x² + y²d and b = 2xy. So for b = 0 either a = x² or ad = (yd)²; and otherwise a² - b²d = (x² - y²d)² =: s²,
/// x² = (a ± s)/2, y = b/2x. All of it asks for squares among the older roots' numbers, down to the rationals.
///
/// That a number found is a root holds with dependent roots too: (x + y√d)² = c follows from the equations alone.
fn root_within(number: &Number, roots: &[Rc<Root>]) -> Option<Number> {
    let Some((youngest, older)) = roots.split_last() else {
        return rational_root(number);
    };
    match &number.0 {
        Shape::Pair(pair) if pair.root.age == youngest.age => root_of_pair(pair, youngest, older),
        _ => root_within(number, older).or_else(|| {
            let product = root_within(&(number * &youngest.radicand), older)?;
            let factor = product.checked_div(&youngest.radicand)?;
            Some(Number::pair(Number::zero(), factor, youngest))
        }),
    }
}

fn root_of_pair(pair: &Pair, youngest: &Rc<Root>, older: &[Rc<Root>]) -> Option<Number> {
    let split = root_within(&pair.norm(), older)?;
    let half = Rational::from((1, 2));
    [&pair.plain + &split, &pair.plain - &split].iter().find_map(|double| {
        let plain = root_within(&double.scaled(&half), older)?;
        let factor = pair.factor.scaled(&half).checked_div(&plain)?;
        Some(Number::pair(plain, factor, youngest))
    })
}

fn rational_root(number: &Number) -> Option<Number> {
    let Shape::Rational(value) = &number.0 else { return None };
    // In lowest terms both must be squares; a negative number is none.
    let (above, below) = (value.numer(), value.denom());
    (above.is_perfect_square() && below.is_perfect_square())
        .then(|| Number::rational(Rational::from((above.clone().sqrt(), below.clone().sqrt()))))
}
