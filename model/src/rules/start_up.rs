//! Start-up: `spec/clauses/03-start-up.md`.

use radcomp_spec::Side;
use radcomp_spec::clause;
use radcomp_spec::parameters::StartUp;

use super::junction::{Junction, Setting};
use crate::element::Element;

/// [TRC-START-02] type A: the vector at right angles to the next element at its start.
pub(crate) fn junction(next: &Element, side: Side, setting: Setting<'_>) -> Junction {
    match setting.parameters.start_up {
        StartUp::TypeA => Junction::single(clause::TRC_START_02, next.first_arm().normal(side, setting.radius)),
    }
}
