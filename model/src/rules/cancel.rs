//! Cancel: `spec/clauses/06-cancel.md`.

use radcomp_spec::clause::{self, Clause};
use radcomp_spec::parameters::Cancel;

use crate::engine::{Pending, PendingKind};
use crate::geometry::Vector;
use crate::number::Real;

/// [TRC-CANCEL-01] the block before G40 ends on its own normal; a start-up block too, [TRC-START-05].
pub(crate) fn end_before_cancel(before: &Pending, radius: &Real, cancel: Cancel) -> (Clause, Vector) {
    let clause = match before.kind {
        PendingKind::StartUp => clause::TRC_START_05,
        PendingKind::Offset => clause::TRC_CANCEL_01,
    };
    match cancel {
        Cancel::TypeA => (clause, before.own_normal(radius)),
    }
}
