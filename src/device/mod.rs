//! Devices under test.
//!
//! A [`Device`] answers programs. What it cannot answer is a [`DeviceFault`], which costs the one program: the next one
//! may be asked all the same. [`DeviceName`] makes a device of the name that the command line gives it.

mod builtin;
mod fault;
pub mod kit;
pub mod library;
pub mod linuxcnc;
mod open;
pub mod ping;
pub mod pipe;
pub mod wire;

use std::panic::{AssertUnwindSafe, catch_unwind};

pub use builtin::{Builtin, round};
pub use fault::DeviceFault;
pub use open::{DeviceName, DeviceNameError};

use radcomp_model::Run;
use radcomp_model::number::Real;
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

impl From<&Run> for Answer {
    /// The model's outcome in `f64`, each coordinate within one unit in the last place.
    fn from(run: &Run) -> Answer {
        Answer { steps: run.steps.iter().map(|step| step.map(Real::to_f64)).collect(), alarm: run.alarm }
    }
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

    /// The device's answers to several programs, in their order. A device that works on several at a time overrides it.
    fn answer_all(
        &mut self,
        parameters: &Parameters,
        programs: &[Vec<Block<Rational>>],
    ) -> Vec<Result<Answer, DeviceFault>> {
        programs.iter().map(|blocks| ask(self, parameters, blocks)).collect()
    }
}

impl<D: Device + ?Sized> Device for Box<D> {
    fn name(&self) -> &str {
        (**self).name()
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        (**self).answer(parameters, blocks)
    }

    fn answer_all(
        &mut self,
        parameters: &Parameters,
        programs: &[Vec<Block<Rational>>],
    ) -> Vec<Result<Answer, DeviceFault>> {
        (**self).answer_all(parameters, programs)
    }
}

/// The device's answer; a panic of a device in this process costs this one answer.
///
/// # Errors
///
/// As [`Device::answer`].
pub fn ask<D: Device + ?Sized>(
    device: &mut D,
    parameters: &Parameters,
    blocks: &[Block<Rational>],
) -> Result<Answer, DeviceFault> {
    catch_unwind(AssertUnwindSafe(|| device.answer(parameters, blocks))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(DeviceFault::Crash(text.unwrap_or_else(|| "panic".to_owned())))
    })
}
