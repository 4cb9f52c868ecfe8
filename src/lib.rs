//! The radcomp toolkit: programs in, verdicts out.

pub mod certify;
pub mod device;
pub mod gcode;
pub mod generate;
pub mod judge;
pub mod minimise;
pub mod vectors;
