//! The certification suite at level 1 against this library. `scripts/mutants` runs it on every mutant of the
//! implementation; `make test` does not, for it certifies the unchanged one in process and through the C interface.
//!
//! A program that a mutant answers as the unchanged library does, to the bit, needs no judge: `scripts/mutants` has had
//! the unchanged one certified and its answers recorded (`recorder.c`), part by part. The parts in which an answer
//! differs are judged, by a command that was built before from unchanged sources.

#![expect(unsafe_code, reason = "the C boundary")]

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use radcomp_c::{
    RADCOMP_MOST_STEPS, RADCOMP_OK, parameters, radcomp_alarm, radcomp_block, radcomp_finish, radcomp_push,
    radcomp_state, radcomp_step,
};
use radcomp_spec::Parameters;

/// The environment variable with the path of the command `radcomp` that judges.
const JUDGE: &str = "RADCOMP_JUDGE";
/// The environment variable with the folder of records: `PROFILE/PART/…`, a part being such as `1-12`.
const RECORDS: &str = "RADCOMP_RECORDS";
/// Where profiles are.
const FOLDERS: [&str; 2] = ["spec/profiles", "tests/combinations"];

#[test]
fn every_profile_passes_level_1() {
    let records = variable(RECORDS);
    let mut differing = Vec::new();
    let profiles = entries(&records);
    assert!(!profiles.is_empty());
    for profile in profiles {
        for part in entries(&profile) {
            if !entries(&part).iter().all(|record| is_answered_alike(record)) {
                differing.push((profile.clone(), part));
            }
        }
    }
    // One part of each profile first, as one failure is enough.
    differing.sort_by_key(|(_, part)| part.file_name().map(OsString::from));
    for (profile, part) in differing {
        let part = name(&part).replace('-', "/");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let files = FOLDERS.map(|folder| root.join(folder).join(name(&profile) + ".toml"));
        let file = files.iter().find(|file| file.exists()).expect("the profile is there");
        let mut certify = Command::new(variable(JUDGE));
        certify.args(["certify", "--level", "1", "--timeout", "1", "--shard", &part, "--profile"]).arg(file);
        let status = certify.arg(device()).stdout(Stdio::null()).status().expect("the judge runs");
        assert!(status.success(), "{} fails part {part} of level 1: {status}", name(&profile));
    }
}

fn variable(variable: &str) -> PathBuf {
    std::env::var_os(variable).unwrap_or_else(|| panic!("scripts/mutants sets {variable}")).into()
}

/// What is in a folder, in the order of its name.
fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut entries: Vec<_> = entries.map(|entry| entry.expect("it can be read").path()).collect();
    entries.sort();
    entries
}

fn name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
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

/// Whether the programs of a record are answered as they were.
fn is_answered_alike(file: &Path) -> bool {
    let bytes = fs::read(file).expect("it can be read");
    let mut record = Record(&bytes);
    let (mut profile, mut blocks) = (None, Vec::new());
    while !record.0.is_empty() {
        let length = record.number() as usize;
        if length > 0 {
            profile = parameters(std::str::from_utf8(record.take(length)).expect("text"));
        }
        let profile = profile.as_ref().expect("a profile");
        blocks.clear();
        for _ in 0..record.number() {
            // SAFETY: the bytes are those of a block that the recorder was given.
            blocks.push(unsafe {
                record.take(size_of::<radcomp_block>()).as_ptr().cast::<radcomp_block>().read_unaligned()
            });
        }
        if answer(profile, &blocks) != record.number() {
            return false;
        }
    }
    true
}

/// What is left of a record.
struct Record<'a>(&'a [u8]);

impl<'a> Record<'a> {
    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, left) = self.0.split_at(count);
        self.0 = left;
        taken
    }

    fn number(&mut self) -> u64 {
        u64::from_ne_bytes(self.take(8).try_into().expect("it is as long"))
    }
}

/// The digest of the answer to a program, as the recorder makes it.
fn answer(profile: &Parameters, blocks: &[radcomp_block]) -> u64 {
    let mut state = radcomp_state::new(profile);
    let mut room = [radcomp_step::default(); RADCOMP_MOST_STEPS];
    let (mut sum, mut alarm) = (0, radcomp_alarm::default());
    for index in 0..=blocks.len() {
        let mut count = 0;
        // SAFETY: state and buffers are ours.
        let status = unsafe {
            match blocks.get(index) {
                Some(block) => radcomp_push(&mut state, block, room.as_mut_ptr(), room.len(), &mut count, &mut alarm),
                None => radcomp_finish(&mut state, room.as_mut_ptr(), room.len(), &mut count, &mut alarm),
            }
        };
        // SAFETY: neither a step nor an alarm has bytes between its fields.
        sum = unsafe { digest(sum, &room[..count]) };
        if status != RADCOMP_OK {
            break;
        }
    }
    // SAFETY: as above.
    unsafe { digest(sum, &[alarm]) }
}

/// # Safety
///
/// The items have no bytes between their fields.
unsafe fn digest<T>(sum: u64, items: &[T]) -> u64 {
    // SAFETY: they are read as bytes, all of which have a value.
    let bytes = unsafe { std::slice::from_raw_parts(items.as_ptr().cast::<u8>(), size_of_val(items)) };
    bytes.as_chunks::<8>().0.iter().fold(sum, |sum, word| {
        let sum = (sum ^ u64::from_ne_bytes(*word)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        sum ^ (sum >> 32)
    })
}
