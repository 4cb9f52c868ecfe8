//! `radcomp replay`.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use radcomp::judge::{Budget, Grade, judge};
use radcomp::report::{Case, Report, case as recorded};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::device::{self, DeviceLimits};
use super::failure::{Failure, Verdict};
use super::terminal::{self, bold};

/// Ask the device again for the smallest failure of each cause of a report
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  radcomp replay report.json
  radcomp replay report.json --case \"TRC-CORNER-08 end point\" --device \"pipe:./control-2\"

Exit status: 0 no failure any more; 1 failures; 2 wrong usage or input.")]
pub struct Replay {
    /// The report, as `radcomp certify --report` writes it
    #[arg(value_name = "REPORT.json")]
    report: PathBuf,

    /// Only this cause, or the programs of this name, the kept cases among them
    #[arg(long, value_name = "NAME")]
    case: Option<String>,

    /// Another device than the report's
    #[arg(long, value_name = "DEVICE")]
    device: Option<String>,

    #[command(flatten)]
    limits: DeviceLimits,
}

impl Replay {
    /// Judges the programs again.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let wrong = |reason: String| Failure::Input(format!("{}: {reason}", self.report.display()));
        let report = Report::open(&self.report).map_err(|error| wrong(error.to_string()))?;
        let profile =
            Profile::parse(&report.profile_file, &report.profile).map_err(|error| wrong(error.to_string()))?;
        let parameters = Parameters::from(&report.parameters);
        let name = device::named(self.device.as_deref().unwrap_or(&report.device))?;
        let mut device = name.open(&profile, self.limits.limits());
        let grade = Grade::from(report.grade);
        let budget = Budget { grade, least_increment: report.least_increment_mm.0, delta: report.delta_mm.0 };
        let cases = self.cases(&report);
        if cases.is_empty() && self.case.is_some() {
            return Err(wrong("no cause and no case has this name".to_owned()));
        }
        let mut out = terminal::output();
        let mut verdict = Verdict::Green;
        for (name, case) in &cases {
            let blocks: Vec<Block<Rational>> = case.program.iter().map(Block::from).collect();
            let judged = judge(&mut *device, &parameters, &blocks, &budget);
            if judged.verdict.is_red() {
                verdict = Verdict::Red;
            }
            let now = recorded(&case.name, &blocks, &judged, &budget, budget.beta(&blocks));
            let same = now.as_ref().is_some_and(|now| is_same(now, case));
            let told = if same { bold("same") } else { bold("changed") };
            writeln!(out, "{told} {name}: {}, was {}", judged.verdict.id(), case.verdict)?;
        }
        writeln!(out, "{} programs asked again", cases.len())?;
        out.flush()?;
        Ok(verdict)
    }

    /// The cases that are meant, each with the name to tell it by.
    fn cases<'r>(&self, report: &'r Report) -> Vec<(String, &'r Case)> {
        let causes = report.causes.iter().filter_map(|cause| Some((&cause.cause, cause.case.as_ref()?)));
        let causes = causes.map(|(cause, case)| (format!("{cause} ({})", case.name), &cause[..], case));
        let cases = report.cases.iter().map(|case| (case.name.clone(), &case.name[..], case));
        match &self.case {
            None => causes.map(|(told, _, case)| (told, case)).collect(),
            Some(wanted) => {
                let named = causes.chain(cases).filter(|(_, name, case)| name == wanted || case.name == *wanted);
                named.map(|(told, _, case)| (told, case)).collect()
            }
        }
    }
}

/// Whether verdict, answer and fault are those recorded. A NaN is not equal to itself, its text is.
fn is_same(now: &Case, was: &Case) -> bool {
    now.verdict == was.verdict && format!("{:?}", now.answer) == format!("{:?}", was.answer) && now.fault == was.fault
}
