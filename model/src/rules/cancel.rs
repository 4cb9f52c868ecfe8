//! Cancel: `spec/clauses/06-cancel.md`. Offset number 0 ([TRC-CANCEL-07]) is the program reader's: its blocks hold the
//! codes that they count as.

use radcomp_spec::clause;
use radcomp_spec::parameters::{Cancel, CancelVector, StartUpB};

use super::junction::{Junction, Refused, Setting};
use super::{corner, vector};
use crate::decision::Judgement;
use crate::element::{Arm, Element};
use crate::engine::Pending;
use crate::geometry::Vector;

/// The junction before a block with G40, which moves along `cancel` unless it is one without movement, and has the
/// vector `imaginary` beside its code.
pub(crate) fn junction(
    before: &Pending,
    cancel: Option<&Element>,
    imaginary: Option<&Vector>,
    setting: Setting<'_>,
    judgement: &mut Judgement<'_>,
) -> Result<Junction, Refused> {
    if before.starts_up() {
        // [TRC-START-05]
        return Ok(Junction::single(clause::TRC_START_05, before.own_normal()));
    }
    // [TRC-CANCEL-08] whatever `cancel` says.
    if let (CancelVector::ImaginaryLine, Some(along)) = (setting.parameters.cancel_vector, imaginary)
        && let Some(line) = Arm::imaginary(&before.element.end, along)
    {
        let met = vector::meet(&before.element.last_arm(), &line, before.side, setting.radius, judgement)?;
        let on_line = met.map(|vector| Junction::single(clause::TRC_CANCEL_08, vector));
        return Ok(on_line.unwrap_or_else(|| Junction::single(clause::TRC_CANCEL_01, before.own_normal())));
    }
    // [TRC-CANCEL-05]; [TRC-CANCEL-03] type A, if the block does not move.
    if let (Cancel::TypeB, Some(cancel)) = (setting.parameters.cancel, cancel) {
        let after = cancel.first_arm();
        let outer = corner::of_type_b(&before.element.last_arm(), &after, before.side, setting, judgement)?;
        if let Some(outer) = outer {
            let via = setting.parameters.start_up_b == StartUpB::ViaNormal;
            let normal = via.then(|| after.normal(before.side, setting.radius));
            return Ok(outer.junction_of_type_b(clause::TRC_CANCEL_05, None, normal));
        }
    }
    // [TRC-CANCEL-01] the block before ends on its own normal.
    Ok(Junction::single(clause::TRC_CANCEL_01, before.own_normal()))
}
