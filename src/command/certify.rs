//! `radcomp certify`.

use std::fs;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use radcomp::certify::{Campaign, Checkpoint, Course, Level, Outcome, Shard, campaign_of, certify_on};
use radcomp::explain::Axes;
use radcomp::judge::Grade;
use radcomp::plot::comparison;
use radcomp::report::{DeviceRecord, Report};
use radcomp_spec::profile::Profile;

use super::device::{self, DeviceLimits};
use super::failure::{Failure, Verdict};
use super::judging::{Judging, Outputs, write};
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

    #[command(flatten)]
    judging: Judging,

    /// How much is judged: 1 takes seconds, 2 minutes, 3 as long as --for says
    #[arg(long, short, default_value = "1", value_parser = clap::value_parser!(u8).range(1..=3))]
    level: u8,

    /// Judge this many generated programs, at least as many as the level asks for
    #[arg(long, value_name = "COUNT")]
    programs: Option<u64>,

    /// Go on with further programs until so much time has passed, such as 8h or 90m; the report says how many, and
    /// --programs with that number gives the same report
    #[arg(long = "for", value_name = "TIME", value_parser = humantime::parse_duration)]
    time: Option<Duration>,

    /// Judge the I-th of N parts of the programs; `radcomp merge` puts the reports of all parts together
    #[arg(long, value_name = "I/N", value_parser = Shard::parse, conflicts_with = "time")]
    shard: Option<Shard>,

    /// Where the work that is done is kept, for the same command to go on from if this one is interrupted; by default
    /// beside the report, with .checkpoint at the end of its name
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,

    /// Threads; the result does not depend on their number
    #[arg(long, short, value_name = "COUNT")]
    jobs: Option<usize>,

    #[command(flatten)]
    outputs: Outputs,

    /// Write each smallest counterexample into this folder, as a program with its tool table and a picture
    #[arg(long, value_name = "FOLDER")]
    counterexamples: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  radcomp certify builtin --profile yasnac-lx --level 1
  radcomp certify 'pipe:python3 adapter.py' --profile seed-mill --timeout 60
  radcomp certify builtin --profile my-control.toml --level 2 --seed 20 --report report.json
  radcomp certify lib:control.so --profile seed-mill --level 3 --for 8h --report report.json
  radcomp certify builtin --profile seed-mill --level 2 --shard 3/8 --report shard-3.json

Exit status: 0 no red verdict; 1 red verdicts; 2 wrong usage or input.";

impl Certify {
    /// Runs the campaign.
    pub fn execute(self) -> Result<Verdict, Failure> {
        let campaign = self.judging.campaign(self.programs()?, self.threads())?;
        let name = device::named(&self.device)?;
        device::knock(&name, &campaign.profile, self.limits.limits())?;
        let device = DeviceRecord::of(&self.device, &name, self.device_version.clone())
            .map_err(|reason| Failure::Input(format!("the device's file cannot be read: {reason}")))?;
        let checkpoint = self.checkpoint(&device, &campaign)?;
        let mut out = terminal::output();
        self.introduce(&mut out, &campaign)?;
        let before = checkpoint.as_ref().map_or(0, Checkpoint::programs);
        if before > 0 {
            writeln!(out, "going on after {before} programs that were judged before")?;
        }
        out.flush()?;
        let bar = progress_bar(self.time.is_none().then_some(campaign.programs));
        let course = Course { shard: self.shard, time: self.time, checkpoint: checkpoint.as_ref() };
        let make = || name.open(&campaign.profile, self.limits.limits());
        let (start, judged) = (Instant::now(), AtomicU64::new(0));
        let (outcome, shard) = certify_on(&campaign, &course, make, |done| {
            bar.inc(done);
            judged.fetch_add(done, Relaxed);
        });
        bar.finish_and_clear();
        writeln!(out, "{}", speed(judged.load(Relaxed) - before, start.elapsed()))?;
        if self.time.is_some() {
            writeln!(out, "{} generated programs in the time", outcome.programs)?;
        }
        let report = Report { shard, ..outcome.report(&device, Some(self.level), &campaign) };
        if let Some(folder) = &self.counterexamples {
            write_counterexamples(folder, &outcome, &report, &campaign.profile)?;
        }
        let file = self.outputs.report.as_deref();
        let verdict = self.outputs.pages.finish(&mut out, &outcome, &campaign, &report, file);
        if let Some(checkpoint) = checkpoint {
            let told = |error| Failure::Input(format!("the checkpoint could not be kept: {error}"));
            checkpoint.remove().map_err(told)?;
        }
        verdict
    }

    fn introduce(&self, out: &mut dyn Write, campaign: &Campaign) -> Result<(), Failure> {
        let part = self.shard.map_or_else(String::new, |shard| format!(", shard {}/{}", shard.number, shard.of));
        writeln!(out, "certify {}, profile {}, level {}{part}", self.device, campaign.profile.name, self.level)?;
        writeln!(out, "{}: radcomp's reading of its sources, not its maker's word", campaign.profile.title)?;
        let grade = match campaign.budget.grade {
            Grade::Binary64 => "binary64, β = 2⁻⁴⁰ × the largest number of each program",
            Grade::Resolution => "resolution, β = half the least input increment",
        };
        let more = self
            .time
            .map_or_else(String::new, |time| format!(" and further ones for {}", humantime::format_duration(time)));
        writeln!(
            out,
            "seed {}, {} generated programs{more}, vectors and boundary triples; {grade}; δ = {} mm",
            campaign.seed, campaign.programs, campaign.budget.delta
        )?;
        Ok(())
    }

    /// How many generated programs are judged, those apart that the time allows.
    fn programs(&self) -> Result<u64, Failure> {
        let level = self.level;
        let least = Level::of(level).map(Level::programs);
        // The option allows no other level.
        let least = least.ok_or_else(|| Failure::Input(format!("there is no level {level}")))?;
        if level == 3 && self.time.is_none() && self.programs.is_none() && self.shard.is_none() {
            let how = "level 3 takes --for, such as --for 8h, or --programs with the number of such a run";
            return Err(Failure::Input(how.to_owned()));
        }
        let programs = self.programs.unwrap_or(least);
        if programs < least {
            return Err(Failure::Input(format!(
                "level {level} judges at least {least} programs; --programs can only raise that"
            )));
        }
        Ok(programs)
    }

    fn threads(&self) -> usize {
        self.jobs.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from)).clamp(1, 256)
    }

    /// The checkpoint, if there is a place for it.
    fn checkpoint(&self, device: &DeviceRecord, campaign: &Campaign) -> Result<Option<Checkpoint>, Failure> {
        let beside = |report: &PathBuf| {
            let mut name = report.clone().into_os_string();
            name.push(".checkpoint");
            PathBuf::from(name)
        };
        let file = self.checkpoint.clone().or_else(|| self.outputs.report.as_ref().map(beside));
        let Some(file) = file else { return Ok(None) };
        let report = Outcome::default().report(device, Some(self.level), campaign);
        let mut name = campaign_of(&Report { generated_programs: campaign.programs, ..report });
        let shard = self.shard.map_or_else(|| "none".to_owned(), |shard| format!("{}/{}", shard.number, shard.of));
        let time = self.time.map_or_else(|| "none".to_owned(), |time| humantime::format_duration(time).to_string());
        name.extend([("shard".to_owned(), shard), ("time".to_owned(), time)]);
        Checkpoint::open(&file, name).map(Some).map_err(Failure::Input)
    }
}

/// How fast programs were judged, the search for smaller ones included.
fn speed(programs: u64, time: Duration) -> String {
    let seconds = time.as_secs_f64();
    format!("{programs} programs judged in {seconds:.1} s, {:.0} a second", programs as f64 / seconds.max(1e-3))
}

/// The bar, of so many programs if they are known.
fn progress_bar(programs: Option<u64>) -> ProgressBar {
    let bar = programs.map_or_else(ProgressBar::no_length, ProgressBar::new);
    if !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    let template = match programs {
        Some(_) => "{bar:40} {pos}/{len} programs, {per_sec}, {eta} left",
        None => "{spinner} {pos} programs, {per_sec}, {elapsed}",
    };
    // The templates are constants of the form that indicatif documents.
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar
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
