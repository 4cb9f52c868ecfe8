//! The causes of a campaign's failures, each with the smallest program that was found.

use std::collections::BTreeMap;

use radcomp_model::run;
use radcomp_spec::Block;
use rug::Rational;

use super::campaign::{Campaign, Outcome};
use super::failure::{Failure, group};
use super::ledger::{Group, Ledger};
use super::safety::Safety;
use crate::device::{Answer, Device};
use crate::judge::{Judged, judge};
use crate::minimise::minimise;
use crate::report;

/// How many causes are told by a program that was made smaller.
pub(super) const MOST_GROUPS: usize = 24;

/// Makes the programs of the most frequent causes smaller.
pub(super) fn make_small(
    groups: &mut BTreeMap<String, Group>,
    most: usize,
    campaign: &Campaign,
    device: &mut impl Device,
) {
    for name in by_frequency(groups).into_iter().take(most) {
        // The names are those of the map.
        let Some(group) = groups.get_mut(&name) else { continue };
        // Each smaller program would have to be waited for.
        if group.shortest.case.verdict != "timeout" {
            group.smaller = smaller(&group.shortest, campaign, device);
        }
    }
}

/// The outcome that a ledger tells, its causes as small as they are there.
pub(super) fn told(ledger: Ledger, programs: u64, campaign: &Campaign) -> Outcome {
    let order = by_frequency(&ledger.groups);
    let Ledger { tally, failures, broken, cases, expected, mut groups } = ledger;
    let mut list = Vec::new();
    for (rank, name) in order.into_iter().enumerate() {
        let Some(group) = groups.remove(&name) else { continue };
        let smaller = group.smaller.filter(|_| rank < MOST_GROUPS);
        let failure = smaller.unwrap_or(group.shortest);
        list.push((name, group.programs, Failure { safety: safety(&failure, campaign), ..failure }));
    }
    Outcome { programs, tally, failures, broken, cases, expected, groups: list }
}

/// The names of the causes, most frequent first.
fn by_frequency(groups: &BTreeMap<String, Group>) -> Vec<String> {
    let mut names: Vec<_> = groups.iter().map(|(name, group)| (group.programs, name)).collect();
    names.sort_by(|x, y| y.0.cmp(&x.0).then_with(|| x.1.cmp(y.1)));
    names.into_iter().map(|(_, name)| name.clone()).collect()
}

/// A smaller program that can be written for the profile and fails in the same way.
fn smaller(failure: &Failure, campaign: &Campaign, device: &mut impl Device) -> Option<Failure> {
    let parameters = &campaign.profile.parameters;
    let mut judged = |blocks: &[Block<Rational>]| judge(device, parameters, blocks, &campaign.budget);
    let of = |blocks: &[Block<Rational>], judged: &Judged| {
        let beta = campaign.budget.beta(blocks);
        let case = report::case(failure.name(), blocks, judged, &campaign.budget, beta)?;
        Some(Failure::new(failure.place, &judged.verdict, blocks.to_vec(), case))
    };
    let mut same = |blocks: &[Block<Rational>]| {
        let judged = judged(blocks);
        judged.verdict.is_red()
            && group(&judged.verdict) == failure.group
            && crate::gcode::print_blocks(blocks, &campaign.profile).is_ok()
    };
    let blocks = minimise(&failure.blocks, &mut same);
    let last = judged(&blocks);
    // A device that does not answer twice alike may pass now.
    of(&blocks, &last).filter(|_| last.verdict.is_red())
}

/// What the answer does to the part, in words.
fn safety(failure: &Failure, campaign: &Campaign) -> Option<String> {
    let answer = Answer::from(failure.case.answer.as_ref()?);
    let exact = run(&campaign.profile.parameters, &failure.blocks);
    Some(Safety::of(&failure.blocks, &exact, &answer, &campaign.budget).to_string())
}
