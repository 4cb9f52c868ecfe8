//! Decimals and doubles: conversions of exact numbers, with the rounding of each stated and proved.

use core::cmp::Ordering;

use rug::ops::{NegAssign, Pow};
use rug::{Integer, Rational};

use super::Real;

/// Bits of relative precision at which [`Real::to_f64`] starts, and beyond which it takes a tie for a tie.
const F64_BITS: core::ops::Range<i64> = 64..2048;

impl Real {
    /// The number as a double.
    ///
    /// # Exactness
    ///
    /// Rounded to nearest, except that where the number agrees with the middle of two doubles to 2048 bits the error may
    /// reach one unit in the last place, which is the bound that holds always. The sign is exact: what is not zero does
    /// not become zero, but the least subnormal of its sign. Beyond the range of f64 the result is infinite.
    pub fn to_f64(&self) -> f64 {
        if let Some(value) = self.as_rational() {
            return signed(nearest_f64(value), value.cmp0());
        }
        let sign = self.sign();
        if sign.is_eq() {
            return 0.0;
        }
        // |x| ≥ 2^f, so f + bits bits before rounding are at least `bits` significant ones.
        let floor = self.nonzero_floor();
        let mut bits = F64_BITS.start;
        loop {
            let scale = bits.saturating_sub(floor);
            let mantissa = self.approximate(scale);
            let below = nearest_f64(&scaled(Integer::from(&mantissa - 1), scale));
            let above = nearest_f64(&scaled(Integer::from(&mantissa + 1), scale));
            if below == above || bits >= F64_BITS.end {
                return signed(nearest_f64(&scaled(mantissa, scale)), sign);
            }
            bits *= 2;
        }
    }

    /// The number in decimal, with that many digits after the point, and none of a point if that is 0.
    ///
    /// # Exactness
    ///
    /// Correctly rounded to nearest, ties away from zero; ties are decided exactly. What rounds to zero has no sign.
    pub fn to_decimal(&self, digits: usize) -> String {
        let power = power_of(10, digits);
        let rounded = match self.as_rational() {
            Some(value) => round_half_away(&Rational::from(value * &power)),
            None => self.rounded_multiple(&power),
        };
        place_point(&rounded, digits)
    }

    /// `self`·`factor` rounded to the nearest integer, ties away from zero.
    fn rounded_multiple(&self, factor: &Integer) -> Integer {
        let bits = factor.significant_bits().saturating_add(16);
        let (low, high) = self.enclosure(bits);
        let low = round_half_away(&(low * factor));
        let high = round_half_away(&(high * factor));
        if low == high {
            return low;
        }
        // The enclosure is far narrower than a digit, so the two are neighbours and the middle between them decides.
        let middle = Real::rational(Rational::from((Integer::from(&low + &high), Integer::from(factor * 2_u32))));
        match self.cmp(&middle) {
            Ordering::Less => low,
            Ordering::Greater => high,
            Ordering::Equal if high.is_positive() => high,
            Ordering::Equal => low,
        }
    }
}

/// Replaces a zero by the least subnormal where the number is not zero.
fn signed(value: f64, sign: Ordering) -> f64 {
    match sign {
        Ordering::Greater if value == 0.0 => f64::from_bits(1),
        Ordering::Less if value == 0.0 => -f64::from_bits(1),
        _ => value,
    }
}

/// `mantissa`·2^-`bits`.
fn scaled(mantissa: Integer, bits: i64) -> Rational {
    // A shift beyond 2³¹ bits has failed for want of memory in the approximation that came before.
    let shift = i32::try_from(bits).unwrap_or(i32::MAX);
    Rational::from(mantissa) >> shift
}

/// The double nearest to a rational number.
///
/// # Exactness
///
/// Rounded to nearest, ties to even, for every value: subnormals are rounded once, and values beyond the range by half a
/// unit or more become infinite, as in IEEE 754.
pub fn nearest_f64(value: &Rational) -> f64 {
    const EXACT: u64 = 1 << 53;
    let (numerator, denominator) = (value.numer(), value.denom());
    if let (Some(n), Some(d)) = (numerator.to_i64(), denominator.to_u64())
        && n.unsigned_abs() <= EXACT
        && d <= EXACT
    {
        // Both conversions are exact and the division rounds once.
        return n as f64 / d as f64;
    }
    let magnitude = nearest_magnitude(&numerator.clone().abs(), denominator);
    if numerator.is_negative() { -magnitude } else { magnitude }
}

/// The double nearest to a quotient of positive integers.
fn nearest_magnitude(numerator: &Integer, denominator: &Integer) -> f64 {
    // 2^(e-1) < numerator/denominator < 2^(e+1).
    let e = i64::from(numerator.significant_bits()) - i64::from(denominator.significant_bits());
    if e > 1025 {
        return f64::INFINITY;
    }
    if e < -1080 {
        return 0.0;
    }
    // The quotient times 2^shift lies between 2^61 and 2^63: so many bits, and a last one that remembers a remainder.
    let shift = 62 - e;
    let (mut n, mut d) = (numerator.clone(), denominator.clone());
    // |shift| < 2000 by the two tests above.
    if shift >= 0 {
        n <<= shift as u32
    } else {
        d <<= -shift as u32
    }
    let (quotient, remainder) = n.div_rem(d);
    let sticky = quotient.to_u64_wrapping() | u64::from(remainder != 0);
    // The unit in the last place is 2^(top-52), but never below 2^-1074; `drop` bits of `sticky` lie below it.
    let top = i64::from(sticky.ilog2()) - shift;
    let unit = (top - 52).max(-1074);
    let drop = unit + shift;
    if drop > 64 {
        return 0.0;
    }
    // At least 9 bits are dropped, as `sticky` has 62 or more. At 64 all of them are.
    let (kept, rest, half) = if drop == 64 {
        (0, u128::from(sticky), 1_u128 << 63)
    } else {
        (sticky >> drop, u128::from(sticky) & ((1_u128 << drop) - 1), 1_u128 << (drop - 1))
    };
    let up = rest > half || (rest == half && kept % 2 == 1);
    let significand = kept + u64::from(up);
    // Significand and exponent side by side: a carry runs from one into the other, at the top into infinity.
    let biased = if unit == -1074 { significand } else { significand + (((unit + 1074) as u64) << 52) };
    if unit > 971 { f64::INFINITY } else { f64::from_bits(biased) }
}

/// A decimal such as `-12.5`, `.5`, `5.` or `+3`: none if the text is anything else. There are no exponents.
///
/// # Exactness
///
/// Exact.
pub fn parse_decimal(text: &str) -> Option<Rational> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let all_digits = whole.bytes().chain(fraction.bytes()).all(|byte| byte.is_ascii_digit());
    if !all_digits || whole.len() + fraction.len() == 0 {
        return None;
    }
    let mut numerator = match (whole.to_owned() + fraction).parse::<u64>() {
        Ok(small) => Integer::from(small),
        Err(_) => Integer::from_str_radix(&(whole.to_owned() + fraction), 10).ok()?,
    };
    if negative {
        numerator.neg_assign();
    }
    Some(Rational::from((numerator, power_of(10, fraction.len()))))
}

/// The shortest decimal that is the number: none if there is no finite one.
///
/// # Exactness
///
/// Exact.
pub fn format_decimal(value: &Rational) -> Option<String> {
    let mut rest = value.denom().clone();
    let twos = rest.remove_factor_mut(&Integer::from(2)) as usize;
    let fives = rest.remove_factor_mut(&Integer::from(5)) as usize;
    if rest != 1 {
        return None;
    }
    let digits = twos.max(fives);
    let scaled = Rational::from(value * power_of(10, digits));
    // The power of ten has as many twos and fives as the denominator, so the product is an integer.
    Some(place_point(scaled.numer(), digits))
}

/// The nearest integer, ties away from zero.
fn round_half_away(value: &Rational) -> Integer {
    let twice = Integer::from(value.numer() * 2_u32);
    let unit = Integer::from(value.denom() * 2_u32);
    // ⌊|x| + ½⌋ = ⌊(2|n| + d)/2d⌋.
    let magnitude = (twice.abs() + value.denom()).div_rem_floor(unit).0;
    if value.is_negative() { -magnitude } else { magnitude }
}

/// `value`/10^`digits` in decimal.
fn place_point(value: &Integer, digits: usize) -> String {
    let magnitude = format!("{:0>width$}", value.clone().abs().to_string(), width = digits.saturating_add(1));
    let (whole, fraction) = magnitude.split_at(magnitude.len() - digits);
    let sign = if value.is_negative() { "-" } else { "" };
    let point = if digits == 0 { "" } else { "." };
    format!("{sign}{whole}{point}{fraction}")
}

fn power_of(base: u32, exponent: usize) -> Integer {
    // As many digits as 2³² do not fit into a string that anyone could have passed or can be given.
    Integer::from(base).pow(u32::try_from(exponent).unwrap_or(u32::MAX))
}
