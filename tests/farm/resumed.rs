//! A campaign that is killed goes on where it stopped.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use radcomp::certify::{Checkpoint, Course, certify, certify_on};
use radcomp::report::{DeviceRecord, Report};

use super::{Faulty, RADCOMP, campaign, radcomp, text};

const CERTIFY: [&str; 7] = ["certify", "builtin", "--profile", "yasnac-lx", "--jobs", "2", "--report"];

/// Starts a certification, and kills it when its checkpoint has been written anew so many times.
fn killed(folder: &Path, report: &str, writings: usize) {
    let mut child =
        Command::new(RADCOMP).args(CERTIFY).arg(report).current_dir(folder).stdout(Stdio::null()).spawn().unwrap();
    let file = folder.join(format!("{report}.checkpoint"));
    let written = || fs::metadata(&file).and_then(|metadata| metadata.modified()).ok();
    let (mut last, start) = (written(), Instant::now());
    for _ in 0..writings {
        while written() == last {
            assert!(child.try_wait().unwrap().is_none(), "it ended before its checkpoint was written");
            assert!(start.elapsed() < Duration::from_secs(120), "no checkpoint");
            sleep(Duration::from_millis(5));
        }
        last = written();
    }
    // SIGKILL.
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn a_killed_run_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let whole = radcomp(folder, &[&CERTIFY[..], &["whole.json"]].concat());
    assert!(whole.status.success(), "{}", text(&whole));
    assert!(!folder.join("whole.json.checkpoint").exists());
    killed(folder, "resumed.json", 1);
    // And once more.
    killed(folder, "resumed.json", 1);
    assert!(folder.join("resumed.json.checkpoint").exists() && !folder.join("resumed.json").exists());
    let other = radcomp(folder, &[&CERTIFY[..], &["resumed.json", "--seed", "2"]].concat());
    assert_eq!(other.status.code(), Some(2));
    assert!(text(&other).contains("of another campaign: seed 1 there, 2 here"), "{}", text(&other));
    let resumed = radcomp(folder, &[&CERTIFY[..], &["resumed.json"]].concat());
    assert!(resumed.status.success() && text(&resumed).contains("going on after "), "{}", text(&resumed));
    let read = |file: &str| fs::read_to_string(folder.join(file)).unwrap();
    assert_eq!(read("resumed.json"), read("whole.json"));
    assert!(!folder.join("resumed.json.checkpoint").exists());
}

#[test]
fn a_damaged_checkpoint_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("r.json.checkpoint"), "{\"format\": 1, \"campai").unwrap();
    let output = radcomp(folder.path(), &[&CERTIFY[..], &["r.json"]].concat());
    assert!(output.status.code() == Some(2) && text(&output).contains("not a checkpoint"), "{}", text(&output));
}

/// A device that brings the whole run down after so many answers.
struct Bomb(u64);

impl radcomp::device::Device for Bomb {
    fn name(&self) -> &str {
        "faulty"
    }

    fn answer(
        &mut self,
        parameters: &radcomp_spec::Parameters,
        blocks: &[radcomp_spec::Block<rug::Rational>],
    ) -> Result<radcomp::device::Answer, radcomp::device::DeviceFault> {
        Faulty.answer(parameters, blocks)
    }

    fn answer_all(
        &mut self,
        parameters: &radcomp_spec::Parameters,
        programs: &[Vec<radcomp_spec::Block<rug::Rational>>],
    ) -> Vec<Result<radcomp::device::Answer, radcomp::device::DeviceFault>> {
        // A second lets the checkpoint be written.
        sleep(Duration::from_millis(40));
        self.0 = self.0.checked_sub(1).expect("the end of this run");
        programs.iter().map(|blocks| self.answer(parameters, blocks)).collect()
    }
}

/// Failures, cases and counts of before come back, and a panic of one thread ends the run.
#[test]
fn what_failed_before_is_in_the_report() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("checkpoint");
    let campaign = campaign(3000);
    let name = vec![("campaign".to_owned(), "of this test".to_owned())];
    let checkpoint = Checkpoint::open(&file, name.clone()).unwrap();
    let course = Course { checkpoint: Some(&checkpoint), ..Course::default() };
    let ended =
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| certify_on(&campaign, &course, || Bomb(28), |_| {})));
    assert!(ended.is_err());
    let checkpoint = Checkpoint::open(&file, name).unwrap();
    assert!(checkpoint.programs() > 500, "{}", checkpoint.programs());
    let course = Course { checkpoint: Some(&checkpoint), ..Course::default() };
    let (outcome, _) = certify_on(&campaign, &course, || Faulty, |_| {});
    let report = |outcome: radcomp::certify::Outcome| -> Report {
        outcome.report(&DeviceRecord::named("faulty"), None, &campaign)
    };
    assert_eq!(report(outcome), report(certify(&campaign, || Faulty, |_| {})));
}
