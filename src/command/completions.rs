//! `radcomp completions`.

use std::io::Write;

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use super::failure::{Failure, Verdict};
use super::{Arguments, terminal};

/// Print the completion script of a shell
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  radcomp completions bash > ~/.local/share/bash-completion/completions/radcomp
  radcomp completions fish > ~/.config/fish/completions/radcomp.fish")]
pub struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    /// Prints the script.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        // Written at once, since clap_complete panics where an output fails.
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Arguments::command(), "radcomp", &mut script);
        let mut out = terminal::output();
        out.write_all(&script)?;
        out.flush()?;
        Ok(Verdict::Green)
    }
}
