//! The imaginary tool tip of a lathe: where it stands along the path of the nose centre ([TRC-TIP-01], [TRC-TIP-03]).

use radcomp_spec::block::Point;
use radcomp_spec::parameters::{StartUp, StartUpLost, Tip};
use radcomp_spec::{Parameters, Segment, Step, clause};
use rug::Rational;

use crate::explain::Coordinate;
use crate::gcode::Nose;

/// Where the tip stands at the end of a step, in millimetres; none for a step without movement.
///
/// `nose` is that of the step's block, none for a tool without an orientation, whose tip is its centre. A point of cancel
/// mode has no vector: it is where the tip stands.
///
/// # Exactness
///
/// Exact for the model's numbers; one rounding of the tip and one of the sum for each coordinate in `f64`.
pub fn at_end<N: Coordinate>(step: &Step<N>, nose: Option<&Nose>, parameters: &Parameters) -> Option<Point<N>> {
    let (Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. }) = &step.segment else { return None };
    Some(match nose.filter(|_| has_vector(step, parameters)) {
        Some(nose) => {
            let [along_a, along_b] = signs(nose.tip).map(|sign| Rational::from(&nose.radius * sign));
            [a.moved_by(&along_a), b.moved_by(&along_b)]
        }
        None => [a.clone(), b.clone()],
    })
}

/// The vector t(T) of an orientation; the program reader refuses tools that a control does not have.
fn signs(tip: Tip) -> [i32; 2] {
    match tip {
        Tip::Centre | Tip::Absent => [0, 0],
        Tip::PlusPlus => [1, 1],
        Tip::MinusPlus => [-1, 1],
        Tip::MinusMinus => [-1, -1],
        Tip::PlusMinus => [1, -1],
        Tip::Plus => [1, 0],
        Tip::Minus => [-1, 0],
        Tip::UpPlus => [0, 1],
        Tip::UpMinus => [0, -1],
    }
}

/// Whether the end of a step is a vector: moves of cancel mode and cancel blocks end at programmed points, and so does a
/// start-up block that loses its look-ahead where that leaves it without a vector ([TRC-START-04]).
fn has_vector<N>(step: &Step<N>, parameters: &Parameters) -> bool {
    let arc = matches!(step.segment, Segment::Arc { .. });
    let lost = parameters.start_up_lost == StartUpLost::NoVector && parameters.start_up != StartUp::EntryNormal && !arc;
    let programmed = [clause::TRC_MODE_01, clause::TRC_CANCEL_02, clause::TRC_CANCEL_03, clause::TRC_CANCEL_06];
    let without_vector = lost && step.clause == clause::TRC_START_04;
    !without_vector && !programmed.contains(&step.clause)
}
