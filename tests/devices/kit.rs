//! The adapters to start from, and what `radcomp ping` says of devices.

use std::io::Write;
use std::process::{Command, Stdio};

use radcomp::device::ping::{Finding, ping};
use radcomp::device::pipe::Pipe;
use radcomp::device::wire::{Asked, PROTOCOL};
use radcomp::device::{Builtin, Device};

use super::{RADCOMP, hasty, limits, profile, repository};

fn wrong(device: &mut dyn Device) -> Vec<Finding> {
    ping(device, &profile()).into_iter().filter(|finding| finding.result.is_err()).collect()
}

/// What ping says of a device with a fault of `clumsy.py`.
fn told(fault: &str) -> String {
    let command = format!("exec python3 '{}' {fault}", repository("tests/devices/clumsy.py"));
    let limits = if fault == "silent" { hasty() } else { limits() };
    let findings = wrong(&mut Pipe::shell(&command, &profile(), limits));
    findings.into_iter().filter_map(|finding| finding.result.err()).collect::<Vec<_>>().join("\n")
}

/// What an adapter must not take for something else: a request of another protocol, and fields of blocks that it does not
/// know.
#[track_caller]
fn says_what_it_does_not_know(command: &str) {
    let line = |number: u64, block: &str| {
        format!(r#"{{"radcomp":{number},"id":"a","profile":{{}},"program":null,"tools":{{}},"blocks":[{block}]}}"#)
    };
    let requests = [
        line(PROTOCOL, r#"{"movement":"none"}"#),
        line(PROTOCOL + 1, r#"{"movement":"none"}"#),
        line(PROTOCOL, r#"{"movement":"none","vector":["1","0"]}"#),
        line(PROTOCOL, r#"{"movement":{"held-vector":{"end":["1","0"]}}}"#),
    ];
    let mut child =
        Command::new("sh").args(["-c", command]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all((requests.join("\n") + "\n").as_bytes()).unwrap();
    let told = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
    let unsupported: Vec<_> = told.lines().map(|answer| answer.contains("unsupported")).collect();
    assert_eq!(unsupported, [false, true, true, true], "{told}");
}

#[test]
fn the_python_kit_works_as_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let written = Command::new(RADCOMP).args(["device-kit", "python", "-o"]).arg(folder.path()).status().unwrap();
    assert!(written.success());
    let command = format!("python3 '{}/adapter.py'", folder.path().display());
    assert_eq!(wrong(&mut Pipe::shell(&command, &profile(), limits())), []);
    says_what_it_does_not_know(&command);
    let again = Command::new(RADCOMP).args(["device-kit", "python", "-o"]).arg(folder.path()).output().unwrap();
    assert_eq!(again.status.code(), Some(2));
    assert!(String::from_utf8(again.stderr).unwrap().contains("is there already"));
}

#[test]
fn the_rust_kit_works_as_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let written = Command::new(RADCOMP).args(["device-kit", "rust", "-o"]).arg(folder.path()).status().unwrap();
    assert!(written.success());
    // The crates that this workspace is built of are there: no network is needed.
    let lock = repository("Cargo.lock");
    std::fs::copy(lock, folder.path().join("Cargo.lock")).unwrap();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--quiet", "--offline", "--target-dir"])
        .arg(folder.path().join("target"))
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let command = format!("'{}/target/debug/adapter'", folder.path().display());
    assert_eq!(wrong(&mut Pipe::shell(&command, &profile(), limits())), []);
    says_what_it_does_not_know(&command);
}

#[test]
fn the_c_kit_works_as_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let written = Command::new(RADCOMP).args(["device-kit", "c", "-o"]).arg(folder.path()).status().unwrap();
    assert!(written.success());
    let built = Command::new("cc")
        .args(["-shared", "-fPIC", "device.c", "-o", "device.so"])
        .current_dir(folder.path())
        .status();
    assert!(built.unwrap().success());
    let output = Command::new(RADCOMP).args(["ping", "lib:device.so"]).current_dir(folder.path()).output().unwrap();
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && told.contains("compensation: not supported"), "{told}");
}

#[test]
fn the_implementation_is_well() {
    assert_eq!(wrong(&mut Builtin), []);
}

#[test]
fn ping_says_in_plain_words_what_is_wrong() {
    for (fault, words) in [
        ("inches", "it looks like inches"),
        ("swapped", "the two coordinates are in the wrong order"),
        ("relative", "it looks like a distance from the start of the move"),
        ("from-one", "blocks are counted from 0"),
        ("centre", "it is given from the start of the arc, and has to be absolute"),
        ("sense", "a G03 arc is answered as cw"),
        ("no-hold", "has to be answered by a hold"),
        ("never-rapid", "\"rapid\" has to be true for the G00 move"),
        ("other-side", "G41 runs on the right of the contour"),
        ("half", "the radius was taken for a diameter"),
        ("ignores", "compensation was not switched on"),
        ("forgetful", "is answered otherwise when it is asked again, alone"),
        ("log", "messages belong on the standard error output"),
        ("silent", "no answer within 3 s"),
    ] {
        let told = told(fault);
        assert!(told.contains(words), "{fault}: {told}");
    }
}

#[test]
fn a_request_of_another_protocol_is_refused() {
    for number in [PROTOCOL - 1, PROTOCOL + 1] {
        let line = format!(r#"{{"radcomp":{number},"id":"a","profile":{{}},"blocks":[]}}"#);
        let error = Asked::read(line.as_bytes()).unwrap_err();
        assert!(error.contains(&format!("protocol {number}")), "{error}");
    }
}
