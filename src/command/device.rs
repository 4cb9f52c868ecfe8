//! The options that say which device is asked, and what it may cost.

use std::time::Duration;

use clap::Args;
use radcomp::device::pipe::Limits;
use radcomp::device::{DeviceFault, DeviceName, ask};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Movement};
use rug::Rational;

use super::failure::Failure;

/// The device that a name on the command line stands for.
pub fn named(name: &str) -> Result<DeviceName, Failure> {
    DeviceName::parse(name).map_err(|error| Failure::Input(error.to_string()))
}

/// Asks a device for the path of one uncompensated move: a device that does not answer that is not set up.
pub fn knock(name: &DeviceName, profile: &Profile, limits: Limits) -> Result<(), Failure> {
    let end = [Rational::from(1), Rational::from(2)];
    let program = [Block::moving(Movement::Line { end })];
    match ask(&mut *name.open(profile, limits), &profile.parameters, &program) {
        Ok(_) | Err(DeviceFault::Unsupported(_)) => Ok(()),
        Err(fault) if *name == DeviceName::LinuxCnc => Err(Failure::Input(format!(
            "rs274, LinuxCNC's interpreter, does not answer\n{fault}\nit is looked for on PATH and in $RS274; scripts/linuxcnc fetches Debian's"
        ))),
        Err(fault) => Err(Failure::Input(format!(
            "the device does not answer a program of one straight move\n{fault}\n`radcomp ping` tests a device piece by piece"
        ))),
    }
}

/// What a device may cost.
#[derive(Clone, Copy, Debug, Args)]
pub struct DeviceLimits {
    /// How long a device may take for a program, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,

    /// How long one answer may be, in MiB
    #[arg(long, value_name = "MIB", default_value = "16", value_parser = clap::value_parser!(u16).range(1..))]
    most_output: u16,

    /// How many programs a device is given before it has answered the first
    #[arg(long, value_name = "COUNT", default_value = "16", value_parser = clap::value_parser!(u16).range(1..=1024))]
    in_flight: u16,
}

impl DeviceLimits {
    /// The limits.
    pub fn limits(&self) -> Limits {
        Limits {
            timeout: self.timeout,
            most_bytes: usize::from(self.most_output) << 20,
            in_flight: usize::from(self.in_flight),
        }
    }
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds: Option<f64> = text.parse().ok().filter(|seconds| (0.001..=86_400.0).contains(seconds));
    seconds.map(Duration::from_secs_f64).ok_or_else(|| "a number of seconds from 0.001 to 86400".to_owned())
}
