//! Numbers of the model's own kernel, computed anew in a tower.

use std::collections::HashMap;

use super::{Number, Refusal, Tower};
use crate::number::{Expression, Identity, Real};

impl Number {
    /// The number computed anew from the expression that made it, with at most `most_roots` independent roots.
    ///
    /// # Errors
    ///
    /// [`Refusal::TooManyRoots`]. The other two say that the kernels disagree about the sign of a radicand or a divisor.
    ///
    /// # Exactness
    ///
    /// Exact; nothing is taken over from the other kernel but rationals and operations.
    pub fn from_real(real: &Real, most_roots: usize) -> Result<Number, Refusal> {
        Tower::new(most_roots).convert(real)
    }
}

impl Tower {
    /// A number computed anew from the expression that made it, over the roots of this tower and, if needed, new ones.
    ///
    /// # Errors
    ///
    /// [`Refusal::TooManyRoots`]. The other two say that the kernels disagree about the sign of a radicand or a divisor.
    ///
    /// # Exactness
    ///
    /// Exact; nothing is taken over from the other kernel but rationals and operations.
    pub fn convert(&mut self, real: &Real) -> Result<Number, Refusal> {
        let mut known: HashMap<Identity, Number> = HashMap::new();
        // An expression may be deeper than the stack. A number waits below its operands until they are known.
        let mut waiting = vec![real];
        while let Some(&next) = waiting.last() {
            let before = waiting.len();
            if !known.contains_key(&next.identity()) {
                let operands = next.expression().operands();
                waiting.extend(operands.filter(|operand| !known.contains_key(&operand.identity())));
            }
            if waiting.len() > before {
                continue;
            }
            waiting.pop();
            if !known.contains_key(&next.identity()) {
                let number = self.step(next.expression(), &known)?;
                known.insert(next.identity(), number);
            }
        }
        // The loop ends when the last of the waiting, the number itself, is known.
        Ok(known.remove(&real.identity()).expect("computed last"))
    }

    /// One step of an expression whose operands are known.
    fn step(&mut self, expression: Expression<'_>, known: &HashMap<Identity, Number>) -> Result<Number, Refusal> {
        let of = |real: &Real| &known[&real.identity()];
        Ok(match expression {
            Expression::Rational(value) => Number::rational(value.clone()),
            Expression::Negation(a) => -of(a),
            Expression::Sum(a, b) => of(a) + of(b),
            Expression::Difference(a, b) => of(a) - of(b),
            Expression::Product(a, b) => of(a) * of(b),
            Expression::Square(a) => of(a).square(),
            Expression::Quotient(a, b) => of(a).checked_div(of(b)).ok_or(Refusal::ZeroDivisor)?,
            Expression::Root(a) => self.sqrt(of(a))?,
        })
    }
}
