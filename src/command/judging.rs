//! The options that say what answers are judged by, and where the report goes.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use radcomp::certify::{Campaign, Outcome, Waivers};
use radcomp::judge::{Budget, Grade};
use radcomp::report::{Report, junit, page};

use super::failure::{Failure, Verdict};
use super::{options, results};

/// What answers are judged by.
#[derive(Debug, Args)]
pub struct Judging {
    /// The control: a built-in profile (see `radcomp profiles`) or a profile file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    profile: String,

    /// The seed of the generated programs
    #[arg(long, default_value = "1")]
    seed: u64,

    /// How near to a decision a device may take the other branch
    #[arg(long, value_enum, default_value = "binary64")]
    grade: GradeName,

    /// How far a point may lie from where its branch puts it, in millimetres
    #[arg(long, value_name = "MM", default_value = "0.000001", value_parser = delta)]
    delta: f64,

    /// Accept the failures that this file lists, each with its clause and reason; a waiver that covers none is an error
    #[arg(long, value_name = "FILE.toml")]
    waivers: Option<PathBuf>,
}

/// What a report becomes.
#[derive(Debug, Args)]
pub struct Outputs {
    /// Write the counts, failures and smallest counterexamples to a JSON file
    #[arg(long, value_name = "FILE.json")]
    pub report: Option<PathBuf>,

    #[command(flatten)]
    pub pages: Pages,
}

/// What a report becomes beside itself, and what it passes with.
#[derive(Debug, Args)]
pub struct Pages {
    /// Write a test case for each clause as JUnit XML, for continuous integration
    #[arg(long, value_name = "FILE.xml")]
    junit: Option<PathBuf>,

    /// Write the report as one HTML page, with a picture of each cause
    #[arg(long, value_name = "FILE.html")]
    html: Option<PathBuf>,

    /// Do not fail for programs that the device says it does not support
    #[arg(long)]
    pub allow_unsupported: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum GradeName {
    /// 2^-40 times the largest number of the program
    Binary64,
    /// Half the least input increment
    Resolution,
}

impl From<GradeName> for Grade {
    fn from(name: GradeName) -> Grade {
        match name {
            GradeName::Binary64 => Grade::Binary64,
            GradeName::Resolution => Grade::Resolution,
        }
    }
}

/// A length in millimetres, greater than 0.
fn delta(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a decimal number of millimetres".to_owned())?;
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err("a length greater than 0".to_owned()) }
}

impl Judging {
    /// The campaign of so many generated programs.
    pub fn campaign(&self, programs: u64, threads: usize) -> Result<Campaign, Failure> {
        let profile = options::profile(&self.profile)?;
        let increment = profile.machine.least_increment;
        Ok(Campaign {
            seed: self.seed,
            programs,
            budget: Budget {
                grade: self.grade.into(),
                least_increment: f64::from(increment.numerator) / f64::from(increment.denominator),
                delta: self.delta,
            },
            waivers: self.waivers()?,
            threads,
            profile,
        })
    }

    fn waivers(&self) -> Result<Waivers, Failure> {
        let Some(path) = &self.waivers else { return Ok(Waivers::default()) };
        let file = path.display();
        let text = fs::read_to_string(path).map_err(|reason| Failure::Input(format!("{file}: {reason}")))?;
        Waivers::parse(&text).map_err(|error| Failure::Input(format!("{file}: {error}")))
    }
}

impl Pages {
    /// Tells what came of a campaign, writes what is asked for, and says whether the device has passed. `file` is where the
    /// report stands.
    pub fn finish(
        &self,
        out: &mut dyn Write,
        outcome: &Outcome,
        campaign: &Campaign,
        report: &Report,
        file: Option<&Path>,
    ) -> Result<Verdict, Failure> {
        if let Some(path) = file {
            let unwritable = |reason| Failure::Input(format!("{} cannot be written: {reason}", path.display()));
            let file = File::create(path).map_err(unwritable)?;
            report.write(BufWriter::new(file)).map_err(unwritable)?;
        }
        if let Some(path) = &self.junit {
            write(path, &junit(report, &name_of(file)).map_err(Failure::Input)?)?;
        }
        if let Some(path) = &self.html {
            write(path, &page(report, &name_of(file)).map_err(Failure::Input)?)?;
        }
        results::print(out, outcome, report, &campaign.profile, file, self.allow_unsupported)?;
        out.flush()?;
        // A waiver may be for a program of another part.
        let unused = report.expected_failures.iter().filter(|waiver| waiver.programs == 0 && report.shard.is_none());
        let unused: Vec<_> = unused.map(|waiver| format!("{}: {}", waiver.clause.0, waiver.reason)).collect();
        if !unused.is_empty() {
            return Err(Failure::Input(format!("waivers that cover no failure\n{}", unused.join("\n"))));
        }
        Ok(if results::is_pass(outcome, self.allow_unsupported) { Verdict::Green } else { Verdict::Red })
    }
}

/// The report's name in the commands that are shown.
fn name_of(file: Option<&Path>) -> String {
    file.map_or_else(|| "report.json".to_owned(), |path| path.display().to_string())
}

/// Writes a file.
pub fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|reason| Failure::Input(format!("{} cannot be written: {reason}", path.display())))
}
