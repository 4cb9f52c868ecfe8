//! Devices by name.

use std::fmt;

use radcomp_spec::profile::Profile;

use super::pipe::{Limits, Pipe};
use super::{Builtin, Device};

/// A device by the name that the command line gives it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceName {
    /// `builtin`: radcomp-impl in this process.
    Builtin,
    /// `pipe:COMMAND`: a shell command that speaks the pipe protocol.
    Pipe(String),
}

/// A name that is no device's.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceNameError {
    /// There is no device of this name.
    Unknown(String),
    /// `pipe:` without a command.
    NoCommand,
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
            Some(("pipe", command)) if command.trim().is_empty() => Err(DeviceNameError::NoCommand),
            Some(("pipe", command)) => Ok(DeviceName::Pipe(command.to_owned())),
            _ => Err(DeviceNameError::Unknown(name.to_owned())),
        }
    }

    /// The device, for a control. One that does not start says so when it is asked.
    pub fn open(&self, control: &Profile, limits: Limits) -> Box<dyn Device> {
        match self {
            DeviceName::Builtin => Box::new(Builtin),
            DeviceName::Pipe(command) => Box::new(Pipe::shell(command, control, limits)),
        }
    }
}

impl fmt::Display for DeviceNameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DeviceNameError::Unknown(name) => {
                write!(f, "there is no device {name}; a device is builtin or pipe:COMMAND")
            }
            DeviceNameError::NoCommand => {
                write!(f, "pipe: needs a command, such as \"pipe:python3 adapter.py\"")
            }
        }
    }
}

impl std::error::Error for DeviceNameError {}
