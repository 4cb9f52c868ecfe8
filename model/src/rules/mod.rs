//! The rules, one file to a chapter of the specification.

pub(crate) mod arc;
pub(crate) mod cancel;
pub(crate) mod corner;
pub(crate) mod dummy;
pub(crate) mod inner;
pub(crate) mod interference;
pub(crate) mod junction;
pub(crate) mod look_ahead;
pub(crate) mod mode;
pub(crate) mod outer;
pub(crate) mod side_change;
pub(crate) mod start_up;
pub(crate) mod tip;
pub(crate) mod vector;
pub(crate) mod wedge;
