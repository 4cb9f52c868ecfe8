//! Metamorphic checks: what a device answers to a moved program must be its answer moved.
//!
//! They need no model of the rules, only the margins that tell where a device may change its mind: a program with a
//! decision inside the band is passed over, since there the two answers may take different branches. Everywhere else
//! a translation by decimals, a mirroring with the sides swapped, a scaling by ten, a rotation by a Pythagorean angle,
//! the splitting of a straight block, and running the contour backwards on the tool's other side leave the branches
//! alone, and points follow to within δ. Passed over as well
//! are programs whose vectors lie more than 100 mm from their corner, splits that make a half of the line run
//! backwards, and differences that inputs within the band explain: a change of the program by β moves some point of its
//! path by more than δ.

mod motion;
mod reversal;
mod split;

pub use motion::Motion;
pub use reversal::Reversal;
use split::is_by_whole_blocks;
pub use split::split;

use radcomp_model::number::Real;
use radcomp_model::{Run, run, run_on_inputs};
use radcomp_spec::{AdvisoryKind, Block, DecisionKind, Parameters, Segment, Step};
use rug::Rational;

use crate::device::{Answer, Device, DeviceFault, ask};
use crate::judge::{Budget, Tolerance, path_difference};

/// A relation that a device breaks.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// The relation.
    pub relation: &'static str,
    /// The changed program.
    pub program: Vec<Block<Rational>>,
    /// What differs, in words.
    pub difference: String,
}

/// The motions that are tried.
pub fn motions() -> Vec<Motion> {
    vec![
        Motion::translation(123_457, -76_543),
        Motion::translation(-500_001, 300_007),
        Motion::mirroring(),
        Motion::scaling(),
        Motion::rotation(3, 4, 5),
        Motion::rotation(-5, 12, 13),
        Motion::rotation(0, -1, 1),
    ]
}

/// Checks one program; the relations that the device breaks. Answers nothing for programs with a decision in the band
/// of the program or of one of its images, and where the device gives no answer.
pub fn check(
    device: &mut dyn Device,
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    budget: &Budget,
) -> Vec<Broken> {
    // The tool starts at the origin, which a motion would have to move too.
    let mut blocks = blocks.to_vec();
    blocks.insert(0, approach());
    let exact = run(parameters, &blocks);
    if decides_within(&exact, budget.beta(&blocks) * 16.0) || is_sensitive(&exact) {
        return Vec::new();
    }
    let Ok(answer) = ask(device, parameters, &blocks) else { return Vec::new() };
    let mut broken = Vec::new();
    for motion in motions() {
        let program: Vec<_> = blocks.iter().map(|block| motion.block(block)).collect();
        let Some(scaled) = motion.parameters(parameters) else { continue };
        let image = run(&scaled, &program);
        if decides_within(&image, budget.beta(&program) * 16.0) {
            continue;
        }
        // A control keeps its settings: where a limit of a length decides otherwise now, it is right to as well.
        if scaled != *parameters && !is_alike(&run(parameters, &program), &image) {
            continue;
        }
        let expected = moved(&answer, &motion);
        let delta = budget.delta * f64::from(motion.scale);
        let difference = compare(ask(device, &scaled, &program), &expected, delta, true)
            .filter(|_| !is_loose(&scaled, &program, budget.beta(&program), delta));
        broken.extend(difference.map(|difference| Broken { relation: motion.name, program, difference }));
    }
    if let Some(program) = split(parameters, &blocks, &exact)
        && let image = run(parameters, &program)
        && !runs_backwards(&image)
        && !is_by_whole_blocks(&image)
        && !decides_within(&image, budget.beta(&program) * 16.0)
    {
        let difference = compare(ask(device, parameters, &program), &answer, budget.delta, false)
            .filter(|_| !is_loose(parameters, &program, budget.beta(&program), budget.delta));
        broken.extend(difference.map(|difference| Broken { relation: "splitting a line", program, difference }));
    }
    broken.extend(check_reversal(device, parameters, &blocks, budget));
    broken
}

/// Whether the device runs the first contour backwards as it runs it forwards, where the rules do.
fn check_reversal(
    device: &mut dyn Device,
    parameters: &Parameters,
    blocks: &[Block<Rational>],
    budget: &Budget,
) -> Option<Broken> {
    let Reversal { forward, backward } = Reversal::of(blocks)?;
    let exact = [run(parameters, &forward), run(parameters, &backward)];
    let programs = [&forward, &backward];
    let in_band = |(run, program): (&Run, &&Vec<_>)| decides_within(run, budget.beta(program) * 16.0);
    if exact.iter().any(|run| run.alarm.is_some() || is_sensitive(run)) || exact.iter().zip(&programs).any(in_band) {
        return None;
    }
    let tolerance = Tolerance::new(budget.delta, 0.0);
    let differ =
        |there: &[Step<f64>], back: &[Step<f64>]| path_difference(&reversal::reversed(there), back, tolerance, false);
    // Some rules know before and after: look-ahead, the corner that a change of side makes, start-up and cancel of
    // different types.
    if differ(&Answer::from(&exact[0]).steps, &Answer::from(&exact[1]).steps).is_some() {
        return None;
    }
    let [there, back] = programs.map(|program| ask(device, parameters, program).ok());
    let difference = differ(&there?.steps, &back?.steps)?;
    if is_loose(parameters, &backward, budget.beta(&backward), budget.delta) {
        return None;
    }
    Some(Broken { relation: "running backwards", program: backward, difference })
}

fn approach() -> Block<Rational> {
    let end = [Rational::from((777, 10)), Rational::from((-333, 10))];
    Block::moving(radcomp_spec::Movement::Line { end })
}

/// Whether a decision that shapes the path lies in the band. An exact zero counts too, but for decisions on whose two
/// sides the path is the same: an image of it may be rounded to either side.
fn decides_within(run: &Run, beta: f64) -> bool {
    use DecisionKind::{Moves, RightAngle, Turn, WholeTurn};
    run.decisions.iter().any(|(decision, _)| {
        let (low, high) = decision.margin.filter();
        let zero = low == 0.0 && high == 0.0;
        let alike = zero && matches!(decision.kind, Moves | RightAngle | Turn | WholeTurn);
        decision.kind.shapes_the_path() && low <= beta && high >= -beta && !alike
    })
}

/// Vectors so far from their corner that a change in the last place of a coordinate moves them by more than a
/// millionth of a millimetre: a program of that kind has no answer that a device could keep.
fn is_sensitive(run: &Run) -> bool {
    let far = Rational::from(FAR);
    run.advisories
        .iter()
        .any(|advisory| advisory.kind == AdvisoryKind::FarIntersection && advisory.amount > Real::rational(far.clone()))
}

/// Whether inputs within β of the program may move a point of its path by more than δ, all in millimetres.
fn is_loose(parameters: &Parameters, program: &[Block<Rational>], beta: f64, delta: f64) -> bool {
    let wide = |number: &Real| {
        let (low, high) = number.reach(beta);
        // Not a number where nothing is known.
        (high - low).partial_cmp(&(2.0 * delta)).is_none_or(core::cmp::Ordering::is_gt)
    };
    run_on_inputs(parameters, program).steps.iter().any(|step| match &step.segment {
        Segment::Hold => false,
        Segment::Line { end } => end.iter().any(wide),
        Segment::Arc { end, centre, .. } => end.iter().chain(centre).any(wide),
    })
}

/// A tenth of a metre, in millimetres.
const FAR: u32 = 100;

/// Whether two outcomes of one program have the same path and alarm.
fn is_alike(x: &Run, y: &Run) -> bool {
    x.alarm == y.alarm
        && path_difference(&Answer::from(x).steps, &Answer::from(y).steps, Tolerance::new(0.0, 0.0), true).is_none()
}

/// Half of a line can run backwards where the whole does not.
fn runs_backwards(run: &Run) -> bool {
    use AdvisoryKind::{ReversedArc, ReversedLine};
    run.alarm.is_some() || run.advisories.iter().any(|advisory| matches!(advisory.kind, ReversedLine | ReversedArc))
}

fn moved(answer: &Answer, motion: &Motion) -> Answer {
    let steps = answer
        .steps
        .iter()
        .map(|step| Step { segment: motion.segment(&step.segment, |point| motion.rounded(point)), ..step.clone() });
    Answer { steps: steps.collect(), alarm: answer.alarm }
}

/// What differs between two answers, in words; with `blocks`, also where each element belongs.
fn compare(answer: Result<Answer, DeviceFault>, expected: &Answer, delta: f64, blocks: bool) -> Option<String> {
    let answer = match answer {
        Ok(answer) => answer,
        Err(DeviceFault::Unsupported(_)) => return None,
        Err(fault) => return Some(format!("no answer to the moved program; {fault}")),
    };
    let kinds = (answer.alarm.map(|alarm| alarm.kind), expected.alarm.map(|alarm| alarm.kind));
    if kinds.0 != kinds.1 {
        return Some(format!("alarm {:?} instead of {:?}", kinds.0, kinds.1));
    }
    path_difference(&expected.steps, &answer.steps, Tolerance::new(delta, 0.0), blocks)
}
