//! `radcomp gen`.

use std::io::Write;

use clap::Args;
use radcomp::certify::programs;
use radcomp::device::wire::{ProfileRecord, request};

use super::failure::{Failure, Verdict};
use super::judging::GradeName;
use super::{options, terminal};

/// Write the programs of a certification as requests, for a control that cannot be driven
#[derive(Debug, Args)]
#[command(after_help = "\
One request a line; answers to them, one a line, go to `radcomp check` with the
same profile, seed, number of programs and grade.

Example:
  radcomp gen --profile seed-mill > requests.jsonl
  my-control < requests.jsonl > answers.jsonl
  radcomp check --profile seed-mill answers.jsonl")]
pub struct Gen {
    /// The control: a built-in profile (see `radcomp profiles`) or a profile file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    profile: String,

    /// Generated programs beside the vectors and boundary triples; level 1 has 24000
    #[arg(long, value_name = "COUNT", default_value = "24000")]
    programs: u64,

    /// The seed of the generated programs
    #[arg(long, default_value = "1")]
    seed: u64,

    /// The grade of the judgement; `binary64` has programs with more decimals than a control's increment
    #[arg(long, value_enum, default_value = "binary64")]
    grade: GradeName,
}

impl Gen {
    /// Writes the requests.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let profile = options::profile(&self.profile)?;
        let record = ProfileRecord::new(&profile, &profile.parameters);
        let mut out = terminal::output();
        for (name, blocks) in programs(&profile, self.seed, self.programs, self.grade.into()) {
            // A program that cannot be told is missing on both sides.
            if let Ok(line) = request(&name, &profile, &record, &blocks) {
                out.write_all(line.as_bytes())?;
            }
        }
        out.flush()?;
        Ok(Verdict::Green)
    }
}
