//! The implementation.

use radcomp_spec::Parameters;

use crate::contour::Program;

/// Bytes of one engine, all that it ever holds.
pub fn size() -> usize {
    0
}

/// Runs the program that goes once round.
pub fn run(_: &Parameters, program: &Program<f64>) -> usize {
    program.once().count()
}

/// Runs round until `blocks` blocks have been read.
pub fn run_laps(_: &Parameters, program: &Program<f64>, blocks: usize) -> usize {
    program.laps(blocks).count()
}
