//! `radcomp check`.

use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};

use clap::Args;
use radcomp::certify::{Recorded, programs};
use radcomp::device::wire::Reply;
use radcomp::device::{Answer, DeviceFault};
use radcomp::report::{DeviceRecord, FileRecord, sha256_of_file};

use super::failure::{Failure, Verdict};
use super::judging::{Judging, Outputs};
use super::terminal;

/// Judge the answers to the requests of `radcomp gen`
#[derive(Debug, Args)]
#[command(after_help = "\
A program without an answer has failed. Nothing can be asked again, so no program
is moved, mirrored or made smaller, and the report is of no level.

Example:
  radcomp gen --profile seed-mill | my-control | radcomp check --profile seed-mill
  radcomp check --profile seed-mill answers.jsonl --html report.html --waivers waivers.toml

Exit status: 0 no red verdict; 1 red verdicts; 2 wrong usage or input.")]
pub struct Check {
    /// The answers, one a line; - reads the standard input
    #[arg(value_name = "FILE", default_value = "-")]
    file: String,

    #[command(flatten)]
    judging: Judging,

    /// How many generated programs were asked for
    #[arg(long, value_name = "COUNT", default_value = "24000")]
    programs: u64,

    /// The name of the device that answered, for the report; one that can be asked can be replayed
    #[arg(long, value_name = "NAME", default_value = "recorded")]
    device: String,

    /// The device's version, for the report
    #[arg(long, value_name = "VERSION")]
    device_version: Option<String>,

    #[command(flatten)]
    outputs: Outputs,
}

/// The most bytes of one answer.
const MOST_BYTES: u64 = 16 << 20;

impl Check {
    /// Judges the answers.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let campaign = self.judging.campaign(self.programs, 1)?;
        let mut answers = self.answers()?;
        let mut recorded = Recorded::new(&campaign);
        let grade = campaign.budget.grade;
        for (name, blocks) in programs(&campaign.profile, campaign.seed, campaign.programs, grade) {
            let missing = || Err(DeviceFault::NoAnswer("no line has this id".to_owned()));
            let answer = match answers.remove(&name) {
                None => missing(),
                Some(answer) => Reply { id: String::new(), answer }.within(blocks.len()).answer,
            };
            recorded.judge(&name, &blocks, answer);
        }
        let outcome = recorded.outcome();
        let report = outcome.report(&self.device()?, None, &campaign);
        let file = self.outputs.report.as_deref();
        let verdict = self.outputs.pages.finish(&mut terminal::output(), &outcome, &campaign, &report, file);
        if let Some(id) = answers.keys().min() {
            let count = answers.len();
            return Err(Failure::Input(format!(
                "{count} answers are for programs that were not asked, such as {id:?}; were the requests made with the same profile, seed, number of programs and grade?"
            )));
        }
        verdict
    }

    /// The device, by its name and the file of its answers.
    fn device(&self) -> Result<DeviceRecord, Failure> {
        let unreadable = |reason: io::Error| Failure::Input(format!("{} cannot be read: {reason}", self.file));
        let files = match &*self.file {
            "-" => Vec::new(),
            file => {
                let sha256 = sha256_of_file(file.as_ref()).map_err(unreadable)?;
                vec![FileRecord { file: file.to_owned(), sha256 }]
            }
        };
        Ok(DeviceRecord { name: self.device.clone(), version: self.device_version.clone(), files })
    }

    /// Every answer by its id.
    fn answers(&self) -> Result<HashMap<String, Result<Answer, DeviceFault>>, Failure> {
        let unreadable = |reason: io::Error| Failure::Input(format!("{} cannot be read: {reason}", self.file));
        let input: Box<dyn Read> = match &*self.file {
            "-" => Box::new(io::stdin()),
            file => Box::new(File::open(file).map_err(unreadable)?),
        };
        let mut input = BufReader::with_capacity(1 << 16, input);
        let mut answers = HashMap::new();
        let mut line = Vec::new();
        for number in 1_u64.. {
            line.clear();
            if input.by_ref().take(MOST_BYTES + 1).read_until(b'\n', &mut line).map_err(unreadable)? == 0 {
                break;
            }
            if line.len() as u64 > MOST_BYTES {
                return Err(Failure::Input(format!("line {number} is longer than {} MiB", MOST_BYTES >> 20)));
            }
            let reply = Reply::read(&line).map_err(|error| Failure::Input(format!("line {number}: {}", error.0)))?;
            let twice = || Err(DeviceFault::Garbled("two lines have this id".to_owned()));
            answers.entry(reply.id).and_modify(|answer| *answer = twice()).or_insert(reply.answer);
        }
        Ok(answers)
    }
}
