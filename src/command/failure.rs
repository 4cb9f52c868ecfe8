//! How a subcommand ends.

use std::io;

use radcomp::gcode::Diagnostic;

use super::terminal;

/// How a subcommand that did its work ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All is well.
    Green,
    /// An alarm, or a red verdict.
    Red,
}

/// Why a subcommand could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// Wrong input, in words.
    Input(String),
    /// Wrong input, with its place.
    Diagnostic(Box<Diagnostic>),
    /// The output cannot be written.
    Output(io::Error),
}

impl Failure {
    /// Tells it on the standard error output.
    pub fn report(&self) {
        match self {
            Failure::Input(message) => terminal::complain(&format!("{}: {message}", terminal::red("error"))),
            Failure::Diagnostic(diagnostic) => terminal::complain(&diagnostic.render(&terminal::renderer())),
            Failure::Output(error) => {
                terminal::complain(&format!("{}: the output cannot be written: {error}", terminal::red("error")));
            }
        }
    }
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Self {
        Failure::Diagnostic(Box::new(diagnostic))
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Failure::Output(error)
    }
}
