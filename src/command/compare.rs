//! `radcomp compare`.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use radcomp::report::Report;

use super::failure::{Failure, Verdict};
use super::terminal::{self, bold};

/// Tell what got better and what got worse from one report to another
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  radcomp compare before.json after.json

Exit status: 0 nothing got worse; 1 something did; 2 a report cannot be read.")]
pub struct Compare {
    /// The report of before
    #[arg(value_name = "A.json")]
    before: PathBuf,

    /// The report of after
    #[arg(value_name = "B.json")]
    after: PathBuf,
}

/// Counts by name, before and after; of what is bad, fewer are better.
type Changes = Vec<(String, u64, u64)>;

impl Compare {
    /// Compares the reports.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let (before, after) = (open(&self.before)?, open(&self.after)?);
        let mut out = terminal::output();
        for difference in setting(&before, &after) {
            writeln!(out, "not the same campaign: {difference}")?;
        }
        let changes = changes(&before, &after);
        let (better, worse): (Changes, Changes) =
            changes.into_iter().filter(|(_, was, is)| was != is).partition(|(_, was, is)| is < was);
        for (title, list) in [("BETTER", &better), ("WORSE", &worse)] {
            for (name, was, is) in list {
                writeln!(out, "{} {name}: {was} before, {is} after", bold(title))?;
            }
        }
        writeln!(out, "{} better, {} worse", better.len(), worse.len())?;
        out.flush()?;
        Ok(if worse.is_empty() { Verdict::Green } else { Verdict::Red })
    }
}

/// What makes the counts of two reports hard to compare.
fn setting(a: &Report, b: &Report) -> Vec<String> {
    let mut found = Vec::new();
    let mut compare = |what: &str, a: String, b: String| {
        if a != b {
            found.push(format!("{what} {a} before, {b} after"));
        }
    };
    compare("profile", format!("{} {}", a.profile, a.profile_sha256), format!("{} {}", b.profile, b.profile_sha256));
    compare("seed", a.seed.to_string(), b.seed.to_string());
    compare("generated programs", a.generated_programs.to_string(), b.generated_programs.to_string());
    compare("programs", a.tally.programs.to_string(), b.tally.programs.to_string());
    compare("grade", format!("{:?}", a.grade), format!("{:?}", b.grade));
    compare("δ", a.delta_mm.text(), b.delta_mm.text());
    found
}

/// Every count of something bad.
fn changes(a: &Report, b: &Report) -> Changes {
    let mut changes = vec![
        ("failed programs".to_owned(), a.counts.fail, b.counts.fail),
        ("expected failures".to_owned(), a.counts.expected_failure, b.counts.expected_failure),
        ("unsupported programs".to_owned(), a.counts.unsupported, b.counts.unsupported),
        ("broken relations".to_owned(), a.tally.broken, b.tally.broken),
    ];
    let clauses: BTreeSet<_> = a.tally.clauses.keys().chain(b.tally.clauses.keys()).collect();
    let failed = |report: &Report, id: &String| report.tally.clauses.get(id).map_or(0, |clause| clause.failed);
    changes.extend(clauses.iter().map(|id| (format!("failures at {id}"), failed(a, id), failed(b, id))));
    let causes: BTreeSet<_> = a.causes.iter().chain(&b.causes).map(|cause| &cause.cause).collect();
    let programs = |report: &Report, name: &String| {
        report.causes.iter().find(|cause| cause.cause == *name).map_or(0, |cause| cause.programs)
    };
    changes.extend(causes.iter().map(|name| (format!("cause {name}"), programs(a, name), programs(b, name))));
    changes
}

fn open(file: &Path) -> Result<Report, Failure> {
    Report::open(file).map_err(|error| Failure::Input(format!("{}: {error}", file.display())))
}
