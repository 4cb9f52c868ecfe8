//! The report of a campaign.

use super::campaign::{Campaign, Outcome};
use super::failure::Failure;
use super::waivers::Waiver;
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
        let waivers = campaign.waivers.0.iter().enumerate();
        let expected = waivers.map(|(index, waiver)| {
            let programs = outcome.expected.get(&index).copied().unwrap_or_default();
            ExpectedFailure { programs, ..ExpectedFailure::from(waiver) }
        });
        Report { expected_failures: expected.collect(), ..report }
    }
}

impl From<&Waiver> for ExpectedFailure {
    fn from(waiver: &Waiver) -> Self {
        let Waiver { clause, program, difference, element, rule_alarm, device_alarm, reason } = waiver.clone();
        let clause = Id(clause);
        ExpectedFailure { clause, program, difference, element, rule_alarm, device_alarm, reason, programs: 0 }
    }
}

impl From<&ExpectedFailure> for Waiver {
    fn from(expected: &ExpectedFailure) -> Self {
        let ExpectedFailure { clause, program, difference, element, rule_alarm, device_alarm, reason, .. } =
            expected.clone();
        Waiver { clause: clause.0, program, difference, element, rule_alarm, device_alarm, reason }
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
