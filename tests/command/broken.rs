//! Input that is not what it should be, and outputs that go away.

use std::io::Read;
use std::process::{Command, Stdio};

use super::{complaint, is_short, mill, radcomp};

#[test]
fn files_that_are_not_there_are_told_in_a_line() {
    for subcommand in ["run", "explain"] {
        let missing = complaint(radcomp(&[subcommand, "no.nc", "-p", "seed-mill"]), 2);
        assert_eq!(missing, "error: there is no file no.nc\n");
        let folder = complaint(radcomp(&[subcommand, "examples", "-p", "seed-mill"]), 2);
        assert_eq!(folder, "error: examples is a directory, not a file\n");
        let tools = complaint(radcomp(&[subcommand, "examples/first.nc", "-p", "seed-mill", "-t", "no.toml"]), 2);
        assert_eq!(tools, "error: there is no file no.toml\n");
    }
}

#[test]
fn an_unknown_profile_suggests_near_names() {
    let near = complaint(radcomp(&["run", "examples/first.nc", "-p", "seedmill"]), 2);
    assert!(near.contains("there is no profile seedmill; did you mean seed-mill?"), "{near}");
    let far = complaint(radcomp(&["profiles", "fanuc"]), 2);
    assert!(far.contains("built in are ") && far.contains("yasnac-lx"), "{far}");
    assert!(complaint(radcomp(&["profiles", "no.toml"]), 2).contains("there is no file no.toml"));
    assert!(complaint(radcomp(&["profiles", "examples"]), 2).contains("is a directory"));
}

#[test]
fn binary_files_are_refused_in_a_few_lines() {
    let binary = std::fs::read(assert_cmd::cargo::cargo_bin("radcomp")).unwrap();
    let random: Vec<u8> = (0..100_000_u32).map(|index| (index.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    for garbage in [&binary[..200_000], &random, &[0; 10_000], b"\xff\xfe", &[b'X'; 1_000_000], b"\r\r\r"] {
        for subcommand in ["run", "explain"] {
            let mut command = radcomp(&[subcommand, "-", "-p", "seed-mill"]);
            let output = command.write_stdin(garbage).assert().get_output().clone();
            let complaint = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 2)), "{complaint}");
            assert!(!complaint.contains("panicked") && is_short(&complaint), "{complaint}");
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tools.toml");
    std::fs::write(&path, &binary[..1000]).unwrap();
    let tools = complaint(radcomp(&["run", "examples/first.nc", "-p", "seed-mill", "-t", path.to_str().unwrap()]), 2);
    assert!(tools.contains("is not text"), "{tools}");
}

#[test]
fn a_refused_line_is_drawn_with_a_caret_after_the_path_before_it() {
    let output = mill("run", &[], "G01 X10 F1\nN20 X20 Q5\n").assert().code(2).get_output().clone();
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(complaint.contains("N20 X20 Q5") && complaint.contains('^'), "{complaint}");
    assert!(String::from_utf8(output.stdout).unwrap().contains("X     10.000000"));
}

#[test]
fn no_colours_leave_the_command_through_a_pipe() {
    let output = mill("explain", &[], "G41 D1 G01 X10 F1\nG02 X20 R1\n").assert().code(1).get_output().clone();
    assert!(!output.stdout.contains(&0x1b) && !output.stderr.contains(&0x1b));
}

#[test]
fn a_broken_pipe_is_no_fault() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("long.nc");
    let lines: String = (0..50_000).map(|index| format!("G01 X{index} F1\n")).collect();
    std::fs::write(&path, lines).unwrap();
    for subcommand in [&["run"][..], &["run", "-f", "json"], &["explain"]] {
        let mut child = Command::new(assert_cmd::cargo::cargo_bin("radcomp"))
            .args(subcommand)
            .args([path.to_str().unwrap(), "-p", "seed-mill"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut start = [0; 100];
        child.stdout.take().unwrap().read_exact(&mut start).unwrap();
        let mut complaint = String::new();
        child.stderr.take().unwrap().read_to_string(&mut complaint).unwrap();
        assert_eq!((child.wait().unwrap().code(), &*complaint), (Some(0), ""));
    }
}
