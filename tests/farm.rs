//! Campaigns that take long: in parts on several machines, until a time is up, interrupted.

#[path = "farm/limits.rs"]
mod limits;
#[path = "farm/resumed.rs"]
mod resumed;
#[path = "verify/schema.rs"]
mod schema;
#[path = "farm/shards.rs"]
mod shards;

use std::path::Path;
use std::process::{Command, Output};

use radcomp::certify::{Campaign, Waivers};
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::judge::{Budget, Grade};
use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Block, Parameters, Segment, clause};
use rug::Rational;

/// The command that cargo built for these tests.
const RADCOMP: &str = env!("CARGO_BIN_EXE_radcomp");

/// The implementation with faults of several kinds, so that a report has something to say.
struct Faulty;

impl Device for Faulty {
    fn name(&self) -> &str {
        "faulty"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answer = Builtin.answer(parameters, blocks)?;
        for step in &mut answer.steps {
            match &mut step.segment {
                Segment::Line { end } | Segment::Arc { end, .. } if step.clause == clause::TRC_CORNER_08 => {
                    end[0] += 1.5
                }
                // A point that a witness has: no failure.
                Segment::Line { end } if step.clause == clause::TRC_CORNER_06 => end[0] += 1e-12 * end[0].abs(),
                _ => {}
            }
        }
        if answer.alarm.is_some_and(|alarm| alarm.kind == AlarmKind::NoIntersection) {
            answer.alarm = None;
        }
        match blocks.len() % 13 {
            5 => Err(DeviceFault::Unsupported(format!("programs of {} blocks", blocks.len()))),
            7 => Err(DeviceFault::Crash("seven".to_owned())),
            _ => Ok(answer),
        }
    }
}

fn campaign(programs: u64) -> Campaign {
    Campaign {
        profile: Profile::builtin("yasnac-lx").expect("built in"),
        seed: 5,
        programs,
        budget: Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 },
        waivers: Waivers::parse("[[waiver]]\nclause = \"TRC-CORNER-08\"\nreason = \"known\"\n").expect("waivers"),
        threads: 2,
    }
}

/// Runs radcomp in a folder.
fn radcomp(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(RADCOMP).args(arguments).current_dir(folder).output().expect("radcomp runs")
}

fn text(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}
