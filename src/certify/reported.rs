//! The report of a campaign.

use super::campaign::{Campaign, Outcome};
use super::failure::Failure;
use crate::report::{Case, Cause, DeviceRecord, ExpectedFailure, Head, Id, Report};

impl Outcome {
    /// The report of this campaign on a device. `level` is the level that was run, if one was.
    pub fn report(&self, device: &DeviceRecord, level: Option<u8>, campaign: &Campaign) -> Report {
        let outcome = self;
        let causes = outcome.groups.iter().map(|(name, count, smallest)| cause(name, *count, smallest, campaign));
        let broken = outcome.broken.iter().map(|(_, broken)| broken.clone());
        let head = Head {
            device,
            level,
            profile: &campaign.profile,
            seed: campaign.seed,
            generated_programs: outcome.programs,
            budget: &campaign.budget,
        };
        let report = Report::new(head, &outcome.tally, causes.collect(), broken.collect(), outcome.cases.clone());
        let expected = campaign.waivers.0.iter().enumerate().map(|(index, waiver)| ExpectedFailure {
            clause: Id(waiver.clause),
            program: waiver.program.clone(),
            difference: waiver.difference.clone(),
            reason: waiver.reason.clone(),
            programs: outcome.expected.get(&index).copied().unwrap_or_default(),
        });
        Report { expected_failures: expected.collect(), ..report }
    }
}

fn cause(name: &str, programs: u64, smallest: &Failure, campaign: &Campaign) -> Cause {
    let (program, tools) =
        smallest.listing(&campaign.profile).ok().map(|listing| (listing.program, listing.tool_table)).unzip();
    let cause = Cause {
        cause: name.to_owned(),
        programs,
        smallest: smallest.to_string(),
        clause: None,
        sentence: None,
        nearest: None,
        safety: smallest.safety.clone(),
        program,
        tools,
        case: None,
    };
    cause.told_by(Case::clone(&smallest.case), &campaign.profile.parameters)
}
