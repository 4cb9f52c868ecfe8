//! Intervals with f64 ends: every operation rounds outward, so the exact result lies inside.

use std::ops::{Add, Mul, Neg, Sub};

/// A closed interval that certainly holds a number. Neither end is NaN as long as no operation overflows; the numbers of
/// this module are bounded by [`super::LARGEST`], so none does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    /// The lower end.
    pub(crate) low: f64,
    /// The upper end.
    pub(crate) high: f64,
}

/// A point or vector of the plane, each coordinate known to lie in an interval.
pub(crate) type Spot = [Interval; 2];

impl Interval {
    /// The double itself.
    pub(crate) const fn of(value: f64) -> Self {
        Interval { low: value, high: value }
    }

    /// The interval between two doubles.
    pub(crate) const fn between(low: f64, high: f64) -> Self {
        Interval { low, high }
    }

    /// One step outward at each end: covers the half unit in the last place of an operation rounded to nearest.
    fn outward(low: f64, high: f64) -> Self {
        Interval { low: low.next_down(), high: high.next_up() }
    }

    /// A double in the middle.
    pub(crate) fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }

    /// The smallest interval that holds both.
    pub(crate) fn hull(self, other: Interval) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The interval of the smaller of the two numbers.
    pub(crate) fn min(self, other: Interval) -> Self {
        Interval { low: self.low.min(other.low), high: self.high.min(other.high) }
    }

    /// The interval of the absolute value.
    pub(crate) fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Interval { low: 0.0, high: self.high.max(-self.low) }
        }
    }

    /// The interval of the square.
    pub(crate) fn square(self) -> Self {
        let Interval { low, high } = self.abs();
        Interval { low: (low * low).next_down().max(0.0), high: (high * high).next_up() }
    }

    /// The interval of the root of the number, or of 0 where that is greater.
    pub(crate) fn root(self) -> Self {
        let (low, high) = (self.low.max(0.0).sqrt(), self.high.max(0.0).sqrt());
        Interval { low: low.next_down().max(0.0), high: high.next_up() }
    }

    /// The interval of the quotient by a number that is certainly positive; unbounded if it may be zero.
    pub(crate) fn over(self, by: Interval) -> Self {
        if by.low <= 0.0 {
            return Interval { low: f64::MIN, high: f64::MAX };
        }
        let low = if self.low >= 0.0 { self.low / by.high } else { self.low / by.low };
        let high = if self.high >= 0.0 { self.high / by.low } else { self.high / by.high };
        Interval::outward(low, high)
    }

    /// Certainly below zero.
    pub(crate) fn is_negative(self) -> bool {
        self.high < 0.0
    }

    /// Certainly above zero.
    pub(crate) fn is_positive(self) -> bool {
        self.low > 0.0
    }
}

impl Add for Interval {
    type Output = Interval;
    fn add(self, other: Interval) -> Interval {
        Interval::outward(self.low + other.low, self.high + other.high)
    }
}

impl Sub for Interval {
    type Output = Interval;
    fn sub(self, other: Interval) -> Interval {
        Interval::outward(self.low - other.high, self.high - other.low)
    }
}

impl Neg for Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Interval;
    fn mul(self, other: Interval) -> Interval {
        let (a, b) = (self.low * other.low, self.low * other.high);
        let (c, d) = (self.high * other.low, self.high * other.high);
        Interval::outward(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

/// The point with exactly these coordinates.
pub(crate) fn spot(point: [f64; 2]) -> Spot {
    point.map(Interval::of)
}

/// A double point inside.
pub(crate) fn middle(of: &Spot) -> [f64; 2] {
    [of[0].middle(), of[1].middle()]
}

/// Sum.
pub(crate) fn plus(p: &Spot, q: &Spot) -> Spot {
    [p[0] + q[0], p[1] + q[1]]
}

/// Difference.
pub(crate) fn minus(p: &Spot, q: &Spot) -> Spot {
    [p[0] - q[0], p[1] - q[1]]
}

/// Multiple.
pub(crate) fn times(p: &Spot, factor: Interval) -> Spot {
    [p[0] * factor, p[1] * factor]
}

/// Scalar product.
pub(crate) fn dot(p: &Spot, q: &Spot) -> Interval {
    p[0] * q[0] + p[1] * q[1]
}

/// Cross product, positive when `q` points to the left of `p`.
pub(crate) fn cross(p: &Spot, q: &Spot) -> Interval {
    p[0] * q[1] - p[1] * q[0]
}

/// Length.
pub(crate) fn length(p: &Spot) -> Interval {
    (p[0].square() + p[1].square()).root()
}

/// Distance.
pub(crate) fn distance(p: &Spot, q: &Spot) -> Interval {
    length(&minus(p, q))
}

/// The smallest box that holds both.
pub(crate) fn hull(p: &Spot, q: &Spot) -> Spot {
    [p[0].hull(q[0]), p[1].hull(q[1])]
}
