//! `radcomp verify-witness`.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use radcomp::report::{GradeRecord, Report};
use radcomp::verify::{Count, Finding, MOST_RUNS, verify};

use super::failure::{Failure, Verdict};
use super::terminal::{self, bold};

/// Check every witness and every inadmissible verdict of a report, by code of its own
#[derive(Debug, Args)]
#[command(after_help = "\
The checker shares no code with the judge. It needs the report alone, runs the
exact model, and compares every distance and every margin exactly.

Examples:
  radcomp certify builtin --profile yasnac-lx --report report.json
  radcomp verify-witness report.json

Exit status: 0 everything is confirmed; 1 something is not; 2 the report cannot
be read.")]
pub struct VerifyWitness {
    /// The report, as `radcomp certify --report` writes it
    #[arg(value_name = "REPORT.json")]
    report: PathBuf,
}

impl VerifyWitness {
    /// Checks the report.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let file = self.report.display();
        let report = Report::open(&self.report).map_err(|error| Failure::Input(format!("{file}: {error}")))?;
        let mut out = terminal::output();
        let grade = match report.grade {
            GradeRecord::Binary64 => "binary64",
            GradeRecord::Resolution => "resolution",
        };
        writeln!(out, "{} on {}, grade {grade}, δ = {} mm", report.device, report.profile, report.delta_mm.text())?;
        let mut written = Ok(());
        let summary = verify(&report, |case, finding| {
            if let Finding::NotConfirmed(reason) = finding
                && written.is_ok()
            {
                written = writeln!(out, "{} {} {}: {reason}", bold("NOT CONFIRMED"), case.name, case.verdict);
            }
        });
        written?;
        for contradiction in &summary.contradictions {
            writeln!(out, "{} {contradiction}", bold("NOT CONFIRMED"))?;
        }
        writeln!(out)?;
        for (verdict, count) in &summary.verdicts {
            writeln!(out, "{verdict}: {}{}", told(*count), claim(verdict))?;
        }
        let exact = report.tally.verdicts.get("exact").copied().unwrap_or_default();
        writeln!(out, "not in the report, and not checked: {exact} exact answers, {} others", report.cases_left_out)?;
        let confirmed = summary.is_confirmed();
        writeln!(out, "{}", bold(if confirmed { "CONFIRMED" } else { "NOT CONFIRMED" }))?;
        out.flush()?;
        Ok(if confirmed { Verdict::Green } else { Verdict::Red })
    }
}

fn told(count: Count) -> String {
    let Count { confirmed, refuted, unchecked } = count;
    let parts = [(confirmed, "confirmed"), (refuted, "not confirmed"), (unchecked, "with nothing to check")];
    let told = parts.iter().filter(|(number, _)| *number > 0).map(|(number, name)| format!("{number} {name}"));
    told.collect::<Vec<_>>().join(", ")
}

/// What a confirmed verdict means.
fn claim(verdict: &str) -> String {
    match verdict {
        "exact" => "\n  the answer is the exact outcome to within δ".to_owned(),
        "admissible" => "\n  no number of the witness is farther than β from the program's, and the answer is the \
                         exact outcome of the witness to within δ"
            .to_owned(),
        "admissible-without-witness" => "\n  the answer is the outcome on other branches at decisions within β, to \
                                         within δ; that an input within β has this outcome is not shown"
            .to_owned(),
        "inadmissible" => "\n  the answer is farther than δ from the exact outcome and from that on every combination \
                           of branches at decisions within β"
            .to_owned(),
        "fork-limit" => {
            format!(
                "\n  the answer is farther than δ from the exact outcome and from those on as many as {MOST_RUNS} \
                     combinations of branches at decisions within β"
            )
        }
        _ => String::new(),
    }
}
