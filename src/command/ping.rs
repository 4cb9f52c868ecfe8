//! `radcomp ping`.

use std::io::Write;

use clap::Args;
use radcomp::device::ping::ping;

use super::device::{self, DeviceLimits};
use super::failure::{Failure, Verdict};
use super::{options, terminal};

/// Test a device's adapter with plain programs, and say what is wrong with it
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  radcomp ping \"pipe:python3 adapter.py\"
  radcomp ping \"pipe:ssh bench ./control\" --profile my-control.toml --timeout 60

Exit status: 0 all is well; 1 something is wrong with the device; 2 wrong usage.")]
pub struct Ping {
    /// The device
    #[arg(value_name = "DEVICE")]
    device: String,

    /// The control: a built-in profile (see `radcomp profiles`) or a profile file
    #[arg(long, short, value_name = "NAME|FILE.toml", default_value = "seed-mill")]
    profile: String,

    #[command(flatten)]
    limits: DeviceLimits,
}

impl Ping {
    /// Runs the tests.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let profile = options::profile(&self.profile)?;
        let mut device = device::named(&self.device)?.open(&profile, self.limits.limits());
        let mut out = terminal::output();
        let mut verdict = Verdict::Green;
        for finding in ping(&mut *device, &profile) {
            match finding.result {
                Ok(seen) => writeln!(out, "ok     {}: {seen}", finding.test)?,
                Err(wrong) => {
                    verdict = Verdict::Red;
                    writeln!(out, "{}  {}: {wrong}", terminal::bold("WRONG"), finding.test)?;
                }
            }
        }
        out.flush()?;
        Ok(verdict)
    }
}
