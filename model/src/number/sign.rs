//! Exact signs: the filter, then refinement, then the separation bound.

use core::cmp::Ordering;

use super::Real;
use super::filter::Interval;
use super::patience;

/// Bits, below the size the filter admits, of the first refinement. A double-precision filter that fails on a number that
/// is not zero has most often cancelled a few bits more than it has.
const FIRST_REFINEMENT: i64 = 64;

impl Real {
    /// The sign: the number compared with zero.
    ///
    /// # Exactness
    ///
    /// Exact.
    pub fn sign(&self) -> Ordering {
        match self.0.filter.get().sign() {
            Some(sign) => sign,
            None => self.refined_sign(),
        }
    }

    /// Whether the number is zero.
    ///
    /// # Exactness
    ///
    /// Exact.
    pub fn is_zero(&self) -> bool {
        self.sign().is_eq()
    }

    /// The sign of a number that the filter cannot tell from zero.
    #[cold]
    fn refined_sign(&self) -> Ordering {
        if let Some(sign) = self.approximate_sign() {
            return sign;
        }
        let start = FIRST_REFINEMENT.saturating_sub(self.ceiling());
        self.approximate(start);
        if let Some(sign) = self.approximate_sign() {
            return sign;
        }
        // |x| ≥ 2^-B unless x = 0. Approximated to B + 2 bits, |m| ≤ 1 means |x| ≤ 2^-(B+1), hence x = 0.
        let enough = self.separation_bits().saturating_add(2);
        let mut step = FIRST_REFINEMENT;
        let mut bits = start;
        while bits < enough {
            // What the first refinement has not decided is most often zero: few steps, and the last goes to the end.
            step = step.saturating_mul(4);
            bits = bits.saturating_add(step);
            if bits.saturating_add(step.saturating_mul(4)) >= enough {
                bits = enough;
            }
            // What is given up here is not learnt: the number is not zero for others.
            if !patience::allows(bits) {
                return Ordering::Equal;
            }
            self.approximate(bits);
            if let Some(sign) = self.approximate_sign() {
                return sign;
            }
        }
        self.0.filter.set(Interval::ZERO);
        Ordering::Equal
    }

    /// The sign that the approximation at hand proves: that of m, if |m| ≥ 2.
    fn approximate_sign(&self) -> Option<Ordering> {
        let approximation = self.0.approximation.borrow();
        let mantissa = &approximation.as_ref()?.mantissa;
        (mantissa.significant_bits() >= 2).then(|| mantissa.cmp0())
    }

    /// An exponent e with |x| ≥ 2^e, of a number proved not to be zero.
    pub(super) fn nonzero_floor(&self) -> i64 {
        let from_filter = self.0.filter.get().floor();
        let from_approximation = || {
            let approximation = self.0.approximation.borrow();
            let known = approximation.as_ref()?;
            // |m| ≥ 2^(n-1) and |m| ≥ 2 give |x| ≥ (|m| - 1)·2^-bits ≥ 2^(n-2-bits).
            let length = i64::from(known.mantissa.significant_bits());
            (length >= 2).then(|| (length - 2).saturating_sub(known.bits))
        };
        // One of the two has proved that the number is not zero.
        from_filter.or_else(from_approximation).unwrap_or_else(|| {
            // Not reached; should it be, the separation bound is right as well.
            self.separation_bits().saturating_neg()
        })
    }
}
