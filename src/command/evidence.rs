//! `radcomp ledger`, and the options that say where evidence comes from.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use radcomp::evidence::{self, gaps};
use radcomp::report::Report;

use super::failure::{Failure, Verdict};
use super::terminal::{self, bold};

/// Where evidence comes from.
#[derive(Debug, Args)]
pub struct Evidence {
    /// The source tree whose code, tests and proofs cite the clauses
    #[arg(long, value_name = "DIR", default_value = ".")]
    root: PathBuf,

    /// A report of `radcomp certify --report`, whose counts are shown; may be given several times
    #[arg(long, value_name = "REPORT.json")]
    report: Vec<PathBuf>,
}

impl Evidence {
    /// Gathers it.
    pub fn gather(&self) -> Result<evidence::Ledger, Failure> {
        let reports: Result<Vec<_>, _> = self.report.iter().map(|file| Report::open(file)).collect();
        let reports = reports.map_err(|error| Failure::Input(error.to_string()))?;
        evidence::Ledger::gather(&self.root, &reports).map_err(Failure::Input)
    }
}

/// Show what supports each clause: code, tests, examples, margins, lemmas, harnesses, campaigns
#[derive(Debug, Args)]
#[command(after_help = "\
A gap is a clause without model function, implementation, test or example; known gaps
have a reason in src/evidence/gaps.rs. Any other makes the exit status 1.

Examples:
  radcomp ledger
  radcomp ledger --json --report report.json > ledger.json")]
pub struct Ledger {
    /// Write JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    evidence: Evidence,
}

impl Ledger {
    /// Prints the ledger.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let ledger = self.evidence.gather()?;
        let missing = gaps(&ledger);
        let mut out = terminal::output();
        if self.json {
            serde_json::to_writer_pretty(&mut out, &ledger).map_err(std::io::Error::from)?;
            writeln!(out)?;
        } else {
            writeln!(out, "{}", bold("clause           model reader impl tests examples vectors lemmas harnesses"))?;
            for row in &ledger.rows {
                writeln!(
                    out,
                    "{:<16} {:>5} {:>6} {:>4} {:>5} {:>8} {:>7} {:>6} {:>9}",
                    row.clause,
                    row.model.len(),
                    row.reader.len(),
                    row.implementation.len(),
                    row.tests.len(),
                    row.exercise.examples + row.exercise.other_examples,
                    row.exercise.vectors.len(),
                    row.lemmas.len(),
                    row.harnesses.len()
                )?;
            }
        }
        out.flush()?;
        for gap in &missing {
            terminal::complain(&format!("{}: {gap}", terminal::red("gap")));
        }
        Ok(if missing.is_empty() { Verdict::Green } else { Verdict::Red })
    }
}
