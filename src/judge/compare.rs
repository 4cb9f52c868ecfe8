//! Comparison of a device's path with one outcome of the model.

use radcomp_model::Run;
use radcomp_spec::{Alarm, Clause, Segment, Step};

use super::stroke::{Shape, Stroke, distance, strokes};
use crate::device::Answer;

/// The first place where a device's answer differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Divergence {
    /// Index of the block.
    pub block: usize,
    /// The clause that makes the expected element.
    pub clause: Clause,
    /// What differs.
    pub difference: Difference,
    /// The expected element, if there is one.
    pub expected: Option<Stroke>,
    /// The element in the device's answer, if there is one.
    pub observed: Option<Stroke>,
}

/// What differs.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// A number that is not finite.
    NotFinite,
    /// The device's path ends early.
    Missing,
    /// The device's path goes on.
    Surplus,
    /// The kind of element, the sense of an arc, or rapid traverse.
    Kind,
    /// The block that the element belongs to.
    Block,
    /// The end point, by so many millimetres.
    End(f64),
    /// The centre of an arc, by so many millimetres.
    Centre(f64),
    /// The place where a block without movement is executed, by so many millimetres.
    Place(f64),
    /// The alarm: expected and observed.
    Alarm(Option<Alarm>, Option<Alarm>),
}

/// The model's outcome in f64, each coordinate within one unit in the last place.
pub(crate) fn rounded(run: &Run) -> Vec<Step<f64>> {
    let point = |[a, b]: &[radcomp_model::number::Real; 2]| [a.to_f64(), b.to_f64()];
    run.steps
        .iter()
        .map(|step| Step {
            block: step.block,
            clause: step.clause,
            rapid: step.rapid,
            main: step.main,
            segment: match &step.segment {
                Segment::Hold => Segment::Hold,
                Segment::Line { end } => Segment::Line { end: point(end) },
                Segment::Arc { end, centre, direction, full } => {
                    Segment::Arc { end: point(end), centre: point(centre), direction: *direction, full: *full }
                }
            },
        })
        .collect()
}

/// The first divergence of a device's answer from an outcome, if any is larger than `delta`.
pub(crate) fn divergence(run: &Run, answer: &Answer, delta: f64) -> Option<Divergence> {
    if let Some(divergence) = not_finite(answer) {
        return Some(divergence);
    }
    let expected = strokes(&rounded(run), delta, true);
    if let Some(divergence) = first_difference(&expected, &strokes(&answer.steps, delta, true), delta, true) {
        return Some(divergence);
    }
    if run.alarm != answer.alarm {
        let alarm = run.alarm.or(answer.alarm)?;
        return Some(Divergence {
            block: alarm.block,
            clause: alarm.kind.clause(),
            difference: Difference::Alarm(run.alarm, answer.alarm),
            expected: None,
            observed: None,
        });
    }
    None
}

/// What differs between two paths, in words. Without `blocks`, lines are merged across blocks, and it does not matter
/// which block an element belongs to.
pub(crate) fn path_difference(
    expected: &[Step<f64>],
    observed: &[Step<f64>],
    delta: f64,
    blocks: bool,
) -> Option<String> {
    let (expected, observed) = (strokes(expected, delta, blocks), strokes(observed, delta, blocks));
    let divergence = first_difference(&expected, &observed, delta, blocks)?;
    Some(format!("{} at block {}: {:?}", divergence.clause, divergence.block + 1, divergence.difference))
}

fn first_difference(expected: &[Stroke], observed: &[Stroke], delta: f64, blocks: bool) -> Option<Divergence> {
    let (mut expected, mut observed) = (expected.iter().peekable(), observed.iter().peekable());
    while expected.peek().is_some() || observed.peek().is_some() {
        let (here, there) = (expected.peek().copied(), observed.peek().copied());
        if let Some(difference) = differ(here, there, delta, blocks) {
            // A move hardly longer than δ may stand on one side and be forgotten on the other.
            if here.is_some_and(|stroke| is_short(stroke, delta)) {
                expected.next();
                continue;
            }
            if there.is_some_and(|stroke| is_short(stroke, delta)) {
                observed.next();
                continue;
            }
            let place = here.or(there)?;
            return Some(Divergence {
                block: place.block,
                clause: place.clause,
                difference,
                expected: here.copied(),
                observed: there.copied(),
            });
        }
        expected.next();
        observed.next();
    }
    None
}

fn differ(expected: Option<&Stroke>, observed: Option<&Stroke>, delta: f64, blocks: bool) -> Option<Difference> {
    let (expected, observed) = match (expected, observed) {
        (Some(expected), Some(observed)) => (expected, observed),
        (Some(_), None) => return Some(Difference::Missing),
        _ => return Some(Difference::Surplus),
    };
    let off = distance(expected.to, observed.to);
    match (expected.shape, observed.shape) {
        (Shape::Hold, Shape::Hold) if off > delta => return Some(Difference::Place(off)),
        (Shape::Hold, Shape::Hold) => return (blocks && expected.block != observed.block).then_some(Difference::Block),
        (Shape::Line, Shape::Line) => {}
        (Shape::Arc { centre: c1, direction: d1, full: f1 }, Shape::Arc { centre: c2, direction: d2, full: f2 }) => {
            if d1 != d2 || f1 != f2 {
                return Some(Difference::Kind);
            }
            if distance(c1, c2) > delta {
                return Some(Difference::Centre(distance(c1, c2)));
            }
        }
        _ => return Some(Difference::Kind),
    }
    if expected.rapid != observed.rapid {
        return Some(Difference::Kind);
    }
    if off > delta {
        return Some(Difference::End(off));
    }
    (blocks && expected.block != observed.block).then_some(Difference::Block)
}

fn is_short(stroke: &Stroke, delta: f64) -> bool {
    match stroke.shape {
        Shape::Line | Shape::Arc { full: false, .. } => distance(stroke.from, stroke.to) <= 2.0 * delta,
        Shape::Arc { full: true, .. } | Shape::Hold => false,
    }
}

fn not_finite(answer: &Answer) -> Option<Divergence> {
    let step = answer.steps.iter().find(|step| match step.segment {
        Segment::Hold => false,
        Segment::Line { end } => end.iter().any(|value| !value.is_finite()),
        Segment::Arc { end, centre, .. } => end.iter().chain(&centre).any(|value| !value.is_finite()),
    })?;
    Some(Divergence {
        block: step.block,
        clause: step.clause,
        difference: Difference::NotFinite,
        expected: None,
        observed: None,
    })
}
