//! Why blocks cannot be written as G-code.

use std::fmt;

use rug::Rational;

use crate::gcode::diagnostic::Diagnostic;
use crate::gcode::word::MOST_DIGITS;

/// Why blocks have no G-code under a profile.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PrintError {
    /// A number of a block cannot be written with as many digits as the reader takes.
    Number {
        /// Index of the block, from 0.
        block: usize,
        /// The number to write.
        value: Rational,
    },
    /// There is no code, under the profile, that does what a block asks for.
    NoCode {
        /// Index of the block, from 0.
        block: usize,
        /// What it asks for.
        wanted: &'static str,
    },
    /// More radii than there are offset numbers.
    TooManyRadii,
    /// The reader refuses the program.
    Refused(Box<Diagnostic>),
    /// The program reads back as another one.
    Different {
        /// Index of the first block that differs, from 0.
        block: usize,
    },
}

impl fmt::Display for PrintError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PrintError::Number { block, value } => {
                write!(
                    f,
                    "block {block}: G-code has no number {value}: at most {MOST_DIGITS} digits on each side of the point"
                )
            }
            PrintError::NoCode { block, wanted } => write!(f, "block {block}: there is no code for {wanted}"),
            PrintError::TooManyRadii => write!(f, "the program has more than 99 radii"),
            PrintError::Refused(diagnostic) => write!(f, "the reader refuses the program:\n{diagnostic}"),
            PrintError::Different { block } => write!(f, "block {block} reads back as another block"),
        }
    }
}

impl std::error::Error for PrintError {}
