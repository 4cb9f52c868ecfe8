//! `radcomp verify-witness`, end to end.

use std::fs;

use assert_cmd::Command;
use radcomp::report::Report;

use crate::moved;
use crate::reports::{answer, by_hand, inner, line, report, with_witness};

/// The command's exit status, standard output and error output on a report file of this text.
fn command(text: &str) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("report.json");
    fs::write(&file, text).unwrap();
    let output = Command::cargo_bin("radcomp").unwrap().arg("verify-witness").arg(&file).output().unwrap();
    let read = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), read(output.stdout), read(output.stderr))
}

#[test]
fn the_command_tells_what_it_finds() {
    let text = |report: &Report| serde_json::to_string(report).unwrap();
    let good = report(vec![with_witness(&inner(), &moved(4), &answer(&moved(4)))]);
    let (status, out, _) = command(&text(&good));
    assert_eq!(status, Some(0), "{out}");
    assert!(out.contains("admissible: 1 confirmed\n") && out.ends_with("\nCONFIRMED\n"), "{out}");
    let bad = report(vec![with_witness(&inner(), &moved(6), &answer(&moved(6)))]);
    let (status, out, _) = command(&text(&bad));
    assert_eq!(status, Some(1), "{out}");
    assert!(out.contains("NOT CONFIRMED by hand admissible: a number of the witness is 0.0006 mm"), "{out}");
}

#[test]
fn the_command_says_why_a_report_cannot_be_read() {
    let good = serde_json::to_string_pretty(&report(vec![by_hand("exact", &[line(1, 2)], &answer(&[line(1, 2)]))]));
    let good = good.unwrap();
    let number = good.replace("\"1\"", "\"1,5\"");
    let other_format = good.replacen("\"format\": 1", "\"format\": 2", 1);
    let place = number.lines().position(|line| line.contains("1,5")).expect("the number") + 1;
    for (text, complaint) in [
        ("", "not a report: EOF"),
        ("{}", "missing field `format`"),
        (
            &*number,
            &*format!("\"1,5\" is not an exact number: a decimal such as \"-12.5\", or \"p/q\" at line {place} "),
        ),
        (&*other_format, "a report of format 2; this radcomp reads format 1"),
        (&*good.replace("TRC-MODE-01", "TRC-MODE-99"), "\"TRC-MODE-99\" is not the name of a clause at line"),
    ] {
        let (status, _, error) = command(text);
        assert_eq!(status, Some(2), "{error}");
        assert!(error.contains(complaint) && error.contains("report.json"), "{error}");
    }
    let output = Command::cargo_bin("radcomp").unwrap().args(["verify-witness", "/nowhere.json"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("there is no file /nowhere.json"));
}
