//! A campaign in parts.

use std::fs;
use std::path::Path;
use std::process::{Child, Command};

use radcomp::certify::{Course, Shard, certify, certify_on, merge};
use radcomp::report::{DeviceRecord, Report, SCHEMA};

use super::schema::violation;
use super::{Faulty, RADCOMP, campaign, radcomp, text};

/// Enough for more failed programs than a report keeps.
const PROGRAMS: u64 = 1300;

fn shard(number: u64, of: u64, seed: u64) -> (String, Report) {
    let campaign = radcomp::certify::Campaign { seed, ..campaign(PROGRAMS) };
    let course = Course { shard: Some(Shard { number, of }), ..Course::default() };
    let (outcome, shard) = certify_on(&campaign, &course, || Faulty, |_| {});
    let report = outcome.report(&DeviceRecord::named("faulty"), None, &campaign);
    // As it is read from a file.
    let mut bytes = Vec::new();
    Report { shard, ..report }.write(&mut bytes).unwrap();
    (format!("{number}.json"), Report::parse(&String::from_utf8(bytes).unwrap()).unwrap())
}

fn written(report: &Report) -> String {
    let mut bytes = Vec::new();
    report.write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn the_parts_make_the_report_of_the_whole() {
    let campaign = campaign(PROGRAMS);
    let outcome = certify(&campaign, || Faulty, |_| {});
    let whole = outcome.report(&DeviceRecord::named("faulty"), None, &campaign);
    assert!(
        whole.cases_left_out > 0 && whole.causes.len() >= 2 && whole.counts.expected_failure > 0,
        "{:?}",
        whole.counts
    );
    assert!(!whole.tally.unsupported.is_empty() && whole.shard.is_none());
    let schema = serde_json::from_str(SCHEMA).unwrap();
    for of in [1, 3, 7] {
        // In any order.
        let parts: Vec<_> = (1..=of).rev().map(|number| shard(number, of, 5)).collect();
        assert_eq!(violation(&schema, &serde_json::to_value(&parts[0].1).unwrap()), None);
        assert!(of == 1 || parts[0].1.tally.programs < whole.tally.programs);
        let (_, merged, report) = merge(parts).unwrap();
        assert_eq!(written(&report), written(&whole), "{of} parts");
        assert_eq!(merged.failures, outcome.failures);
    }
}

#[track_caller]
fn refused(parts: Vec<(String, Report)>, told: &[&str]) {
    let reason = merge(parts).unwrap_err();
    assert!(told.iter().all(|word| reason.contains(word)), "{reason}");
}

#[test]
fn parts_that_do_not_fit_are_refused_by_name() {
    let [one, two] = [1, 2].map(|number| shard(number, 2, 5));
    let changed = |change: &dyn Fn(&mut Report)| {
        let (name, mut report) = two.clone();
        change(&mut report);
        vec![one.clone(), (name, report)]
    };
    refused(vec![one.clone(), shard(2, 2, 6)], &["1.json and 2.json", "seed 5", "6"]);
    refused(changed(&|report| report.profile_sha256 = "0".repeat(64)), &["2.json", "profile"]);
    refused(changed(&|report| report.device = "other".to_owned()), &["2.json", "device faulty", "other"]);
    refused(changed(&|report| report.radcomp = "0.0.9".to_owned()), &["2.json", "suite version", "0.0.9"]);
    refused(changed(&|report| report.commit = "1234".to_owned()), &["2.json", "suite version", "1234"]);
    refused(changed(&|report| report.generated_programs += 1), &["2.json", "programs 1300"]);
    refused(changed(&|report| report.tally.programs += 1), &["2.json", "its counts"]);
    refused(changed(&|report| report.shard = None), &["2.json is not the report of a shard"]);
    refused(changed(&|report| report.expected_failures.clear()), &["2.json", "waivers"]);
    refused(vec![one.clone()], &["no report of shard 2/2"]);
    refused(vec![one.clone(), ("again.json".to_owned(), one.1.clone())], &["1.json and again.json", "both", "1/2"]);
    refused(vec![one.clone(), shard(2, 3, 5)], &["2.json is of shard 2/3"]);
    refused(Vec::new(), &["no report"]);
}

/// The line of an example's file that runs `shard.sh`.
fn line(file: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/farm");
    let text = fs::read_to_string(format!("{folder}/{file}")).unwrap();
    let line = text.lines().map(str::trim).find(|line| line.starts_with("sh shard.sh")).expect("a line").to_owned();
    line.replace("shard.sh", &format!("{folder}/shard.sh"))
}

fn start(line: &str, reports: &Path, environment: &[(&str, String)]) -> Child {
    let bin = Path::new(RADCOMP).parent().unwrap().display();
    let path = format!("{bin}:{}", std::env::var("PATH").unwrap());
    let mut command = Command::new("sh");
    command.args(["-c", line]).env("PATH", path).env("REPORTS", reports).stdout(std::process::Stdio::null());
    command
        .envs([("PROFILE", "seed-mill"), ("LEVEL", "1")])
        .envs(environment.iter().map(|(name, value)| (name, value)));
    command.spawn().unwrap()
}

/// What the farm's machines run, as processes of this one.
#[test]
fn the_examples_for_farms_give_what_one_run_gives() {
    let folder = tempfile::tempdir().unwrap();
    let run = radcomp(folder.path(), &["certify", "builtin", "--profile", "seed-mill", "--report", "whole.json"]);
    assert!(run.status.success(), "{}", text(&run));
    let whole = fs::read_to_string(folder.path().join("whole.json")).unwrap();
    for (file, index, first, count) in [
        ("slurm.sh", "SLURM_ARRAY_TASK_ID", 1, "SLURM_ARRAY_TASK_COUNT"),
        ("kubernetes.yaml", "JOB_COMPLETION_INDEX", 0, "PARTS"),
    ] {
        let reports = folder.path().join(file);
        let of = 3;
        let environment = |number: u64| [(index, number.to_string()), (count, of.to_string())];
        let children: Vec<_> = (first..first + of).map(|n| start(&line(file), &reports, &environment(n))).collect();
        for mut child in children {
            assert!(child.wait().unwrap().success(), "{file}");
        }
        let parts: Vec<_> = (1..=of).map(|number| format!("{file}/shard-{number}.json")).collect();
        let parts: Vec<_> = parts.iter().map(String::as_str).collect();
        let merged = radcomp(folder.path(), &[&["merge"], &parts[..], &["-o", "merged.json"]].concat());
        assert!(merged.status.success(), "{}", text(&merged));
        assert_eq!(fs::read_to_string(folder.path().join("merged.json")).unwrap(), whole, "{file}");
        let missing = radcomp(folder.path(), &[&["merge"], &parts[1..], &["-o", "none.json"]].concat());
        assert!(missing.status.code() == Some(2) && text(&missing).contains("no report of shard 1/3"));
        let certificate =
            radcomp(folder.path(), &["certificate", parts[0], "--make-key", "k.pem", "--output", "c.json"]);
        assert!(text(&certificate).contains("of a part of the campaign"), "{}", text(&certificate));
    }
}
