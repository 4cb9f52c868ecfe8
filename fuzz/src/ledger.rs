//! What a campaign has come near to: for each decision and side how often it was taken, and its closest approach to the
//! boundary. The same goes to libFuzzer as coverage: a decision nearer to its boundary than ever before is a new
//! feature, so that the input is kept, and mutated further in that direction.

use std::fmt::Write as _;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};

use radcomp_model::Run;
use radcomp_spec::DecisionKind;

/// Sides of a decision: below its boundary, on it, above it.
const SIDES: usize = 3;
/// Steps of log2 of a margin: from 2¹⁶ mm, and above, to 2⁻⁴⁷ mm, and below.
const STEPS: usize = 64;
const HIGHEST: i32 = 16;
const KINDS: usize = DecisionKind::ALL.len();

/// libFuzzer takes this section for counters of its own, and clears it before each input.
#[cfg_attr(all(fuzzing, target_os = "linux"), unsafe(link_section = "__libfuzzer_extra_counters"))]
static COUNTERS: [AtomicU8; KINDS * SIDES * STEPS] = [const { AtomicU8::new(0) }; KINDS * SIDES * STEPS];

/// How often each decision was taken on each side.
static TAKEN: [AtomicU64; KINDS * SIDES] = [const { AtomicU64::new(0) }; KINDS * SIDES];
/// The least margin there, as the bits of its magnitude: those of positive numbers are in the order of the numbers.
static NEAREST: [AtomicU64; KINDS * SIDES] = [const { AtomicU64::new(u64::MAX) }; KINDS * SIDES];
/// Red verdicts that were passed over for a stated reason.
static WAIVED: AtomicU64 = AtomicU64::new(0);
/// Inputs run.
static RUNS: AtomicU64 = AtomicU64::new(0);

/// Counters are left alone when `RADCOMP_UNGUIDED` is set: what guidance is worth can be measured.
static GUIDED: LazyLock<AtomicBool> = LazyLock::new(|| AtomicBool::new(std::env::var_os("RADCOMP_UNGUIDED").is_none()));
/// The file that `RADCOMP_FUZZ_REPORT` names is written every so many inputs.
const REPORT_EVERY: u64 = 20_000;

/// Counts an input; writes the report now and then.
pub fn ran() {
    let runs = RUNS.fetch_add(1, Ordering::Relaxed) + 1;
    if runs.is_multiple_of(REPORT_EVERY)
        && let Some(file) = std::env::var_os("RADCOMP_FUZZ_REPORT")
    {
        // A campaign goes on without its report.
        let _ = std::fs::write(file, report());
    }
}

/// Counts a red verdict that is passed over.
pub fn waived() {
    WAIVED.fetch_add(1, Ordering::Relaxed);
}

/// Notes every decision of an exact run.
pub fn note(run: &Run) {
    let guided = GUIDED.load(Ordering::Relaxed);
    for (decision, _) in &run.decisions {
        let kind = DecisionKind::ALL.iter().position(|kind| *kind == decision.kind).unwrap_or(0);
        let place = kind * SIDES + (decision.exact as i8 + 1) as usize;
        let (low, high) = decision.margin.filter();
        // An upper bound: no margin is told as nearer than it is.
        let margin = if decision.exact.is_eq() { 0.0 } else { low.abs().max(high.abs()) };
        TAKEN[place].fetch_add(1, Ordering::Relaxed);
        NEAREST[place].fetch_min(margin.to_bits(), Ordering::Relaxed);
        if guided {
            COUNTERS[place * STEPS + step(margin)].store(1, Ordering::Relaxed);
        }
    }
}

/// The step of a margin: the nearer to zero, the higher.
fn step(margin: f64) -> usize {
    let down = HIGHEST - margin.log2().floor().clamp(-1e6, 1e6) as i32;
    // Clamped to the steps that there are.
    down.clamp(0, STEPS as i32 - 1) as usize
}

/// The report: a line for each decision and side.
#[must_use]
pub fn report() -> String {
    let (runs, waived) = (RUNS.load(Ordering::Relaxed), WAIVED.load(Ordering::Relaxed));
    let mut report = format!("{runs} inputs, {waived} red verdicts waived\n");
    if TAKEN.iter().all(|taken| taken.load(Ordering::Relaxed) == 0) {
        report += "no decision was looked at: the target is not about programs\n";
        return report;
    }
    for (kind, decision) in DecisionKind::ALL.iter().enumerate() {
        for (side, name) in ["below", "on", "above"].into_iter().enumerate() {
            let place = kind * SIDES + side;
            let taken = TAKEN[place].load(Ordering::Relaxed);
            let nearest = f64::from_bits(NEAREST[place].load(Ordering::Relaxed));
            let nearest = if taken == 0 { "-".to_owned() } else { format!("{nearest:.2e}") };
            // Writing to a String does not fail.
            let _ = writeln!(report, "{:<18} {name:<6} {taken:>12} times, nearest {nearest} mm", decision.id());
        }
    }
    report
}

/// How often a decision was taken below, on and above its boundary.
#[must_use]
pub fn taken(kind: DecisionKind) -> [u64; SIDES] {
    let kind = DecisionKind::ALL.iter().position(|other| *other == kind).unwrap_or(0);
    std::array::from_fn(|side| TAKEN[kind * SIDES + side].load(Ordering::Relaxed))
}
