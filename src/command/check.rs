//! `radcomp check`.

use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};

use clap::Args;
use radcomp::certify::{Campaign, Recorded, Waivers, programs};
use radcomp::device::wire::Reply;
use radcomp::device::{Answer, DeviceFault};
use radcomp::judge::{Budget, Grade};

use super::failure::{Failure, Verdict};
use super::{certify, options, terminal};

/// Judge the answers to the requests of `radcomp gen`
#[derive(Debug, Args)]
#[command(after_help = "\
A program without an answer has failed. Nothing can be asked again, so no program
is moved, mirrored or made smaller.

Example:
  radcomp gen --profile seed-mill | my-control | radcomp check --profile seed-mill

Exit status: 0 no red verdict; 1 red verdicts; 2 wrong usage or input.")]
pub struct Check {
    /// The answers, one a line; - reads the standard input
    #[arg(value_name = "FILE", default_value = "-")]
    file: String,

    /// The control that the requests were made for
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    profile: String,

    /// How many generated programs were asked for
    #[arg(long, value_name = "COUNT", default_value = "24000")]
    programs: u64,

    /// The seed that the requests were made with
    #[arg(long, default_value = "1")]
    seed: u64,

    /// How far a point may lie from where its branch puts it, in millimetres
    #[arg(long, value_name = "MM", default_value = "0.000001", value_parser = certify::delta)]
    delta: f64,

    /// Do not fail for programs that the device says it does not support
    #[arg(long)]
    allow_unsupported: bool,
}

/// The most bytes of one answer.
const MOST_BYTES: u64 = 16 << 20;

impl Check {
    /// Judges the answers.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let profile = options::profile(&self.profile)?;
        let increment = profile.machine.least_increment;
        let campaign = Campaign {
            seed: self.seed,
            programs: self.programs,
            budget: Budget {
                grade: Grade::Binary64,
                least_increment: f64::from(increment.numerator) / f64::from(increment.denominator),
                delta: self.delta,
            },
            waivers: Waivers::default(),
            threads: 1,
            profile,
        };
        let mut answers = self.answers()?;
        let mut recorded = Recorded::new(&campaign);
        for (name, blocks) in programs(&campaign.profile, self.seed, self.programs) {
            let missing = || Err(DeviceFault::NoAnswer("no line has this id".to_owned()));
            let answer = match answers.remove(&name) {
                None => missing(),
                Some(answer) => Reply { id: String::new(), answer }.within(blocks.len()).answer,
            };
            recorded.judge(&name, blocks, answer);
        }
        let outcome = recorded.outcome();
        let mut out = terminal::output();
        certify::print(&mut out, &outcome, &campaign.profile, self.allow_unsupported)?;
        out.flush()?;
        if let Some(id) = answers.keys().min() {
            let count = answers.len();
            return Err(Failure::Input(format!(
                "{count} answers are for programs that were not asked, such as {id:?}; were the requests made with the same profile, seed and number of programs?"
            )));
        }
        Ok(if certify::is_pass(&outcome, self.allow_unsupported) { Verdict::Green } else { Verdict::Red })
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
