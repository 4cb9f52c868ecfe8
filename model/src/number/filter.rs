//! The double-precision filter: an interval with f64 ends that certainly holds the number.
//!
//! Every operation rounds to nearest and then moves each end one step outward, which covers the half unit in the last
//! place (or half the least subnormal) that the rounding can cost. An overflow widens to infinity: the step inward from
//! an infinite end back to `f64::MAX` is what `next_down` does, and it is right, since the exact value did exceed it.

use core::cmp::Ordering;

use rug::{Integer, Rational};

/// A closed interval that certainly contains a number; an infinite end means that nothing is known on that side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    /// The lower end, never NaN and never `+∞`.
    pub(super) low: f64,
    /// The upper end, never NaN and never `-∞`.
    pub(super) high: f64,
}

/// Integers up to here, 2⁵³, are f64 values exactly.
const EXACT_INTEGER: u64 = 1 << 53;

/// Above this many bits an integer may overflow an f64; quotients then take the slow way.
const SAFE_BITS: u32 = 1000;

impl Interval {
    /// The number zero.
    pub(super) const ZERO: Interval = Interval { low: 0.0, high: 0.0 };

    /// Nothing is known.
    pub(super) const EVERYTHING: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The interval of a rational number; a single point when that is an integer of at most 53 bits.
    pub(super) fn of_rational(value: &Rational) -> Interval {
        let (numerator, denominator) = (value.numer(), value.denom());
        if let (Some(n), Some(d)) = (numerator.to_i64(), denominator.to_u64())
            && n.unsigned_abs() <= EXACT_INTEGER
            && d <= EXACT_INTEGER
        {
            let quotient = n as f64 / d as f64;
            return if d == 1 || n == 0 {
                Interval { low: quotient, high: quotient }
            } else {
                widened(quotient, quotient)
            };
        }
        if numerator.significant_bits() > SAFE_BITS || denominator.significant_bits() > SAFE_BITS {
            // GMP truncates this conversion toward zero, so one step away from zero covers it.
            let quotient = value.to_f64();
            return widened(quotient, quotient);
        }
        Interval::of_integer(numerator).divide(Interval::of_integer(denominator))
    }

    /// The interval of an integer of at most [`SAFE_BITS`] bits.
    fn of_integer(value: &Integer) -> Interval {
        // GMP truncates toward zero.
        let truncated = value.to_f64();
        if value.significant_bits() <= 53 {
            Interval { low: truncated, high: truncated }
        } else {
            widened(truncated, truncated)
        }
    }

    /// The interval of all numbers within 2^-`bits` of `mantissa`·2^-`bits`.
    pub(super) fn of_scaled(mantissa: &Integer, bits: i64) -> Interval {
        let (low, high, exponent) = if mantissa.significant_bits() <= 53 {
            let exact = mantissa.to_f64();
            (exact - 1.0, exact + 1.0, bits.saturating_neg())
        } else {
            // GMP truncates to a fraction of 53 bits; neither that nor ±1 is more than one unit of its last place, and
            // two steps are at least one unit toward zero and two away from it.
            let (fraction, length) = mantissa.to_f64_exp();
            let (low, high) = (fraction.next_down().next_down(), fraction.next_up().next_up());
            (low, high, i64::from(length).saturating_sub(bits))
        };
        Interval { low: -scaled_up(-low, exponent), high: scaled_up(high, exponent) }
    }

    /// The common part of two intervals that both hold the number.
    pub(super) fn meet(self, other: Interval) -> Interval {
        Interval { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The sign, if the interval lies on one side of zero or is zero.
    pub(super) fn sign(self) -> Option<Ordering> {
        if self.low > 0.0 {
            Some(Ordering::Greater)
        } else if self.high < 0.0 {
            Some(Ordering::Less)
        } else if self.is_zero() {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// Whether the number is certainly zero.
    pub(super) fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// An exponent e with |x| ≤ 2^e, if the interval is bounded.
    pub(super) fn ceiling(self) -> Option<i64> {
        let greatest = self.high.max(-self.low);
        greatest.is_finite().then(|| exponent(greatest) + 1)
    }

    /// An exponent e with |x| ≥ 2^e, if the interval excludes zero.
    pub(super) fn floor(self) -> Option<i64> {
        match self.sign()? {
            Ordering::Greater => Some(exponent(self.low)),
            Ordering::Less => Some(exponent(-self.high)),
            Ordering::Equal => None,
        }
    }

    pub(super) fn negate(self) -> Interval {
        Interval { low: -self.high, high: -self.low }
    }

    pub(super) fn add(self, other: Interval) -> Interval {
        widened(self.low + other.low, self.high + other.high)
    }

    pub(super) fn subtract(self, other: Interval) -> Interval {
        self.add(other.negate())
    }

    pub(super) fn multiply(self, other: Interval) -> Interval {
        if self.low >= 0.0 && other.low >= 0.0 {
            return widened(times(self.low, other.low), times(self.high, other.high)).at_least_zero();
        }
        let corners = [
            times(self.low, other.low),
            times(self.low, other.high),
            times(self.high, other.low),
            times(self.high, other.high),
        ];
        let low = corners.iter().copied().fold(f64::INFINITY, f64::min);
        let high = corners.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        widened(low, high)
    }

    pub(super) fn square(self) -> Interval {
        let least = self.low.max(-self.high).max(0.0);
        let greatest = self.high.max(-self.low);
        widened(least * least, greatest * greatest).at_least_zero()
    }

    /// The quotient by a number that is known not to be zero.
    pub(super) fn divide(self, by: Interval) -> Interval {
        if by.high <= 0.0 {
            return self.negate().divide(by.negate());
        }
        if by.low < 0.0 {
            return Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };
        }
        // The divisor is positive: each end of the quotient takes the divisor's end that carries it farther out. No
        // NaN can arise: a numerator 0 meets only `by.high`, which is positive, and `by.low` is never infinite. The
        // sign of a zero `by.low` decides between the infinities, so it must be plus.
        let least = by.low.abs();
        let low = if self.low >= 0.0 { self.low / by.high } else { self.low / least };
        let high = if self.high <= 0.0 { self.high / by.high } else { self.high / least };
        let quotient = widened(low, high);
        if self.low >= 0.0 {
            quotient.at_least_zero()
        } else if self.high <= 0.0 {
            quotient.negate().at_least_zero().negate()
        } else {
            quotient
        }
    }

    /// The square root of a number that is known not to be negative.
    pub(super) fn sqrt(self) -> Interval {
        widened(self.low.max(0.0).sqrt(), self.high.sqrt()).at_least_zero()
    }

    /// The part that is not negative, of a number known not to be negative.
    pub(super) fn at_least_zero(self) -> Interval {
        Interval { low: self.low.max(0.0), high: self.high }
    }
}

fn widened(low: f64, high: f64) -> Interval {
    Interval { low: low.next_down(), high: high.next_up() }
}

/// A product of two ends. An infinite end only says that the (finite) number is unbounded, so zero times it is zero.
fn times(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { a * b }
}

/// The exponent e with 2^e ≤ `value` < 2^(e+1); for zero, that of the least subnormal, which serves as a ceiling.
fn exponent(value: f64) -> i64 {
    let bits = value.to_bits() & !(1 << 63);
    match (bits >> 52) as i64 {
        // A subnormal is `bits`·2⁻¹⁰⁷⁴.
        0 => i64::from(bits.max(1).ilog2()) - 1074,
        biased => biased - 1023,
    }
}

/// An upper bound of `value`·2^`exponent`, for values that are zero or of a size between ¼ and 2⁵⁴; the product itself
/// where it is far from the ends of the range of f64.
fn scaled_up(value: f64, exponent: i64) -> f64 {
    const LEAST: i64 = -900;
    const GREATEST: i64 = 960;
    if value > 0.0 && exponent > GREATEST {
        f64::INFINITY
    } else if value < 0.0 && exponent < LEAST {
        0.0
    } else {
        // Exact. Held back, the exponent can but raise the product: positive ones are held at the lower end alone,
        // negative ones at the upper.
        value * power_of_two(exponent.clamp(LEAST, GREATEST))
    }
}

/// 2^`exponent` for an exponent of a normal number.
fn power_of_two(exponent: i64) -> f64 {
    debug_assert!((-1022..=1023).contains(&exponent));
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
