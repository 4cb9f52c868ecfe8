//! The profile that a report embeds, and the level that it says was run.

use radcomp_spec::Parameters;
use radcomp_spec::profile::Profile;

use crate::report::{Report, sha256};

/// The fewest generated programs of levels 1, 2 and 3.
pub const LEAST_PROGRAMS: [u64; 3] = [24_000, 480_000, 4_800_000];

/// What is wrong with the profile and the level.
pub(super) fn contradictions(report: &Report) -> Vec<String> {
    let mut found = Vec::new();
    let mut demand = |holds: bool, otherwise: &str| {
        if !holds {
            found.push(otherwise.to_owned());
        }
    };
    demand(sha256(report.profile_file.as_bytes()) == report.profile_sha256, "the profile's hash is another one");
    match Profile::parse(&report.profile_file, &report.profile) {
        Err(error) => found.push(format!("the profile cannot be read: {error}")),
        Ok(profile) => {
            let increment = profile.machine.least_increment;
            let increment = f64::from(increment.numerator) / f64::from(increment.denominator);
            demand(profile.name == report.profile, "the profile's name is another one");
            demand(Parameters::from(&report.parameters) == profile.parameters, "the parameters are not the profile's");
            demand(increment == report.least_increment_mm.0, "the least increment is not the profile's");
        }
    }
    if let Some(level) = report.level {
        let least = usize::from(level).checked_sub(1).and_then(|index| LEAST_PROGRAMS.get(index));
        match least {
            None => found.push(format!("there is no level {level}")),
            Some(least) if report.generated_programs < *least => {
                found.push(format!("level {level} has {least} generated programs, not {}", report.generated_programs));
            }
            Some(_) if report.shard.is_none() && report.tally.programs < report.generated_programs => {
                found.push(format!("{} programs were judged, fewer than generated", report.tally.programs));
            }
            Some(_) => {}
        }
    }
    found
}
