//! What came of a campaign, on the terminal.

use std::io::Write;
use std::path::Path;

use radcomp::boundary;
use radcomp::certify::{Outcome, Waiver};
use radcomp::generate::Reach;
use radcomp::report::{Cause, Report, replay};
use radcomp_spec::profile::Profile;

use super::failure::Failure;
use super::terminal;

/// How many failed programs get a line of their own.
const MOST_LINES: usize = 20;
/// How many causes are told.
const MOST_CAUSES: usize = 8;

/// Whether a device has passed. One that supports nothing has not.
pub fn is_pass(outcome: &Outcome, allow_unsupported: bool) -> bool {
    let tally = &outcome.tally;
    tally.red() == 0 && (tally.unsupported() == 0 || (allow_unsupported && tally.unsupported() < tally.programs))
}

/// Prints what came of a campaign. `file` is where its report stands.
pub fn print(
    out: &mut dyn Write,
    outcome: &Outcome,
    report: &Report,
    profile: &Profile,
    file: Option<&Path>,
    allow_unsupported: bool,
) -> Result<(), Failure> {
    for failure in outcome.failures.iter().take(MOST_LINES) {
        writeln!(out, "{} {failure}", terminal::bold("FAIL"))?;
    }
    let failed = outcome.tally.counts.fail;
    if failed > MOST_LINES as u64 {
        writeln!(out, "… and {} more failed programs", failed - MOST_LINES as u64)?;
    }
    for broken in report.broken.iter().take(MOST_LINES) {
        writeln!(out, "{} {} {}: {}", terminal::bold("MOVED"), broken.name, broken.relation, broken.difference)?;
    }
    for cause in report.causes.iter().take(MOST_CAUSES) {
        counterexample(out, cause, file)?;
    }
    counts(out, outcome, profile)?;
    verdicts(out, outcome, report, allow_unsupported)
}

/// The counts by clause and by decision.
fn counts(out: &mut dyn Write, outcome: &Outcome, profile: &Profile) -> Result<(), Failure> {
    writeln!(out)?;
    writeln!(
        out,
        "{:<15}{:>10}{:>10}{:>11}{:>8}{:>10}{:>8}",
        "clause", "programs", "elements", "decisions", "alarms", "passed", "failed"
    )?;
    for (id, tally) in &outcome.tally.clauses {
        writeln!(
            out,
            "{id:<15}{:>10}{:>10}{:>11}{:>8}{:>10}{:>8}",
            tally.programs, tally.elements, tally.decisions, tally.alarms, tally.passed, tally.failed
        )?;
    }
    writeln!(out)?;
    writeln!(out, "{:<18}{:>10}{:>10}{:>10}", "decision", "negative", "zero", "positive")?;
    for (id, [negative, zero, positive]) in &outcome.tally.decisions {
        writeln!(out, "{id:<18}{negative:>10}{zero:>10}{positive:>10}")?;
    }
    // What the profile never asks is not missed.
    let reach = Reach::of(profile);
    let sides = outcome.tally.one_sided();
    let asked = sides.iter().filter(|(kind, _)| boundary::is_asked(*kind, reach));
    let missing: Vec<_> = asked.map(|(kind, side)| format!("{} ({side})", kind.id())).collect();
    if !missing.is_empty() {
        writeln!(out, "not exercised: {}", missing.join(", "))?;
    }
    Ok(())
}

/// The counts by verdict, and the last line.
fn verdicts(out: &mut dyn Write, outcome: &Outcome, report: &Report, allow_unsupported: bool) -> Result<(), Failure> {
    writeln!(out)?;
    let tally = &outcome.tally;
    writeln!(out, "{} programs, {} blocks, {} corners", tally.programs, tally.blocks, tally.corners)?;
    writeln!(
        out,
        "{} programs also moved, mirrored, scaled, rotated, split and run backwards: {} relations broken",
        tally.moved, tally.broken
    )?;
    for (verdict, count) in &tally.verdicts {
        let note = match *verdict {
            "admissible" => " (the exact outcome of an input within β: a witness)",
            "admissible-without-witness" => " (another branch within the band)",
            "unsupported" => " (neither failed nor passed)",
            _ => "",
        };
        writeln!(out, "  {verdict}: {count}{note}")?;
    }
    for (reason, programs) in tally.reasons.by_frequency() {
        writeln!(out, "    unsupported, {programs}: {reason}")?;
    }
    if tally.reasons.others > 0 {
        writeln!(out, "    unsupported, {}: other reasons", tally.reasons.others)?;
    }
    if tally.counts.expected_failure > 0 {
        writeln!(out, "  of these, expected failures: {} (waived)", tally.counts.expected_failure)?;
        for waiver in &report.expected_failures {
            writeln!(out, "    waived, {}: {}: {}", waiver.programs, Waiver::from(waiver), waiver.reason)?;
        }
    }
    if let Some(share) = tally.needed_share() {
        writeln!(
            out,
            "the witnesses found need at most {share:.3e} of the band β: the device passes with that share too"
        )?;
    }
    let verdict = match is_pass(outcome, allow_unsupported) {
        true => "PASS",
        false if tally.red() == 0 => {
            "INCOMPLETE: the device does not support every program (--allow-unsupported accepts that)"
        }
        false => "RED",
    };
    writeln!(out, "{}", terminal::bold(verdict))?;
    Ok(())
}

fn counterexample(out: &mut dyn Write, cause: &Cause, file: Option<&Path>) -> Result<(), Failure> {
    writeln!(out)?;
    let from = cause.case.as_ref().map_or("", |case| &case.name);
    writeln!(out, "{} {}: {} programs; smallest, from {from}:", terminal::bold("CAUSE"), cause.cause, cause.programs)?;
    writeln!(out, "  {}", cause.smallest)?;
    if let (Some(clause), Some(sentence)) = (cause.clause, &cause.sentence) {
        writeln!(out, "  [{}] {sentence}", clause.0)?;
    }
    if let Some(nearest) = &cause.nearest {
        let (decision, block, margin) = (nearest.decision.0.id(), nearest.block + 1, nearest.margin_mm.text());
        writeln!(out, "  nearest decision: {decision} at N{block}, margin {margin} mm")?;
    }
    writeln!(out, "  safety: {}", cause.safety.as_deref().unwrap_or("no path to judge"))?;
    match (&cause.program, &cause.tools) {
        (Some(program), Some(tools)) => {
            for line in program.lines() {
                writeln!(out, "    {line}")?;
            }
            for line in tools.lines().filter(|line| !line.is_empty()) {
                writeln!(out, "    ; tools: {line}")?;
            }
        }
        _ => writeln!(out, "    (the profile has no G-code for it)")?,
    }
    match file {
        Some(file) => writeln!(out, "  replay: {}", replay(&file.display().to_string(), &cause.cause))?,
        None => writeln!(
            out,
            "  replay: add --report report.json to this run; then {}",
            replay("report.json", &cause.cause)
        )?,
    }
    Ok(())
}
