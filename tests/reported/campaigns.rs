//! Reports of small campaigns.

use std::sync::LazyLock;

use radcomp::certify::{Campaign, Outcome, Waivers, certify};
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::judge::{Budget, Grade};
use radcomp::report::{DeviceRecord, Report};
use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Block, Clause, Parameters, Segment, clause};
use rug::Rational;

/// The implementation with four faults: squared-off corners reach too far, one kind of alarm is lost, arcs after inner
/// corners end a little off, and a full stop loses the rest.
struct Faulty;

impl Device for Faulty {
    fn name(&self) -> &str {
        "faulty"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answer = Builtin.answer(parameters, blocks)?;
        let at = |clause: Clause, step: &radcomp_spec::Step<f64>| step.clause == clause;
        for step in &mut answer.steps {
            let off = if at(clause::TRC_CORNER_08, step) { 1.5 } else { 2e-5 };
            let faulty = at(clause::TRC_CORNER_08, step) || at(clause::TRC_CORNER_05, step);
            match &mut step.segment {
                Segment::Line { end } | Segment::Arc { end, .. } if faulty => end[0] += off,
                _ => {}
            }
        }
        if answer.alarm.is_some_and(|alarm| alarm.kind == AlarmKind::NoIntersection) {
            answer.alarm = None;
        }
        if blocks.len().is_multiple_of(11) {
            return Err(DeviceFault::Crash("<script>alert(\"division by zero\")</script> & more".to_owned()));
        }
        Ok(answer)
    }
}

/// A campaign of a few hundred programs.
pub fn campaign(waivers: &str) -> Campaign {
    Campaign {
        profile: Profile::builtin("yasnac-lx").expect("built in"),
        seed: 1,
        programs: 500,
        budget: Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 },
        waivers: Waivers::parse(waivers).expect("waivers"),
        threads: 2,
    }
}

/// The report of the faulty device.
pub fn faulty() -> &'static Report {
    static REPORT: LazyLock<Report> = LazyLock::new(|| faulty_with(""));
    &REPORT
}

/// The report of the faulty device under waivers.
pub fn faulty_with(waivers: &str) -> Report {
    let campaign = campaign(waivers);
    let outcome: Outcome = certify(&campaign, || Faulty, |_| {});
    outcome.report(&DeviceRecord::named("faulty"), None, &campaign)
}

/// The report of the implementation.
pub fn sound() -> &'static Report {
    static REPORT: LazyLock<Report> = LazyLock::new(|| {
        let campaign = campaign("");
        let outcome = certify(&campaign, || Builtin, |_| {});
        outcome.report(&DeviceRecord::named("builtin"), None, &campaign)
    });
    &REPORT
}
