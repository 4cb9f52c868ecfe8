//! Modes, codes and alarms: `spec/clauses/02-mode.md`.

use radcomp_spec::parameters::Ratio;
use radcomp_spec::{Block, Centre, Movement};
use rug::Rational;

use crate::number::Real;

/// [TRC-MODE-07] A million metres, in millimetres.
const LIMIT: u32 = 1_000_000_000;

/// The exact value of a profile's limit.
pub(crate) fn ratio(ratio: Ratio) -> Real {
    Real::rational(Rational::from((ratio.numerator, ratio.denominator)))
}

/// [TRC-MODE-07]
pub(crate) fn in_range(block: &Block<Rational>) -> bool {
    let within = |value: &Rational| *value <= LIMIT && *value >= -i64::from(LIMIT);
    let point = |point: &[Rational; 2]| point.iter().all(within);
    let movement = match &block.movement {
        Movement::None => true,
        Movement::Line { end } => point(end),
        Movement::Dummy { vector } => point(vector),
        Movement::Arc { end, centre, .. } => {
            point(end)
                && match centre {
                    Centre::FromStart(vector) => point(vector),
                    Centre::Radius(radius) => within(radius),
                }
        }
    };
    movement && block.radius.as_ref().is_none_or(|radius| within(radius) && *radius >= 0)
}
