//! `radcomp merge`.

use std::path::PathBuf;

use clap::Args;
use radcomp::certify::merge;
use radcomp::report::Report;

use super::failure::{Failure, Verdict};
use super::judging::Pages;
use super::terminal;

/// Put the reports of the shards of one campaign together
#[derive(Debug, Args)]
#[command(after_help = "\
What comes out is what one run of the whole campaign writes.

Example:
  radcomp certify builtin --profile seed-mill --shard 1/2 --report 1.json
  radcomp certify builtin --profile seed-mill --shard 2/2 --report 2.json
  radcomp merge 1.json 2.json -o report.json

Exit status: 0 no red verdict; 1 red verdicts; 2 a report cannot be read, or does not fit.")]
pub struct Merge {
    /// The reports of all shards, in any order
    #[arg(value_name = "REPORT.json", required = true)]
    reports: Vec<PathBuf>,

    /// The report of the whole
    #[arg(long, short, value_name = "FILE.json")]
    output: PathBuf,

    #[command(flatten)]
    pages: Pages,
}

impl Merge {
    /// Merges the reports.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let open = |file: &PathBuf| {
            let name = file.display().to_string();
            let report = Report::open(file).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
            Ok((name, report))
        };
        let reports = self.reports.iter().map(open).collect::<Result<_, Failure>>()?;
        let (campaign, outcome, report) = merge(reports).map_err(Failure::Input)?;
        self.pages.finish(&mut terminal::output(), &outcome, &campaign, &report, Some(&self.output))
    }
}
