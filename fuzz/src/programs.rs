//! Targets over programs: bytes name a generated program and edits of it ([`Edited`]).

use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::edited::Edited;
use radcomp::gcode::{print_blocks, read};
use radcomp::judge::{Budget, Grade, Judged, Verdict, judge};
use radcomp::metamorphic;
use radcomp::safety::{Contour, Finding, SafetyVerdict, check};
use radcomp_model::number::Real;
use radcomp_model::{Run, run};
use radcomp_spec::{AdvisoryKind, Block, DecisionKind, Parameters, Segment};
use rug::Rational;

use crate::ledger;

/// The budget of every target, in millimetres.
pub const BUDGET: Budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };

/// The budget of the safety verdict of an exact path, in millimetres: the wider, the fewer cuts its proof takes.
const GOUGE: f64 = 1e-4;

/// The model against the implementation: no answer is red.
pub fn model_and_implementation(bytes: &[u8]) {
    judged(&mut Builtin, bytes);
}

/// Judges a device on the program that the bytes name.
///
/// # Panics
/// When the verdict is red.
pub fn judged(device: &mut dyn Device, bytes: &[u8]) -> Option<Judged> {
    let Edited { profile, blocks } = Edited::from_bytes(bytes)?;
    let judged = judge(device, &profile.parameters, &blocks, &BUDGET);
    ledger::note(&judged.exact);
    if judged.verdict.is_red() && (is_far(&judged.exact) || nearly_touches(&judged.exact, BUDGET.beta(&blocks))) {
        ledger::waived();
        return None;
    }
    assert!(!judged.verdict.is_red(), "{}: {:?}\n{}", profile.name, judged.verdict, written(&blocks, &profile));
    Some(judged)
}

/// Whether a vector lies more than a kilometre from its corner, or the path or an arc's centre leads so far off. There a
/// change in the last place of a coordinate moves it by more than the farthest that the judge looks for a witness, so that
/// a red verdict would say nothing.
fn is_far(run: &Run) -> bool {
    let point_is_far = |point: &[Real; 2]| point.iter().any(|value| value.to_f64().abs() > 1e6);
    let is_far = |segment: &Segment<Real>| match segment {
        Segment::Line { end } => point_is_far(end),
        Segment::Arc { end, centre, .. } => point_is_far(end) || point_is_far(centre),
        Segment::Hold => false,
    };
    if run.steps.iter().any(|step| is_far(&step.segment)) {
        return true;
    }
    run.advisories
        .iter()
        .any(|advisory| advisory.kind == AdvisoryKind::FarIntersection && advisory.amount > Real::integer(1_000_000))
}

/// Whether the tool's arc may have no length: its end is then a rounding before or behind its start, and read as it is
/// written an end before the start is a whole turn. The judge compares ends and does not see it.
fn shrinks_to_nothing(run: &Run, beta: f64) -> bool {
    run.decisions.iter().any(|(decision, _)| {
        let (low, high) = decision.margin.filter();
        let sweeps = matches!(decision.kind, DecisionKind::ArcForward | DecisionKind::ArcInterference);
        sweeps && low <= beta && high >= -beta
    })
}

/// Whether two offset curves overlap by less than the band, and not exactly by nothing. A device may take them to touch; the
/// judge's branch for that puts the vector where they cross, a square root of the band away, and finds no witness.
fn nearly_touches(run: &Run, beta: f64) -> bool {
    run.decisions.iter().any(|(decision, _)| {
        let (low, high) = decision.margin.filter();
        use DecisionKind::{AvoidanceMeets, ContactExists, OffsetsMeet};
        let kind = matches!(decision.kind, OffsetsMeet | ContactExists | AvoidanceMeets);
        kind && decision.exact.is_ne() && low <= beta && high >= -beta
    })
}

fn written(blocks: &[Block<Rational>], profile: &radcomp_spec::profile::Profile) -> String {
    print_blocks(blocks, profile).map_or_else(|_| format!("{blocks:#?}"), |listing| listing.program)
}

/// Moved, mirrored, scaled, turned and split programs have moved answers.
pub fn metamorphic(bytes: &[u8]) {
    let Some(Edited { profile, blocks }) = Edited::from_bytes(bytes) else { return };
    ledger::note(&run(&profile.parameters, &blocks));
    let broken = metamorphic::check(&mut Builtin, &profile.parameters, &blocks, &BUDGET);
    assert!(broken.is_empty(), "{}: {broken:?}\n{}", profile.name, written(&blocks, &profile));
}

/// What the printer writes, the reader reads back as the same blocks.
pub fn round_trip(bytes: &[u8]) {
    let Some(Edited { profile, blocks }) = Edited::from_bytes(bytes) else { return };
    // Edits make blocks that the profile cannot write; the printer says so.
    let Ok(listing) = print_blocks(&blocks, &profile) else { return };
    let program = read("fuzz.nc", listing.program.as_bytes(), &profile, &listing.tools);
    let program = program.unwrap_or_else(|fault| panic!("{fault:?}\n{}", listing.program));
    assert_eq!(program.blocks.len(), blocks.len(), "{}", listing.program);
    for (read, block) in program.blocks.iter().zip(&blocks) {
        assert_eq!(read.block.movement, block.movement, "{}", listing.program);
        assert_eq!(read.block.compensation, block.compensation, "{}", listing.program);
    }
    let again = print_blocks(&program.blocks.into_iter().map(|read| read.block).collect::<Vec<_>>(), &profile);
    assert_eq!(again.map(|again| again.program).ok(), Some(listing.program), "a listing is written the same again");
}

/// The safety verdict, which knows no rules, of the implementation's path and of the model's: an answer that the judge
/// finds exact gouges no deeper than the exact path.
pub fn safety(bytes: &[u8]) {
    let Some(Edited { profile, blocks }) = Edited::from_bytes(bytes) else { return };
    let judged = judge(&mut Builtin, &profile.parameters, &blocks, &BUDGET);
    ledger::note(&judged.exact);
    let (Verdict::Exact, Some(answer)) = (&judged.verdict, &judged.answer) else { return };
    let contour = || {
        let contour = Contour::of(&blocks);
        judged.exact.alarm.map_or_else(|| contour.clone(), |alarm| contour.clone().before(alarm.block))
    };
    let exact: Vec<_> = judged.exact.steps.iter().map(|step| step.map(Real::to_f64)).collect();
    let exact = check(&contour(), &exact, GOUGE);
    if !safe(&exact) {
        return;
    }
    let device = check(&contour(), &answer.steps, GOUGE + 2.0 * BUDGET.delta);
    if matches!(device.path, Finding::Gouges(_)) && shrinks_to_nothing(&judged.exact, BUDGET.beta(&blocks)) {
        ledger::waived();
        return;
    }
    assert!(
        !matches!(device.path, Finding::Gouges(_)),
        "{}: exact {exact:?}, device {device:?}\n{}",
        profile.name,
        written(&blocks, &profile)
    );
}

fn safe(verdict: &SafetyVerdict) -> bool {
    matches!(verdict.path, Finding::Safe { .. })
}

/// A device with a fault that shows only near the boundary of one decision: whoever cannot find it has not looked there.
#[derive(Clone, Copy, Debug)]
pub struct Planted {
    /// The decision.
    pub kind: DecisionKind,
    /// How near, in millimetres; exactly on the boundary all is well.
    pub within: f64,
}

impl Device for Planted {
    fn name(&self) -> &str {
        "planted"
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answer = Builtin.answer(parameters, blocks)?;
        let near = run(parameters, blocks).decisions.iter().any(|(decision, _)| {
            let (low, high) = decision.margin.filter();
            decision.kind == self.kind && decision.exact.is_ne() && low.abs().max(high.abs()) < self.within
        });
        if near {
            for step in &mut answer.steps {
                if let Segment::Line { end } | Segment::Arc { end, .. } = &mut step.segment {
                    end[0] += 0.01;
                }
            }
        }
        Ok(answer)
    }
}

/// The device with a planted fault: this target must find it. `RADCOMP_PLANTED` names the decision; offsets-meet if it
/// names none.
pub fn planted(bytes: &[u8]) {
    let name = std::env::var("RADCOMP_PLANTED").unwrap_or_default();
    let kind = DecisionKind::ALL.iter().copied().find(|kind| kind.id() == name).unwrap_or(DecisionKind::OffsetsMeet);
    judged(&mut Planted { kind, within: 1e-6 }, bytes);
}
