//! `radcomp book`.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use radcomp::book;

use super::evidence::Evidence;
use super::failure::{Failure, Verdict};
use super::terminal;

/// Build the specification as a book: a static site, its figures drawn by the exact model
#[derive(Debug, Args)]
#[command(after_help = "\
Every worked example is executed; one that does not hold fails the build, with its
file and line. The evidence of each clause is taken from the source tree.

Examples:
  radcomp book --output book
  radcomp book --output book --root ~/radcomp --report report.json")]
pub struct Book {
    /// The folder of the site; it is made if it is not there
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,

    #[command(flatten)]
    evidence: Evidence,
}

impl Book {
    /// Builds the book and writes it.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let start = Instant::now();
        let ledger = self.evidence.gather()?;
        let book = book::Book::build(&ledger).map_err(Failure::Input)?;
        book.write(&self.output)
            .map_err(|reason| Failure::Input(format!("{} cannot be written: {reason}", self.output.display())))?;
        let bytes: usize = book.files().values().map(String::len).sum();
        let mut out = terminal::output();
        writeln!(
            out,
            "{}: {} files, {:.1} MB; {} examples and vectors executed, {} figures drawn; {:.1} s",
            self.output.join("index.html").display(),
            book.files().len(),
            bytes as f64 / 1e6,
            book.examples(),
            book.figures(),
            start.elapsed().as_secs_f64()
        )?;
        out.flush()?;
        Ok(Verdict::Green)
    }
}
