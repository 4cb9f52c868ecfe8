//! Devices under test.

mod builtin;

pub use builtin::{Builtin, round};

use radcomp_spec::{Alarm, Block, Parameters, Step};
use rug::Rational;

/// What a device answers to one program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// The path of the tool's centre.
    pub steps: Vec<Step<f64>>,
    /// The alarm that ended it.
    pub alarm: Option<Alarm>,
}

/// A device that gave no answer, and whose fault that is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceFault {
    /// The device crashed while it worked on the program.
    Crash(String),
}

/// An implementation of tool-radius compensation.
pub trait Device {
    /// The name that reports use.
    fn name(&self) -> &str;

    /// The device's answer to a program.
    ///
    /// # Errors
    ///
    /// A [`DeviceFault`] concerns this program only; the next one may be asked all the same.
    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault>;
}
