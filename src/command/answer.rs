//! `radcomp answer`.

use std::io::{self, BufReader};

use clap::Args;
use radcomp::device::library::Library;
use radcomp::device::pipe::Limits;
use radcomp::device::{DeviceName, wire};
use radcomp_spec::profile::Profile;

use super::failure::{Failure, Verdict};
use super::{device, options};

/// Answer the pipe protocol on standard input and output with a device, as a model for adapters
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  radcomp gen --profile seed-mill | radcomp answer builtin | radcomp check --profile seed-mill")]
pub struct Answer {
    /// The device
    #[arg(value_name = "DEVICE", default_value = "builtin")]
    device: String,

    /// The control that the device is opened for; each request brings its own parameters
    #[arg(long, short, value_name = "NAME|FILE.toml", default_value = "seed-mill")]
    profile: String,
}

impl Answer {
    /// Answers until the input ends.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let profile: Profile = options::profile(&self.profile)?;
        let mut device = match device::named(&self.device)? {
            // This process is the one that a library may take down with it.
            DeviceName::Library(file) => Box::new(Library::load(&file).map_err(Failure::Input)?),
            name => name.open(&profile, Limits::default()),
        };
        let input = BufReader::with_capacity(1 << 16, io::stdin());
        match wire::serve(&mut *device, input, io::stdout().lock()) {
            Ok(()) => Ok(Verdict::Green),
            Err(error) if error.kind() == io::ErrorKind::InvalidData => Err(Failure::Input(error.to_string())),
            Err(error) => Err(Failure::Output(error)),
        }
    }
}
