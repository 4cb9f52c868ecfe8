//! The one place where a rounded number becomes a decision.

use core::cmp::Ordering;

/// The rounding bound of every geometric decision, relative to the scale of the terms that were subtracted: 2⁻⁴⁶.
///
/// With u = 2⁻⁵³: a coordinate of size m is a decimal rounded to f64, off by u·m; the difference of two is off by
/// 2·u·m, and its own rounding adds 2·u·m, so a difference vector is off by 4·√2·u·m < 6·u·m. A direction of length l
/// is off by 6·u·m/l, and by 3·u for the root and the quotient. The cross or dot product of two directions is off by
/// the sum of theirs and 3·u for its own roundings: less than 9·u·((1 + m/l1) + (1 + m/l2)). Distances and offsets
/// add at most four roundings more of the size of their terms. 2⁻⁴⁶ = 128·u leaves a factor of ten for chains of a
/// few such steps, and with the scales used here is a displacement below 2⁻⁴² times the largest coordinate: a
/// rounding bound, not a tolerance.
pub const BAND: f64 = 1.0 / (1_u64 << 46) as f64;

/// The sign of `value`, a difference of terms that `scale` bounds; `Equal` when rounding alone could have made it.
///
/// # Exactness
/// `Equal` exactly when |value| ≤ [`BAND`]·scale, and when either number is not a number.
#[inline(always)]
#[must_use]
pub fn sign(value: f64, scale: f64) -> Ordering {
    let band = BAND * scale;
    if value > band {
        Ordering::Greater
    } else if value < -band {
        Ordering::Less
    } else {
        Ordering::Equal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn band_separates() {
        assert_eq!(sign(BAND, 1.0), Ordering::Equal);
        assert_eq!(sign(-BAND, 1.0), Ordering::Equal);
        assert_eq!(sign(2.0 * BAND, 1.0), Ordering::Greater);
        assert_eq!(sign(-2.0 * BAND, 1.0), Ordering::Less);
        assert_eq!(sign(0.0, 0.0), Ordering::Equal);
        assert_eq!(sign(f64::NAN, 1.0), Ordering::Equal);
    }
}
