//! Approximation to any precision, in the style of Boehm's constructive reals: each node asks its operands for just the
//! bits that its own error allows, and keeps the best answer.
//!
//! H.-J. Boehm, R. Cartwright, M. Riggle and M. J. O'Donnell, "Exact real arithmetic: a case study in higher order
//! programming", LFP 1986. Here an approximation to p bits is an integer m with |x - m·2^-p| ≤ 2^-p. Half of that error
//! is left to the rounding of the result, half is shared out among the operands.

use rug::{Integer, Rational};

use super::Real;
use super::filter::Interval;
use super::node::{Approximation, Shape};

/// What a node needs of its operands for `bits` of its own.
enum Demand<'a> {
    /// Nothing: it is so near zero that m = 0 will do.
    Nothing,
    /// These operands to these precisions.
    Operands([Option<(&'a Real, i64)>; 2]),
}

impl Real {
    /// An exponent e with |x| ≤ 2^e.
    pub(super) fn ceiling(&self) -> i64 {
        self.0.filter.get().ceiling().map_or(self.0.ceiling, |e| e.min(self.0.ceiling))
    }

    /// An integer m with |x - m·2^-`bits`| ≤ 2^-`bits`.
    ///
    /// The walk over the expression keeps its own stack, so that the depth of the expression does not matter.
    pub(super) fn approximate(&self, bits: i64) -> Integer {
        let mut pending = vec![(self, bits)];
        while let Some(&(real, bits)) = pending.last() {
            if real.knows(bits) {
                pending.pop();
                continue;
            }
            let bits = real.generous(bits);
            let demand = real.demand(bits);
            let waiting = pending.len();
            if let Demand::Operands(operands) = &demand {
                pending.extend(operands.iter().flatten().filter(|(operand, needed)| !operand.knows(*needed)));
            }
            if pending.len() == waiting {
                let mantissa = real.combine(bits, &demand);
                real.learn(mantissa, bits);
                pending.pop();
            }
        }
        self.recall(bits)
    }

    /// Whether an approximation to `bits` is at hand.
    fn knows(&self, bits: i64) -> bool {
        self.0.filter.get().is_zero() || self.0.approximation.borrow().as_ref().is_some_and(|known| known.bits >= bits)
    }

    /// The precision to compute when `bits` are asked for: if fewer are at hand, then a quarter more of them at least. A
    /// number that many nodes share, each asking for a little more than the last, is so not computed anew for each.
    fn generous(&self, bits: i64) -> i64 {
        match &*self.0.approximation.borrow() {
            Some(known) => bits.max(known.bits.saturating_add(i64::from(known.mantissa.significant_bits()) / 4)),
            None => bits,
        }
    }

    /// The approximation at hand, shortened to `bits`. Where none is at hand the number is zero: callers make sure.
    fn recall(&self, bits: i64) -> Integer {
        match &*self.0.approximation.borrow() {
            // If bits are dropped the known error is at most half of the new unit, as is that of the rounding.
            Some(known) if !self.0.filter.get().is_zero() => {
                shift_rounded(&known.mantissa, bits.saturating_sub(known.bits))
            }
            _ => Integer::new(),
        }
    }

    /// Keeps an approximation and lets the filter profit from it.
    fn learn(&self, mantissa: Integer, bits: i64) {
        let filter = self.0.filter.get();
        self.0.filter.set(filter.meet(Interval::of_scaled(&mantissa, bits)));
        *self.0.approximation.borrow_mut() = Some(Approximation { mantissa, bits });
    }

    /// The precisions that make the error before rounding at most half of 2^-`bits`.
    fn demand(&self, bits: i64) -> Demand<'_> {
        let both = |a, p, b, q| Demand::Operands([Some((a, p)), Some((b, q))]);
        let one = |a, p| Demand::Operands([Some((a, p)), None]);
        match &self.0.shape {
            Shape::Rational(_) | Shape::Input(_) => Demand::Operands([None, None]),
            Shape::Negation(a) => one(a, bits),
            // Two errors of a quarter each.
            Shape::Sum(a, b) | Shape::Difference(a, b) => {
                let needed = bits.saturating_add(2);
                both(a, needed, b, needed)
            }
            Shape::Product(a, b) => match product_bits(a, b, bits) {
                Some((p, q)) => both(a, p, b, q),
                None => Demand::Nothing,
            },
            Shape::Square(a) => match product_bits(a, a, bits) {
                Some((p, _)) => one(a, p),
                None => Demand::Nothing,
            },
            // With |b| ≥ 2^f and an error of b of at most 2^(f-1), the approximate B has |B| ≥ 2^(f-1), and
            //   |A/B - a/b| ≤ |A - a|/|B| + |a/b|·|B - b|/|B|
            //              ≤ 2^-(bits-f+3)·2^(1-f) + 2^(e-f)·2^-(bits+e-2f+4)·2^(1-f) = 2^-(bits+2) + 2^-(bits+3).
            Shape::Quotient(a, b, _) => {
                let floor = self.divisor_floor();
                let numerator = bits.saturating_sub(floor).saturating_add(3);
                let denominator =
                    bits.saturating_add(a.ceiling()).saturating_sub(floor.saturating_mul(2)).saturating_add(4);
                both(a, numerator, b, denominator.max(1_i64.saturating_sub(floor)))
            }
            Shape::Root(a) => one(a, root_bits(a, bits)),
        }
    }

    /// The approximation to `bits` from operands that know what [`Real::demand`] asked for.
    fn combine(&self, bits: i64, demand: &Demand) -> Integer {
        let Demand::Operands(operands) = demand else {
            return Integer::new();
        };
        match (&self.0.shape, operands) {
            (Shape::Rational(value) | Shape::Input(value), _) => rational_mantissa(value, bits),
            (Shape::Negation(_), [Some((a, p)), _]) => -a.recall(*p),
            (Shape::Sum(..), [Some((a, p)), Some((b, q))]) => shift_rounded(&(a.recall(*p) + b.recall(*q)), -2),
            (Shape::Difference(..), [Some((a, p)), Some((b, q))]) => shift_rounded(&(a.recall(*p) - b.recall(*q)), -2),
            (Shape::Product(..), [Some((a, p)), Some((b, q))]) => {
                shift_rounded(&(a.recall(*p) * b.recall(*q)), bits.saturating_sub(*p).saturating_sub(*q))
            }
            (Shape::Square(_), [Some((a, p)), _]) => {
                shift_rounded(&a.recall(*p).square(), bits.saturating_sub(*p).saturating_sub(*p))
            }
            (Shape::Quotient(..), [Some((a, p)), Some((b, q))]) => {
                // A/B·2^bits = mA·2^(bits - p + q)/mB.
                quotient_rounded(&a.recall(*p), b.recall(*q), bits.saturating_sub(*p).saturating_add(*q))
            }
            (Shape::Root(_), [Some((a, p)), _]) => {
                // √A to bits + 1 as an integer rounded down, then halved to the nearest: if s = ⌊√(A·2^(2·bits+2))⌋ then
                // ⌊(s+1)/2⌋ is at most ½ from √A·2^bits, for odd and for even s.
                let exponent = bits.saturating_mul(2).saturating_add(2).saturating_sub(*p);
                let scaled = shift_rounded(&a.recall(*p), exponent);
                let root = if scaled.is_negative() { Integer::new() } else { scaled.sqrt() };
                (root + 1u32) >> 1u32
            }
            _ => unreachable!("the demand of a shape names as many operands as the shape has"),
        }
    }

    /// The best known e with |divisor| ≥ 2^e of a quotient.
    fn divisor_floor(&self) -> i64 {
        match &self.0.shape {
            Shape::Quotient(_, b, floor) => b.0.filter.get().floor().map_or(*floor, |known| known.max(*floor)),
            _ => 0,
        }
    }
}

/// The precisions of two factors for `bits` of their product, none if the product is certainly below 2^-(bits+3).
///
/// With |a| ≤ 2^e, |b| ≤ 2^f and errors of 2^-(bits+f+3) and 2^-(bits+e+3), the product's error is at most
/// 2·2^-(bits+3) + 2^-(2·bits+e+f+6) ≤ 3·2^-(bits+3) as long as bits + e + f + 3 ≥ 0; else |ab| ≤ 2^(e+f) < 2^-(bits+3).
fn product_bits(a: &Real, b: &Real, bits: i64) -> Option<(i64, i64)> {
    let (e, f) = (a.ceiling(), b.ceiling());
    let (p, q) = (bits.saturating_add(f).saturating_add(3), bits.saturating_add(e).saturating_add(3));
    (p.saturating_add(e) >= 0).then_some((p, q))
}

/// The precision of the radicand a for an error of √a of at most half of 2^-`bits`.
///
/// |√A - √a| ≤ √|A - a| always, so 2·bits + 2 will do, also near zero; and |√A - √a| ≤ |A - a|/√a, so where a ≥ 2^f
/// is known, bits + 1 - ⌊f/2⌋ will do.
fn root_bits(a: &Real, bits: i64) -> i64 {
    let always = bits.saturating_mul(2).saturating_add(2);
    match a.0.filter.get().floor() {
        Some(floor) => always.min(bits.saturating_add(1).saturating_sub(floor.div_euclid(2))),
        None => always,
    }
}

/// `value`·2^`exponent` rounded to the nearest integer; exact for an exponent that is not negative.
fn shift_rounded(value: &Integer, exponent: i64) -> Integer {
    if exponent >= 0 {
        return Integer::from(value << shift(exponent));
    }
    let down = exponent.saturating_neg();
    if down > i64::from(value.significant_bits()) + 1 {
        return Integer::new();
    }
    // Half the unit is added first, then the shift rounds down.
    let halved = Integer::from(value >> shift(down - 1));
    (halved + 1u32) >> 1u32
}

/// `numerator`·2^`exponent`/`denominator` rounded to the nearest integer.
fn quotient_rounded(numerator: &Integer, denominator: Integer, exponent: i64) -> Integer {
    let (numerator, denominator) = if exponent >= 0 {
        (Integer::from(numerator << shift(exponent)), denominator)
    } else {
        (numerator.clone(), denominator << shift(exponent.saturating_neg()))
    };
    numerator.div_rem_round(denominator).0
}

fn rational_mantissa(value: &Rational, bits: i64) -> Integer {
    quotient_rounded(value.numer(), value.denom().clone(), bits)
}

/// A shift as GMP takes it.
///
/// # Panics
///
/// If a number of more than 2³² bits, half a gigabyte, is asked for.
fn shift(bits: i64) -> u32 {
    match u32::try_from(bits) {
        Ok(bits) => bits,
        Err(_) => panic!("an approximation to {bits} bits does not fit into memory"),
    }
}
