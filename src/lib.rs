//! The radcomp toolkit: programs in, verdicts out.

pub mod gcode;
pub mod judge;
pub mod generate;
pub mod minimise;
pub mod report;
