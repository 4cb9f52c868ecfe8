//! The format of LinuxCNC's `rs274`.

use std::io::{self, Write};

use radcomp::canon::Canon;
use radcomp::explain::Coordinate;
use radcomp_spec::{Advisory, Step};

use super::{Ending, Print};
use crate::command::ledger::Ledger;
use crate::command::program::Placed;

/// Prints canonical calls.
pub struct CanonCalls<N>(Canon<N>);

impl<N: Coordinate> CanonCalls<N> {
    /// A printer at the start of a program, which is at (`zero`, `zero`).
    pub fn new(zero: N, digits: Option<usize>) -> Self {
        CanonCalls(Canon::new([zero.clone(), zero], digits))
    }
}

impl<N: Coordinate> Print<N> for CanonCalls<N> {
    fn step(&mut self, mut out: &mut dyn Write, step: &Step<N>, block: &Placed) -> io::Result<()> {
        let sequence = block.read.sequence.as_deref();
        self.0.step(&mut out, step, sequence, &block.read.normal, block.axes.plane)
    }

    fn advisory(&mut self, _: &mut dyn Write, _: &Advisory<N>, _: &Placed) -> io::Result<()> {
        Ok(())
    }

    fn end(&mut self, _: &mut dyn Write, _: &Ending, _: &Ledger) -> io::Result<()> {
        Ok(())
    }
}
