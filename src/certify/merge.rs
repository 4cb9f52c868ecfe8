//! The parts of a campaign, put together.

use std::collections::BTreeMap;

use radcomp_spec::profile::Profile;

use super::campaign::{Campaign, Outcome};
use super::checkpoint::difference;
use super::ledger::Ledger;
use super::smallest;
use super::waivers::{Waiver, Waivers};
use crate::judge::{Budget, Grade};
use crate::report::{DeviceRecord, GradeRecord, Report, ShardRecord};

/// What a report's campaign is, by name: reports that differ in none of it are of one campaign.
pub fn campaign_of(report: &Report) -> Vec<(String, String)> {
    let files = report.device_files.iter().map(|file| format!("{} {}", file.file, file.sha256));
    let waivers = report.expected_failures.iter().map(|waiver| format!("{:?}", Waiver::from(waiver)));
    let list = [
        ("suite version", format!("{} {}", report.radcomp, report.commit)),
        ("device", report.device.clone()),
        ("device version", report.device_version.clone().unwrap_or_else(|| "unknown".to_owned())),
        ("device files", files.collect::<Vec<_>>().join(", ")),
        ("profile", format!("{} {}", report.profile, report.profile_sha256)),
        ("level", report.level.map_or_else(|| "none".to_owned(), |level| level.to_string())),
        ("seed", report.seed.to_string()),
        ("programs", report.generated_programs.to_string()),
        ("grade", format!("{:?}", report.grade)),
        ("delta", report.delta_mm.text()),
        ("waivers", waivers.collect::<Vec<_>>().join("; ")),
    ];
    list.map(|(name, text)| (name.to_owned(), text)).into()
}

/// The report of a whole campaign from those of its shards, each with the name of its file.
///
/// # Errors
///
/// Reports of different campaigns, of no shard, of the same shard, a shard without a report: which, in words.
pub fn merge(reports: Vec<(String, Report)>) -> Result<(Campaign, Outcome, Report), String> {
    let Some((first_file, first)) = reports.first() else { return Err("there is no report".to_owned()) };
    let (first_file, campaign) = (first_file.clone(), campaign_of(first));
    let head = Report { shard: None, ..first.clone() };
    let mut of = None;
    let mut parts = BTreeMap::new();
    for (file, report) in reports {
        if let Some(difference) = difference(&campaign, &campaign_of(&report)) {
            return Err(format!("{first_file} and {file} are not of one campaign: {difference}"));
        }
        let Report { shard, tally, .. } = report;
        let Some(ShardRecord { number, of: count, ledger }) = shard else {
            return Err(format!("{file} is not the report of a shard"));
        };
        if *of.get_or_insert(count) != count {
            return Err(format!("{file} is of shard {number}/{count}, {first_file} of another division"));
        }
        let counted = ledger.tally == tally;
        let ledger = ledger.ledger().filter(|_| counted);
        let ledger = ledger.ok_or_else(|| format!("{file}: its counts are not those of its shard"))?;
        if let Some((other, _)) = parts.insert(number, (file.clone(), ledger)) {
            return Err(format!("{other} and {file} are both of shard {number}/{count}"));
        }
    }
    let of = of.unwrap_or_default();
    let missing: Vec<_> = (1..=of).filter(|number| !parts.contains_key(number)).map(|n| format!("{n}/{of}")).collect();
    if !missing.is_empty() || parts.len() as u64 != of {
        return Err(format!("there is no report of shard {}", missing.join(", ")));
    }
    let mut ledger = Ledger::default();
    parts.into_values().for_each(|(_, part)| ledger.merge(part));
    report(head, ledger)
}

/// The report of a campaign whose head stands in one of its shards' reports.
fn report(head: Report, ledger: Ledger) -> Result<(Campaign, Outcome, Report), String> {
    let profile = Profile::parse(&head.profile_file, &head.profile).map_err(|error| error.to_string())?;
    let waivers = head.expected_failures.iter().map(Waiver::from);
    let grade = match head.grade {
        GradeRecord::Binary64 => Grade::Binary64,
        GradeRecord::Resolution => Grade::Resolution,
    };
    let campaign = Campaign {
        profile,
        seed: head.seed,
        programs: head.generated_programs,
        budget: Budget { grade, least_increment: head.least_increment_mm.0, delta: head.delta_mm.0 },
        waivers: Waivers(waivers.collect()),
        threads: 1,
    };
    let device = DeviceRecord { name: head.device, version: head.device_version, files: head.device_files };
    let outcome = smallest::told(ledger, campaign.programs, &campaign);
    let whole = outcome.report(&device, head.level, &campaign);
    Ok((campaign, outcome, Report { radcomp: head.radcomp, commit: head.commit, ..whole }))
}
