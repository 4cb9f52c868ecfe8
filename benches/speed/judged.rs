//! Programs from the generator to a verdict.

use radcomp::device::Builtin;
use radcomp::generate::{self, Reach};
use radcomp::judge::{Budget, Grade, judge};
use radcomp_spec::profile::Profile;

use crate::measure::{Contestant, race};

/// Programs in one call: enough that each kind of program that the generator makes is among them.
const PROGRAMS: u64 = 600;
const SEED: u64 = 1;

/// Nanoseconds per program of about ten blocks judged against the builtin device, or why there is no figure.
pub fn builtin(rounds: usize) -> Result<f64, &'static str> {
    let profile = Profile::builtin("seed-mill").ok_or("no profile seed-mill")?;
    let reach = Reach::of(&profile);
    let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 0.001 };
    let mut device = Builtin;
    let count = usize::try_from(PROGRAMS).map_err(|_| "too many programs")?;
    let [nanoseconds] = race(
        [Contestant::new(count, || {
            (0..PROGRAMS)
                .map(|number| generate::program(SEED, number, reach))
                .filter(|blocks| judge(&mut device, &profile.parameters, blocks, &budget).verdict.is_red())
                .count()
        })],
        rounds,
    );
    Ok(nanoseconds)
}

/// Nanoseconds per program judged against LinuxCNC, or why there is no figure.
pub fn linuxcnc() -> Result<f64, &'static str> {
    Err("no such device yet")
}
