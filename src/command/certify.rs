//! `radcomp certify`.

use std::fs;
use std::io::{BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::thread;

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use radcomp::boundary;
use radcomp::certify::{Campaign, Failure as Failed, Level, Outcome, Waivers, certify};
use radcomp::explain::{Axes, first_sentence};
use radcomp::generate::Reach;
use radcomp::judge::{Budget, Grade, Verdict as Judgement};
use radcomp::plot::comparison;
use radcomp::report::{DeviceRecord, Report, junit, page};
use radcomp_spec::profile::Profile;

use super::device::{self, DeviceLimits};
use super::failure::{Failure, Verdict};
use super::options;
use super::terminal;

/// Judge a device on the vectors and generated programs of a level
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Certify {
    /// The device: builtin (radcomp's own implementation in f64), pipe:COMMAND (an adapter), lib:FILE (a shared
    /// library) or linuxcnc (rs274); `radcomp ping` tests one
    #[arg(value_name = "DEVICE")]
    device: String,

    /// The device's version, for the report; that of builtin is known
    #[arg(long, value_name = "VERSION")]
    device_version: Option<String>,

    #[command(flatten)]
    limits: DeviceLimits,

    /// Do not fail for programs that the device says it does not support
    #[arg(long)]
    allow_unsupported: bool,

    /// The control: a built-in profile (see `radcomp profiles`) or a profile file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    profile: String,

    /// How much is judged: 1 takes seconds, 2 minutes
    #[arg(long, short, default_value = "1", value_parser = clap::value_parser!(u8).range(1..=2))]
    level: u8,

    /// Judge this many generated programs, at least as many as the level asks for
    #[arg(long, value_name = "COUNT")]
    programs: Option<u64>,

    /// The seed of the generated programs
    #[arg(long, default_value = "1")]
    seed: u64,

    /// Threads; the result does not depend on their number
    #[arg(long, short, value_name = "COUNT")]
    jobs: Option<usize>,

    /// How near to a decision a device may take the other branch
    #[arg(long, value_enum, default_value = "binary64")]
    grade: GradeName,

    /// How far a point may lie from where its branch puts it, in millimetres
    #[arg(long, value_name = "MM", default_value = "0.000001", value_parser = delta)]
    delta: f64,

    /// Write the counts, failures and smallest counterexamples to a JSON file
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,

    /// Write a test case for each clause as JUnit XML, for continuous integration
    #[arg(long, value_name = "FILE.xml")]
    junit: Option<PathBuf>,

    /// Write the report as one HTML page, with a picture of each cause
    #[arg(long, value_name = "FILE.html")]
    html: Option<PathBuf>,

    /// Accept the failures that this file lists, each with its clause and reason; a waiver that covers none is an error
    #[arg(long, value_name = "FILE.toml")]
    waivers: Option<PathBuf>,

    /// Write each smallest counterexample into this folder, as a program with its tool table and a picture
    #[arg(long, value_name = "FOLDER")]
    counterexamples: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  radcomp certify builtin --profile yasnac-lx --level 1
  radcomp certify 'pipe:python3 adapter.py' --profile seed-mill --timeout 60
  radcomp certify builtin --profile my-control.toml --level 2 --seed 20 --report report.json

Exit status: 0 no red verdict; 1 red verdicts; 2 wrong usage or input.";

#[derive(Clone, Copy, Debug, ValueEnum)]
enum GradeName {
    /// 2^-40 times the largest number of the program
    Binary64,
    /// Half the least input increment
    Resolution,
}

/// A length in millimetres, greater than 0.
pub(super) fn delta(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "a decimal number of millimetres".to_owned())?;
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err("a length greater than 0".to_owned()) }
}

/// How many failed programs get a line of their own.
const MOST_LINES: usize = 20;

impl Certify {
    /// Runs the campaign.
    pub fn execute(self) -> Result<Verdict, Failure> {
        let campaign = self.campaign()?;
        let name = device::named(&self.device)?;
        device::knock(&name, &campaign.profile, self.limits.limits())?;
        let device = DeviceRecord::of(&self.device, &name, self.device_version.clone())
            .map_err(|reason| Failure::Input(format!("the device's file cannot be read: {reason}")))?;
        let mut out = terminal::output();
        writeln!(out, "certify {}, profile {}, level {}", self.device, campaign.profile.name, self.level)?;
        writeln!(out, "{}: radcomp's reading of its sources, not its maker's word", campaign.profile.title)?;
        let grade = match campaign.budget.grade {
            Grade::Binary64 => "binary64, β = 2⁻⁴⁰ × the largest number of each program",
            Grade::Resolution => "resolution, β = half the least input increment",
        };
        writeln!(
            out,
            "seed {}, {} generated programs, vectors and boundary triples; {grade}; δ = {} mm",
            campaign.seed, campaign.programs, campaign.budget.delta
        )?;
        out.flush()?;
        let bar = progress_bar(campaign.programs);
        let make = || name.open(&campaign.profile, self.limits.limits());
        let outcome = certify(&campaign, make, |done| bar.inc(done));
        bar.finish_and_clear();
        print(&mut out, &outcome, &campaign.profile, self.allow_unsupported)?;
        out.flush()?;
        let report = outcome.report(&device, Some(self.level), &campaign);
        if let Some(path) = &self.report {
            let unwritable = |reason| Failure::Input(format!("{} cannot be written: {reason}", path.display()));
            let file = fs::File::create(path).map_err(unwritable)?;
            report.write(BufWriter::new(file)).map_err(unwritable)?;
        }
        if let Some(path) = &self.junit {
            write(path, &junit(&report).map_err(Failure::Input)?)?;
        }
        if let Some(path) = &self.html {
            let file = self.report.as_ref().map_or("report.json".to_owned(), |path| path.display().to_string());
            write(path, &page(&report, &file).map_err(Failure::Input)?)?;
        }
        if let Some(folder) = &self.counterexamples {
            write_counterexamples(folder, &outcome, &report, &campaign.profile)?;
        }
        let unused = report.expected_failures.iter().filter(|waiver| waiver.programs == 0);
        let unused: Vec<_> = unused.map(|waiver| format!("{}: {}", waiver.clause.0, waiver.reason)).collect();
        if !unused.is_empty() {
            return Err(Failure::Input(format!("waivers that cover no failure\n{}", unused.join("\n"))));
        }
        Ok(if is_pass(&outcome, self.allow_unsupported) { Verdict::Green } else { Verdict::Red })
    }

    fn waivers(&self) -> Result<Waivers, Failure> {
        let Some(path) = &self.waivers else { return Ok(Waivers::default()) };
        let file = path.display();
        let text = fs::read_to_string(path).map_err(|reason| Failure::Input(format!("{file}: {reason}")))?;
        Waivers::parse(&text).map_err(|error| Failure::Input(format!("{file}: {error}")))
    }

    fn campaign(&self) -> Result<Campaign, Failure> {
        let profile = options::profile(&self.profile)?;
        let least = if self.level == 1 { Level::One } else { Level::Two }.programs();
        let programs = self.programs.unwrap_or(least);
        if programs < least {
            let level = self.level;
            return Err(Failure::Input(format!(
                "level {level} judges at least {least} programs; --programs can only raise that"
            )));
        }
        let increment = profile.machine.least_increment;
        Ok(Campaign {
            seed: self.seed,
            programs,
            budget: Budget {
                grade: match self.grade {
                    GradeName::Binary64 => Grade::Binary64,
                    GradeName::Resolution => Grade::Resolution,
                },
                least_increment: f64::from(increment.numerator) / f64::from(increment.denominator),
                delta: self.delta,
            },
            waivers: self.waivers()?,
            threads: self.jobs.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from)).clamp(1, 256),
            profile,
        })
    }
}

fn progress_bar(programs: u64) -> ProgressBar {
    let bar = ProgressBar::new(programs);
    if !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    // The template is a constant of the form that indicatif documents.
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} programs, {per_sec}, {eta} left") {
        bar.set_style(style);
    }
    bar
}

/// Whether a device has passed. One that supports nothing has not.
pub(super) fn is_pass(outcome: &Outcome, allow_unsupported: bool) -> bool {
    let tally = &outcome.tally;
    tally.red() == 0 && (tally.unsupported() == 0 || (allow_unsupported && tally.unsupported() < tally.programs))
}

/// Prints what came of a campaign.
pub(super) fn print(
    out: &mut dyn Write,
    outcome: &Outcome,
    profile: &Profile,
    allow_unsupported: bool,
) -> Result<(), Failure> {
    for failure in outcome.failures.iter().take(MOST_LINES) {
        writeln!(out, "{} {failure}", terminal::bold("FAIL"))?;
    }
    let (red, failed) = (outcome.tally.red(), outcome.tally.counts.fail);
    if failed > MOST_LINES as u64 {
        writeln!(out, "… and {} more failed programs", failed - MOST_LINES as u64)?;
    }
    for (number, broken) in outcome.broken.iter().take(MOST_LINES) {
        writeln!(out, "{} #{number} {}: {}", terminal::bold("MOVED"), broken.relation, broken.difference)?;
    }
    for (name, count, smallest) in outcome.groups.iter().take(8) {
        counterexample(out, name, *count, smallest, profile)?;
    }
    writeln!(out)?;
    writeln!(
        out,
        "{:<15}{:>10}{:>10}{:>11}{:>8}{:>10}{:>8}",
        "clause", "programs", "elements", "decisions", "alarms", "passed", "failed"
    )?;
    for (id, tally) in &outcome.tally.clauses {
        writeln!(
            out,
            "{id:<15}{:>10}{:>10}{:>11}{:>8}{:>10}{:>8}",
            tally.programs, tally.elements, tally.decisions, tally.alarms, tally.passed, tally.failed
        )?;
    }
    writeln!(out)?;
    writeln!(out, "{:<18}{:>10}{:>10}{:>10}", "decision", "negative", "zero", "positive")?;
    for (id, [negative, zero, positive]) in &outcome.tally.decisions {
        writeln!(out, "{id:<18}{negative:>10}{zero:>10}{positive:>10}")?;
    }
    // What the profile never asks is not missed.
    let reach = Reach::of(profile);
    let sides = outcome.tally.one_sided();
    let asked = sides.iter().filter(|(kind, _)| boundary::is_asked(*kind, reach));
    let missing: Vec<_> = asked.map(|(kind, side)| format!("{} ({side})", kind.id())).collect();
    if !missing.is_empty() {
        writeln!(out, "not exercised: {}", missing.join(", "))?;
    }
    writeln!(out)?;
    let tally = &outcome.tally;
    writeln!(out, "{} programs, {} blocks, {} corners", tally.programs, tally.blocks, tally.corners)?;
    writeln!(
        out,
        "{} programs also moved, mirrored, scaled, rotated, split and run backwards: {} relations broken",
        tally.moved, tally.broken
    )?;
    for (verdict, count) in &tally.verdicts {
        let note = match *verdict {
            "admissible" => " (the exact outcome of an input within β: a witness)",
            "admissible-without-witness" => " (another branch within the band)",
            "unsupported" => " (neither failed nor passed)",
            _ => "",
        };
        writeln!(out, "  {verdict}: {count}{note}")?;
    }
    if tally.counts.expected_failure > 0 {
        writeln!(out, "  of these, expected failures: {} (waived)", tally.counts.expected_failure)?;
    }
    if let Some(share) = tally.needed_share() {
        writeln!(
            out,
            "the witnesses found need at most {share:.3e} of the band β: the device passes with that share too"
        )?;
    }
    let verdict = match is_pass(outcome, allow_unsupported) {
        true => "PASS",
        false if red == 0 => "INCOMPLETE: the device does not support every program (--allow-unsupported accepts that)",
        false => "RED",
    };
    writeln!(out, "{}", terminal::bold(verdict))?;
    Ok(())
}

fn counterexample(
    out: &mut dyn Write,
    name: &str,
    count: u64,
    smallest: &Failed,
    profile: &Profile,
) -> Result<(), Failure> {
    writeln!(out)?;
    writeln!(out, "{} {name}: {count} programs; smallest, from {}:", terminal::bold("CAUSE"), smallest.name)?;
    writeln!(out, "  {smallest}")?;
    if let Judgement::Inadmissible(divergence) | Judgement::ForkLimit(divergence) = &smallest.verdict {
        writeln!(out, "  [{}] {}", divergence.clause, first_sentence(divergence.clause))?;
    }
    if let Some(safety) = &smallest.safety {
        writeln!(out, "  safety: {safety}")?;
    }
    match smallest.listing(profile) {
        Ok(listing) => {
            for line in listing.program.lines() {
                writeln!(out, "    {line}")?;
            }
            for line in listing.tool_table.lines().filter(|line| !line.is_empty()) {
                writeln!(out, "    ; tools: {line}")?;
            }
        }
        Err(reason) => writeln!(out, "    (no G-code for it: {reason})")?,
    }
    Ok(())
}

fn write_counterexamples(folder: &Path, outcome: &Outcome, report: &Report, profile: &Profile) -> Result<(), Failure> {
    let axes = Axes { plane: profile.machine.plane, x_words: profile.machine.x_words };
    fs::create_dir_all(folder)
        .map_err(|reason| Failure::Input(format!("{} cannot be made: {reason}", folder.display())))?;
    for (index, ((name, _, smallest), cause)) in outcome.groups.iter().zip(&report.causes).enumerate() {
        let picture = cause.case.as_ref().map(|case| comparison(case, &profile.parameters, axes, "c", name));
        if let Ok(listing) = smallest.listing(profile) {
            write(&folder.join(format!("{}.nc", index + 1)), &listing.program)?;
            write(&folder.join(format!("{}.tools.toml", index + 1)), &listing.tool_table)?;
        }
        if let Some(picture) = picture {
            write(&folder.join(format!("{}.svg", index + 1)), &picture)?;
        }
    }
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    fs::write(path, text).map_err(|reason| Failure::Input(format!("{} cannot be written: {reason}", path.display())))
}
