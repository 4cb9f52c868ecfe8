//! The tool tip of a lathe: `spec/clauses/11-tip.md`.

use radcomp_spec::clause;
use radcomp_spec::parameters::{Parameters, StartUp, StartUpLost, Tip};
use radcomp_spec::{Segment, Step};

use crate::geometry::Vector;
use crate::number::Real;

/// Where the imaginary tip stands, in millimetres, at the end of a step of the path; none after a step that is a hold
/// and for an orientation that the control does not have.
///
/// `radius` is the tool radius in force at that step, of which the magnitude counts; `orientation` is the tool's.
///
/// # Exactness
///
/// Exact.
pub fn tip(step: &Step<Real>, parameters: &Parameters, radius: &Real, orientation: Tip) -> Option<Vector> {
    let (Segment::Line { end: [a, b] } | Segment::Arc { end: [a, b], .. }) = &step.segment else { return None };
    let point = Vector::new(a.clone(), b.clone());
    let direction = direction(orientation)?;
    // [TRC-TIP-01], and [TRC-TIP-03] for a point without a vector, which is where the tip itself stands.
    Some(if has_vector(step, parameters) { point.along(&direction, &radius.abs()) } else { point })
}

/// [TRC-TIP-03] whether the end of a step is the end of a vector, where the nose centre stands.
fn has_vector(step: &Step<Real>, parameters: &Parameters) -> bool {
    match step.clause {
        clause::TRC_MODE_01 | clause::TRC_CANCEL_02 | clause::TRC_CANCEL_03 | clause::TRC_CANCEL_06 => false,
        clause::TRC_START_04 => {
            // Arcs and entry moves end on their normal in any case.
            let arc = matches!(step.segment, Segment::Arc { .. });
            let entry = parameters.start_up == StartUp::EntryNormal;
            arc || entry || parameters.start_up_lost == StartUpLost::Normal
        }
        _ => true,
    }
}

/// [TRC-TIP-01] where the tip stands, seen from the nose centre, in tool radii.
fn direction(orientation: Tip) -> Option<Vector> {
    let (a, b) = match orientation {
        Tip::Centre => (0, 0),
        Tip::PlusPlus => (1, 1),
        Tip::MinusPlus => (-1, 1),
        Tip::MinusMinus => (-1, -1),
        Tip::PlusMinus => (1, -1),
        Tip::Plus => (1, 0),
        Tip::Minus => (-1, 0),
        Tip::UpPlus => (0, 1),
        Tip::UpMinus => (0, -1),
        Tip::Absent => return None,
    };
    Some(Vector::new(Real::integer(a), Real::integer(b)))
}
