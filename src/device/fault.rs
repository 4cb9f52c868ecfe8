//! Why a device gave no answer.

use std::fmt;

/// A device that gave no answer, and why, in words for a person.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DeviceFault {
    /// The device crashed while it worked on the program.
    Crash(String),
    /// The device did not answer in time.
    Timeout(String),
    /// The device ended, or closed its output, without an answer.
    NoAnswer(String),
    /// What the device answered is no answer.
    Garbled(String),
    /// The device says that it does not take such a program. This is no failure, and no pass either.
    Unsupported(String),
}

impl DeviceFault {
    /// The name used in reports.
    pub const fn id(&self) -> &'static str {
        match self {
            DeviceFault::Crash(_) => "crash",
            DeviceFault::Timeout(_) => "timeout",
            DeviceFault::NoAnswer(_) => "no-answer",
            DeviceFault::Garbled(_) => "garbled",
            DeviceFault::Unsupported(_) => "unsupported",
        }
    }

    /// What happened.
    pub fn text(&self) -> &str {
        match self {
            DeviceFault::Crash(text)
            | DeviceFault::Timeout(text)
            | DeviceFault::NoAnswer(text)
            | DeviceFault::Garbled(text)
            | DeviceFault::Unsupported(text) => text,
        }
    }
}

impl fmt::Display for DeviceFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.id(), self.text())
    }
}

impl std::error::Error for DeviceFault {}
