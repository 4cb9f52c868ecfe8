//! The device `lib:FILE`: a shared library that exports `radcomp_device` of `radcomp.h`.
//!
//! A library that crashes takes its process with it, so it runs in one of its own: this program, which answers for
//! the library over the pipe protocol.
#![expect(unsafe_code, reason = "the C boundary")]

use std::ffi::{CString, OsString};
use std::path::{Path, PathBuf};

use libloading::Library as Loaded;
use radcomp_c::{
    DeviceFunction, RADCOMP_OK, RADCOMP_SHORT, RADCOMP_UNSUPPORTED, radcomp_alarm, radcomp_block, radcomp_step,
};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;
use serde_json::Value;

use super::pipe::{Limits, Pipe};
use super::{Answer, Device, DeviceFault, round};
use crate::report::ParametersRecord;

/// A library in a process of its own, which `radcomp`, this program, answers for.
pub fn hosted(radcomp: PathBuf, file: &Path, control: &Profile, limits: Limits) -> Pipe {
    // A name without a folder would be looked for where the system has its libraries.
    let mut device = OsString::from("lib:");
    device.push(std::path::absolute(file).unwrap_or_else(|_| file.to_owned()));
    let name = format!("lib:{}", file.display());
    Pipe::new(name, vec![radcomp.into_os_string(), "answer".into(), device], control, limits)
}

/// A library in this process.
pub struct Library {
    loaded: Loaded,
}

/// Elements that a program may have, for each of its blocks and beside.
const MOST_STEPS: usize = 64;

impl Library {
    /// Loads a library.
    ///
    /// # Errors
    ///
    /// A file that is no library, or does not export `radcomp_device`; in words.
    pub fn load(file: &Path) -> Result<Library, String> {
        // SAFETY: what a library does when it is loaded is its own affair, as what it does when it is called; it has
        // this process to itself.
        let loaded =
            unsafe { Loaded::new(file) }.map_err(|error| format!("{} cannot be loaded: {error}", file.display()))?;
        let library = Library { loaded };
        library.function().map(|_| ()).map_err(|error| {
            format!("{} does not export radcomp_device, the function of radcomp.h: {error}", file.display())
        })?;
        Ok(library)
    }

    fn function(&self) -> Result<libloading::Symbol<'_, DeviceFunction>, libloading::Error> {
        // SAFETY: `radcomp.h` gives the function this type.
        unsafe { self.loaded.get(b"radcomp_device\0") }
    }
}

impl Device for Library {
    fn name(&self) -> &str {
        "lib"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let function = self.function().map_err(|error| DeviceFault::NoAnswer(error.to_string()))?;
        let profile = CString::new(text(parameters)).unwrap_or_default();
        let blocks: Vec<radcomp_block> = blocks.iter().map(|block| radcomp_block::from(&round(block))).collect();
        let mut steps = vec![radcomp_step::default(); MOST_STEPS * (blocks.len() + 1)];
        let (mut count, mut alarm) = (usize::MAX, radcomp_alarm::default());
        // SAFETY: every pointer is valid for the length that goes with it, and the text ends with a zero. That the library
        // keeps to them is its own affair.
        let status = unsafe {
            function(
                profile.as_ptr(),
                blocks.as_ptr(),
                blocks.len(),
                steps.as_mut_ptr(),
                steps.len(),
                &mut count,
                &mut alarm,
            )
        };
        let garbled = |text: String| Err(DeviceFault::Garbled(text));
        match status {
            RADCOMP_OK if count == usize::MAX => return garbled("radcomp_device did not write the count".to_owned()),
            RADCOMP_OK if count > steps.len() => {
                return garbled(format!(
                    "radcomp_device says that it wrote {count} elements into room for {}",
                    steps.len()
                ));
            }
            RADCOMP_OK => {}
            RADCOMP_UNSUPPORTED => {
                return Err(DeviceFault::Unsupported("radcomp_device returned RADCOMP_UNSUPPORTED".to_owned()));
            }
            RADCOMP_SHORT => {
                return garbled(format!("radcomp_device wants room for more than {} elements", steps.len()));
            }
            other => return garbled(format!("radcomp_device returned {other}")),
        }
        let steps = steps[..count].iter().map(radcomp_step::step).collect::<Option<Vec<_>>>();
        let Some(steps) = steps else {
            return garbled("an element has a shape or a direction that is none".to_owned());
        };
        match alarm.alarm() {
            Ok(alarm) => Ok(Answer { steps, alarm }),
            Err(()) => garbled("the alarm's name is none of the specification's".to_owned()),
        }
    }
}

/// The parameters as a library reads them: a line `name = value` for each.
pub fn text(parameters: &Parameters) -> String {
    let record = serde_json::to_value(ParametersRecord::from(parameters)).unwrap_or_default();
    let lines = record.as_object().into_iter().flatten().map(|(name, value)| match value {
        Value::String(text) => format!("{name} = {text}\n"),
        other => format!("{name} = {other}\n"),
    });
    lines.collect()
}
