//! Numbers without denominators: a sign does not need them, and a radicand can do without.

use rug::{Integer, Rational};

use super::{Number, Shape};

impl Number {
    /// The number times the least positive integer that leaves no coefficient a denominator, and that integer.
    pub(super) fn cleared(&self) -> (Number, Integer) {
        let mut common = Integer::from(1);
        self.each_coefficient(&mut |value| common.lcm_mut(value.denom()));
        let cleared = if common == 1 { self.clone() } else { self.scaled(&Rational::from(&common)) };
        (cleared, common)
    }

    /// The number over the greatest integer that divides every coefficient; for a number without denominators.
    pub(super) fn primitive(&self) -> Number {
        let mut common = Integer::new();
        self.each_coefficient(&mut |value| {
            if common != 1 {
                common.gcd_mut(value.numer());
            }
        });
        if common <= 1 { self.clone() } else { self.scaled(&Rational::from((Integer::from(1), common))) }
    }

    fn each_coefficient(&self, see: &mut impl FnMut(&Rational)) {
        match &self.0 {
            Shape::Rational(value) => see(value),
            Shape::Pair(pair) => {
                pair.plain.each_coefficient(see);
                pair.factor.each_coefficient(see);
            }
        }
    }
}
