//! What becomes of a number when the program's numbers change.

use std::collections::HashMap;

use super::Real;
use super::filter::Interval;
use super::node::{Node, Shape};

impl Real {
    /// An interval that holds every value which the expression takes when each number made by [`Real::input`] moves by
    /// at most `spread`, on its own. Where the expression has no value (a quotient by zero, the root of a negative
    /// number) it takes none, so that it need not be held.
    ///
    /// # Exactness
    ///
    /// A certain enclosure, not the narrowest: a number that occurs twice in the expression is moved twice. The ends are
    /// rounded outward. Infinite where nothing is known.
    pub fn reach(&self, spread: f64) -> (f64, f64) {
        let mut known: HashMap<*const Node, Interval> = HashMap::new();
        let mut pending = vec![self];
        while let Some(&real) = pending.last() {
            let waiting = pending.len();
            if !known.contains_key(&real.address()) {
                let operands = real.0.shape.operands();
                pending
                    .extend(operands.into_iter().flatten().filter(|operand| !known.contains_key(&operand.address())));
                if pending.len() == waiting {
                    let of = |operand: &Real| known.get(&operand.address()).copied().unwrap_or(Interval::EVERYTHING);
                    known.insert(real.address(), real.moved(spread, of));
                }
            }
            if pending.len() == waiting {
                pending.pop();
            }
        }
        known.get(&self.address()).map_or((f64::NEG_INFINITY, f64::INFINITY), |interval| (interval.low, interval.high))
    }

    /// The interval of the last step, from those of its operands.
    fn moved(&self, spread: f64, of: impl Fn(&Real) -> Interval) -> Interval {
        match &self.0.shape {
            Shape::Rational(_) => self.0.filter.get(),
            Shape::Input(_) => self.0.filter.get().add(Interval { low: -spread, high: spread }),
            Shape::Negation(a) => of(a).negate(),
            Shape::Sum(a, b) => of(a).add(of(b)),
            Shape::Difference(a, b) => of(a).subtract(of(b)),
            Shape::Product(a, b) => of(a).multiply(of(b)),
            Shape::Square(a) => of(a).square(),
            Shape::Quotient(a, b, _) => match of(b) {
                by if by.low <= 0.0 && by.high >= 0.0 => Interval::EVERYTHING,
                by => of(a).divide(by),
            },
            Shape::Root(a) => Interval { low: of(a).low, high: of(a).high.max(0.0) }.sqrt(),
        }
    }
}
