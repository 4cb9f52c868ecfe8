//! Devices by name.

use std::fmt;
use std::path::{Path, PathBuf};

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::library;
use super::linuxcnc::LinuxCnc;
use super::pipe::{Limits, Pipe};
use super::{Answer, Builtin, Device, DeviceFault};

/// A device by the name that the command line gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceName {
    /// `builtin`: radcomp-impl in this process.
    Builtin,
    /// `pipe:COMMAND`: a shell command that speaks the pipe protocol.
    Pipe(String),
    /// `lib:FILE`: a shared library with the C interface of `radcomp.h`.
    Library(PathBuf),
    /// `linuxcnc`: LinuxCNC's interpreter `rs274`.
    LinuxCnc,
}

/// A device that could not be opened, and says so to every program.
struct Absent {
    name: &'static str,
    reason: String,
}

impl Device for Absent {
    fn name(&self) -> &str {
        self.name
    }

    fn answer(&mut self, _: &Parameters, _: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        Err(DeviceFault::NoAnswer(self.reason.clone()))
    }
}

/// A name that is no device's.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceNameError {
    /// There is no device of this name.
    Unknown(String),
    /// `pipe:` without a command.
    NoCommand,
    /// `lib:` without a file, or with one that is not there.
    NoFile(PathBuf),
}

impl DeviceName {
    /// Reads a name.
    ///
    /// # Errors
    ///
    /// A name that is no device's.
    pub fn parse(name: &str) -> Result<DeviceName, DeviceNameError> {
        match name.split_once(':') {
            None if name == "builtin" => Ok(DeviceName::Builtin),
            None if name == "linuxcnc" => Ok(DeviceName::LinuxCnc),
            Some(("pipe", command)) if command.trim().is_empty() => Err(DeviceNameError::NoCommand),
            Some(("pipe", command)) => Ok(DeviceName::Pipe(command.to_owned())),
            Some(("lib", file)) if !Path::new(file).is_file() => Err(DeviceNameError::NoFile(file.into())),
            Some(("lib", file)) => Ok(DeviceName::Library(file.into())),
            _ => Err(DeviceNameError::Unknown(name.to_owned())),
        }
    }

    /// The device, for a control. One that does not start says so when it is asked.
    pub fn open(&self, control: &Profile, limits: Limits) -> Box<dyn Device> {
        match self {
            DeviceName::Builtin => Box::new(Builtin),
            DeviceName::Pipe(command) => Box::new(Pipe::shell(command, control, limits)),
            DeviceName::Library(file) => match std::env::current_exe() {
                Ok(radcomp) => Box::new(library::hosted(radcomp, file, control, limits)),
                Err(error) => {
                    Box::new(Absent { name: "lib", reason: format!("radcomp does not find itself: {error}") })
                }
            },
            DeviceName::LinuxCnc => match LinuxCnc::open(control, limits) {
                Ok(device) => Box::new(device),
                Err(error) => Box::new(Absent { name: "linuxcnc", reason: error.to_string() }),
            },
        }
    }
}

impl fmt::Display for DeviceNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DeviceNameError::Unknown(name) => {
                write!(f, "there is no device {name}; a device is builtin, pipe:COMMAND, lib:FILE or linuxcnc")
            }
            DeviceNameError::NoCommand => {
                write!(f, "pipe: needs a command, such as \"pipe:python3 adapter.py\"")
            }
            DeviceNameError::NoFile(file) => {
                write!(f, "there is no file {}; lib: needs a shared library, such as lib:./control.so", file.display())
            }
        }
    }
}

impl std::error::Error for DeviceNameError {}
