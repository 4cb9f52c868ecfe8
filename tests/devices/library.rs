//! Shared libraries as devices, and the C interface in C: the examples are built with `cc` and run.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use radcomp::certify::Outcome;
use radcomp::device::library::{Library, hosted};
use radcomp::device::ping::ping;
use radcomp::device::{Builtin, Device};

use super::{RADCOMP, campaign, hasty, limits, profile, repository};

const PROGRAMS: u64 = 300;

/// The folder of the C interface, built as a firmware links it: without std.
static FIRMWARE: LazyLock<PathBuf> = LazyLock::new(|| {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("firmware");
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(["build", "--quiet", "--offline", "-p", "radcomp-c", "--profile", "firmware", "--features", "firmware"])
        .arg("--target-dir")
        .arg(&target)
        .current_dir(repository(""))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    target.join("firmware")
});

/// What `cc` makes of a file.
fn compiled(source: &str, more: &[&str], name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c");
    std::fs::create_dir_all(&folder).unwrap();
    let out = folder.join(name);
    let mut cc = Command::new("cc");
    cc.args(["-std=gnu11", "-O1", "-Wall", "-Wextra", "-Werror", "-I"]).arg(repository("impl/c/include"));
    cc.arg(repository(source)).args(more).arg("-o").arg(&out);
    let output = cc.output().expect("cc runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    out
}

fn archive() -> String {
    FIRMWARE.join("libradcomp_c.a").display().to_string()
}

fn outcome(library: &Path) -> Outcome {
    let limits = if library.ends_with("HANG.so") { hasty() } else { limits() };
    campaign(PROGRAMS, || hosted(RADCOMP.into(), library, &profile(), limits))
}

fn faulty(fault: &str) -> PathBuf {
    let define = format!("-DFAULT={fault}");
    let arguments =
        ["-shared", "-fPIC", "-Wno-unused", &define, "-Ddevice=radcomp_device", &archive(), "-lm", "-Wl,-z,muldefs"];
    compiled("tests/devices/faulty.c", &arguments, &format!("{fault}.so"))
}

/// The fault is found, and every program has been judged all the same.
#[track_caller]
fn is_found(fault: &str, verdict: &str) {
    let outcome = outcome(&faulty(fault));
    let judged = outcome.tally.verdicts.get(verdict).copied().unwrap_or_default();
    assert!(judged > 0, "{fault}: {:?}", outcome.tally.verdicts);
    assert_eq!(outcome.tally.programs, campaign(PROGRAMS, || Builtin).tally.programs, "{fault} ended the run");
}

#[test]
fn a_firmware_in_c_compensates_without_a_heap() {
    let program = compiled("examples/c/firmware.c", &[&archive(), "-lm"], "firmware");
    let output = Command::new(&program).output().unwrap();
    assert!(output.status.success());
    // A tool of 5 mm: right angles, so that every vector is the radius along both axes.
    let path = "0 line 20.000000 5.000000\n\
                1 line 55.000000 5.000000\n\
                2 line 55.000000 35.000000\n\
                3 hold\n\
                4 line 90.000000 35.000000\n\
                5 cw 105.000000 20.000000 about 90.000000 20.000000\n\
                6 line 105.000000 0.000000\n\
                7 line 120.000000 0.000000\n";
    assert_eq!(String::from_utf8(output.stdout).unwrap(), path);
    let symbols = Command::new("nm").arg("-u").arg(&program).output().expect("nm runs");
    let symbols = String::from_utf8(symbols.stdout).unwrap();
    assert!(symbols.contains("printf"), "{symbols}");
    for heap in ["malloc", "calloc", "realloc", "free", "aligned_alloc", "posix_memalign"] {
        assert!(!symbols.contains(&format!(" {heap}")), "{heap} is called");
    }
}

#[test]
fn a_device_in_c_is_well() {
    let library = compiled("examples/c/device.c", &["-shared", "-fPIC"], "device.so");
    let findings = ping(&mut hosted(RADCOMP.into(), &library, &profile(), limits()), &profile());
    let wrong: Vec<_> = findings.into_iter().filter(|finding| finding.result.is_err()).collect();
    assert_eq!(wrong, []);
}

#[test]
fn the_implementation_behind_the_c_interface_is_the_implementation() {
    let library = FIRMWARE.join("libradcomp_c.so");
    assert_eq!(outcome(&library).tally, campaign(PROGRAMS, || Builtin).tally);
}

#[test]
fn the_sound_library_is_the_implementation() {
    assert_eq!(outcome(&faulty("SOUND")).tally, campaign(PROGRAMS, || Builtin).tally);
}

#[test]
fn faults_of_the_path() {
    for fault in [
        "WRONG_SIDE",
        "MITRE_WITHOUT_LIMIT",
        "NEGATIVE_RADIUS",
        "LOST_ON_Z_ONLY",
        "SHORT_LOOK_AHEAD",
        "DRIFT",
        "OTHER_BLOCK",
    ] {
        is_found(fault, "inadmissible");
    }
}

#[test]
fn numbers_that_are_none() {
    is_found("NOT_A_NUMBER", "garbled");
}

#[test]
fn a_hang() {
    is_found("HANG", "timeout");
}

#[test]
fn a_crash() {
    is_found("CRASH", "crash");
}

#[test]
fn lies_about_what_was_written() {
    is_found("LYING_COUNT", "crash");
    is_found("NO_COUNT", "crash");
}

#[test]
fn a_library_that_prints() {
    is_found("CHATTER", "garbled");
}

#[test]
fn a_file_that_is_no_device_is_told() {
    let told = |file: &str| Library::load(Path::new(file)).err().expect("no device");
    assert!(told(&repository("README.md")).contains("README.md cannot be loaded"));
    let empty = compiled("tests/devices/empty.c", &["-shared", "-fPIC"], "empty.so");
    assert!(told(&empty.display().to_string()).contains("does not export radcomp_device, the function of radcomp.h"));
    let answer =
        hosted(RADCOMP.into(), Path::new("README.md"), &profile(), limits()).answer(&profile().parameters, &[]);
    assert!(answer.unwrap_err().text().contains("cannot be loaded"));
}
