//! Modes, codes and alarms: `spec/clauses/02-mode.md`.

use radcomp_spec::parameters::{NegativeRadius, Ratio};
use radcomp_spec::{Block, Centre, Compensation, Movement, Side};
use rug::Rational;

use crate::number::Real;

/// [TRC-MODE-07] A million metres, in millimetres.
const LIMIT: u32 = 1_000_000_000;

/// The exact value of a profile's limit.
pub(crate) fn ratio(ratio: Ratio) -> Real {
    Real::rational(Rational::from((ratio.numerator, ratio.denominator)))
}

/// [TRC-MODE-07] The movement words of a block that raises an alarm of [TRC-MODE-08] are not looked at.
pub(crate) fn in_range(block: &Block<Rational>, negative_radius: NegativeRadius) -> bool {
    let within = |value: &Rational| *value <= LIMIT && *value >= -i64::from(LIMIT);
    let point = |point: &[Rational; 2]| point.iter().all(within);
    let movement = match &block.movement {
        _ if block.not_in_mode.is_some() => true,
        Movement::None | Movement::CornerArc { vector: None } => true,
        Movement::Line { end } | Movement::HeldVector { end } => point(end),
        Movement::Dummy { vector } | Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) } => {
            point(vector)
        }
        Movement::Arc { end, centre, .. } => {
            point(end)
                && match centre {
                    Centre::FromStart(vector) => point(vector),
                    Centre::Radius(radius) => within(radius),
                }
        }
    };
    let allowed = |radius: &Rational| negative_radius == NegativeRadius::SwapsSides || *radius >= 0;
    movement
        && block.vector.as_ref().is_none_or(point)
        && block.radius.as_ref().is_none_or(|radius| within(radius) && allowed(radius))
}

/// The tool offset in force: the sum of geometry and wear, which the program reader forms ([TRC-TIP-02]).
#[derive(Clone, Debug)]
pub(crate) struct Offset {
    /// The tool radius r, never negative.
    pub(crate) radius: Real,
    /// The offset is negative, and the sides are exchanged ([TRC-SIDE-07]).
    negative: bool,
}

impl Offset {
    /// The offset before the first one of a program.
    pub(crate) fn none() -> Self {
        Offset { radius: Real::zero(), negative: false }
    }

    /// An offset as the program gives it.
    pub(crate) fn read(value: &Rational, number: fn(&Rational) -> Real) -> Self {
        let negative = *value < 0;
        let value = number(value);
        Offset { radius: if negative { -value } else { value }, negative }
    }

    /// The side on which the tool runs under a code.
    pub(crate) fn side(&self, code: Side) -> Side {
        if self.negative { code.other() } else { code }
    }
}

/// Whether a block gives the code of the side in force again; asked of the code, not of the side ([TRC-MODE-05],
/// [TRC-SIDE-07]).
pub(crate) fn same_code(block: &Block<Rational>, in_force: Option<Side>) -> bool {
    matches!(block.compensation, Some(Compensation::On(code)) if in_force == Some(code))
}

/// Whether a block gives the code of the other side than the one in force ([TRC-SIDE-01]).
pub(crate) fn other_code(block: &Block<Rational>, in_force: Option<Side>) -> bool {
    matches!(block.compensation, Some(Compensation::On(code)) if in_force == Some(code.other()))
}
