//! Why a report cannot be read.

use std::path::PathBuf;
use std::{fmt, io};

use super::document::{FORMAT, MOST_BYTES};

/// Why a file is not a report.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReportError {
    /// The file cannot be read.
    Unreadable {
        /// The file.
        file: PathBuf,
        /// Why.
        reason: io::Error,
    },
    /// The file has more than [`MOST_BYTES`] bytes.
    TooLarge {
        /// The file.
        file: PathBuf,
    },
    /// The text is not a report: what is wrong, with its line and column.
    Malformed(serde_json::Error),
    /// A report in a format of another time.
    OtherFormat {
        /// The number that it gives.
        found: u64,
    },
}

impl fmt::Display for ReportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReportError::Unreadable { file, reason } => match reason.kind() {
                io::ErrorKind::NotFound => write!(f, "there is no file {}", file.display()),
                io::ErrorKind::IsADirectory => write!(f, "{} is a directory, not a file", file.display()),
                io::ErrorKind::InvalidData => write!(f, "{} is not text", file.display()),
                _ => write!(f, "{} cannot be read: {reason}", file.display()),
            },
            ReportError::TooLarge { file } => {
                write!(f, "{} is larger than {} MiB: no report is", file.display(), MOST_BYTES >> 20)
            }
            ReportError::Malformed(error) => write!(f, "not a report: {error}"),
            ReportError::OtherFormat { found } => {
                write!(f, "a report of format {found}; this radcomp reads format {FORMAT}")
            }
        }
    }
}

impl std::error::Error for ReportError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            ReportError::Unreadable { reason, .. } => Some(reason),
            ReportError::Malformed(error) => Some(error),
            ReportError::TooLarge { .. } | ReportError::OtherFormat { .. } => None,
        }
    }
}
