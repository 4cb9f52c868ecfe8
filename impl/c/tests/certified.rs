//! The certification suite at level 1 against this library. `scripts/mutants` runs it on every mutant of the
//! implementation; `make test` does not, for it certifies the unchanged one in process and through the C interface.
//!
//! The judge is a command that was built before from unchanged sources, so that a mutant costs one small build.

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The environment variable with the path of the command `radcomp` that judges.
const JUDGE: &str = "RADCOMP_JUDGE";
/// The environment variable with the parts of the campaign to run, separated by commas: a failure of a part is one of
/// the whole.
const PARTS: &str = "RADCOMP_PARTS";
/// The environment variable with the names of the profiles, separated by commas: all of the repository's without it.
const PROFILES: &str = "RADCOMP_PROFILES";
/// All of it, smallest part first: most faults show in the first hundred programs of one profile or another.
const ALL_PARTS: &str = "1/480,1/48,1/1";

#[test]
fn every_profile_passes_level_1() {
    let judge = std::env::var_os(JUDGE).unwrap_or_else(|| panic!("{JUDGE} does not name the command that judges"));
    let profiles = profiles();
    let parts = std::env::var(PARTS).unwrap_or_else(|_| ALL_PARTS.to_owned());
    for part in parts.split(',') {
        for profile in &profiles {
            let mut certify = Command::new(&judge);
            certify.args(["certify", "--level", "1", "--timeout", "1", "--shard", part, "--profile"]).arg(profile);
            let status = certify.arg(device()).stdout(Stdio::null()).status().expect("the judge runs");
            assert!(status.success(), "{} fails part {part} of level 1: {status}", profile.display());
        }
    }
}

/// The profiles of the repository, in the order of their names.
fn profiles() -> Vec<PathBuf> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../spec/profiles");
    let entries = std::fs::read_dir(folder).expect("the profiles are there");
    let mut profiles: Vec<_> = entries.map(|entry| entry.expect("it can be read").path()).collect();
    profiles.sort();
    if let Ok(names) = std::env::var(PROFILES) {
        let named = |path: &PathBuf| names.split(',').any(|name| path.file_stem().is_some_and(|stem| stem == name));
        profiles.retain(named);
    }
    assert!(!profiles.is_empty());
    profiles
}

/// The device: the shared library, which cargo builds beside this test.
fn device() -> OsString {
    let test = std::env::current_exe().expect("it has a path");
    let library = format!("{}radcomp_c{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let library = test.with_file_name(library);
    assert!(library.is_file(), "{} is not built", library.display());
    let mut device = OsString::from("lib:");
    device.push(library);
    device
}
