//! Devices outside this process: faults of theirs are found, and none of them ends a run.

#[path = "devices/differences.rs"]
mod differences;
#[path = "devices/faulty.rs"]
mod faulty;
#[path = "devices/kit.rs"]
mod kit;
#[path = "devices/library.rs"]
mod library;
#[path = "devices/linuxcnc.rs"]
mod linuxcnc;
#[path = "devices/protocol.rs"]
mod protocol;
#[path = "devices/recorded.rs"]
mod recorded;
#[path = "verify/schema.rs"]
mod schema;
#[path = "devices/smallest.rs"]
mod smallest;

use std::time::Duration;

use radcomp::certify::{Campaign, Outcome, certify};
use radcomp::device::Device;
use radcomp::device::pipe::Limits;
use radcomp::judge::{Budget, Grade};
use radcomp_spec::profile::Profile;

/// The command that cargo built for these tests.
const RADCOMP: &str = env!("CARGO_BIN_EXE_radcomp");

/// A path of this repository.
fn repository(path: &str) -> String {
    format!("{}/{path}", env!("CARGO_MANIFEST_DIR"))
}

fn profile() -> Profile {
    Profile::builtin("seed-mill").expect("built in")
}

/// Limits that a device keeps on a machine that does much else.
fn limits() -> Limits {
    Limits { timeout: Duration::from_secs(30), most_bytes: 1 << 20, in_flight: 16 }
}

/// Limits for a device that is to hang.
fn hasty() -> Limits {
    Limits { timeout: Duration::from_secs(3), ..limits() }
}

/// Judges a device on the beginning of level 1.
fn campaign<D: Device>(programs: u64, make: impl Fn() -> D + Sync) -> Outcome {
    campaign_on(2, programs, make)
}

/// The same, on so many threads.
fn campaign_on<D: Device>(threads: usize, programs: u64, make: impl Fn() -> D + Sync) -> Outcome {
    let campaign = Campaign {
        profile: profile(),
        seed: 1,
        programs,
        budget: Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 },
        waivers: Default::default(),
        threads,
    };
    certify(&campaign, make, |_| {})
}
