//! Comparison of a device's path with one outcome of the model.

use radcomp_model::Run;
use radcomp_spec::{Alarm, Clause, Segment, Step};

use super::stroke::{Extent, Shape, Stroke, Tolerance, continues, distance, strokes};
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
    /// What of the outcome has a part in it.
    pub(crate) parting: Parting,
}

/// Where an answer parts from an outcome, in path elements of the outcome.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Parting {
    /// Those before it, in their order, that the answer has too, and could not have forgotten.
    pub(crate) agreed: Vec<usize>,
    /// The one that has to change, or one before it.
    pub(crate) settled: usize,
    /// The block whose end lies elsewhere in the answer, which goes on behind it: only what moves that end, or stops the
    /// path before, could bring the two together, and the answer does not stop there.
    pub(crate) vector: Option<usize>,
}

impl Parting {
    /// An answer that every decision may have a part in.
    pub(crate) fn anywhere() -> Parting {
        Parting { agreed: Vec::new(), settled: usize::MAX, vector: None }
    }

    /// The last path element before this one that the answer has too.
    pub(crate) fn agreed_before(&self, element: usize) -> Option<usize> {
        let count = self.agreed.partition_point(|agreed| *agreed < element);
        count.checked_sub(1).map(|last| self.agreed[last])
    }
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

/// The first divergence of a device's answer from an outcome, if any is larger than the tolerance.
pub(crate) fn divergence(run: &Run, answer: &Answer, tolerance: Tolerance) -> Option<Divergence> {
    if let Some(divergence) = not_finite(answer) {
        return Some(divergence);
    }
    let expected = strokes(&Answer::from(run).steps, tolerance, true);
    let observed = strokes(&answer.steps, tolerance, true);
    let agreed = match first_difference(&expected, &observed, tolerance, true) {
        Ok(agreed) => agreed,
        Err(mut divergence) => {
            divergence.parting.settled = divergence.expected.map_or(usize::MAX, |here| last_of(run, here.block));
            return Some(*divergence);
        }
    };
    if run.alarm != answer.alarm {
        let alarm = run.alarm.or(answer.alarm)?;
        return Some(Divergence {
            block: alarm.block,
            clause: alarm.kind.clause(),
            difference: Difference::Alarm(run.alarm, answer.alarm),
            expected: None,
            observed: None,
            parting: Parting { agreed, settled: usize::MAX, vector: None },
        });
    }
    None
}

/// What differs between two paths, in words. Without `blocks`, lines are merged across blocks, and it does not matter
/// which block an element belongs to.
pub(crate) fn path_difference(
    expected: &[Step<f64>],
    observed: &[Step<f64>],
    tolerance: Tolerance,
    blocks: bool,
) -> Option<String> {
    let (expected, observed) = (strokes(expected, tolerance, blocks), strokes(observed, tolerance, blocks));
    let divergence = first_difference(&expected, &observed, tolerance, blocks).err()?;
    Some(format!("{} at block {}: {:?}", divergence.clause, divergence.block + 1, divergence.difference))
}

/// The path elements that two paths have in common, as in [`Parting::agreed`], or where they part.
fn first_difference(
    expected: &[Stroke],
    observed: &[Stroke],
    tolerance: Tolerance,
    blocks: bool,
) -> Result<Vec<usize>, Box<Divergence>> {
    let mut agreed = Vec::new();
    let (mut i, mut j) = (0, 0);
    // Where both stood when they last agreed.
    let (mut here_at, mut there_at) = ([0.0, 0.0], [0.0, 0.0]);
    while i < expected.len() || j < observed.len() {
        let (here, there) = (expected.get(i), observed.get(j));
        let Some(difference) = differ(here, there, tolerance, blocks) else {
            (here_at, there_at) =
                (here.map_or(here_at, |stroke| stroke.to), there.map_or(there_at, |stroke| stroke.to));
            if let (Some(here), Some(there)) = (here, there)
                && !is_short(there, there.from, tolerance)
            {
                agreed.push(here.step);
            }
            (i, j) = (i + 1, j + 1);
            continue;
        };
        // Lines that hardly turn may be one on one side, and two on the other.
        if let (Some(_), Some(next)) =
            (here.filter(|here| hardly_turns(here, expected.get(i + 1), tolerance, blocks)), there)
            && differ(expected.get(i + 1), Some(next), tolerance, blocks).is_none()
        {
            i += 1;
            continue;
        }
        if let (Some(next), Some(_)) =
            (here, there.filter(|there| hardly_turns(there, observed.get(j + 1), tolerance, blocks)))
            && differ(Some(next), observed.get(j + 1), tolerance, blocks).is_none()
        {
            j += 1;
            continue;
        }
        // A move hardly longer than δ may stand on one side and be forgotten on the other.
        if here.is_some_and(|stroke| is_short(stroke, here_at, tolerance)) {
            i += 1;
            continue;
        }
        if there.is_some_and(|stroke| is_short(stroke, there_at, tolerance)) {
            j += 1;
            continue;
        }
        let Some(place) = here.or(there) else { break };
        let vector = here.map(|stroke| stroke.block);
        let vector = vector.filter(|block| ends_elsewhere(*block, expected, observed, tolerance));
        return Err(Box::new(Divergence {
            block: place.block,
            clause: place.clause,
            difference,
            expected: here.copied(),
            observed: there.copied(),
            parting: Parting { agreed, settled: usize::MAX, vector },
        }));
    }
    Ok(agreed)
}

/// Whether the next line goes on along this one, within twice what makes them one stroke.
fn hardly_turns(stroke: &Stroke, next: Option<&Stroke>, tolerance: Tolerance, blocks: bool) -> bool {
    next.is_some_and(|next| next.shape == Shape::Line && continues(stroke, next, 2.0 * tolerance.delta, blocks))
}

/// The last path element of a block: those of one block are settled together, before any decision on what is behind.
fn last_of(run: &Run, block: usize) -> usize {
    run.steps.iter().rposition(|step| step.block == block).unwrap_or(usize::MAX)
}

/// How many times δ the ends of a block lie from each other that no short moves explain.
const ELSEWHERE: f64 = 8.0;

/// Whether both paths have moves of a block, the answer has others behind, and the block ends at two places.
fn ends_elsewhere(block: usize, expected: &[Stroke], observed: &[Stroke], tolerance: Tolerance) -> bool {
    let last = |strokes: &[Stroke]| strokes.iter().rposition(|stroke| stroke.block == block);
    let (Some(here), Some(there)) = (last(expected), last(observed)) else { return false };
    let mut behind = observed[there + 1..].iter();
    distance(expected[here].to, observed[there].to) > ELSEWHERE * tolerance.delta
        && behind.any(|stroke| stroke.block > block && !is_short(stroke, stroke.from, tolerance))
}

fn differ(
    expected: Option<&Stroke>,
    observed: Option<&Stroke>,
    tolerance: Tolerance,
    blocks: bool,
) -> Option<Difference> {
    let (expected, observed) = match (expected, observed) {
        (Some(expected), Some(observed)) => (expected, observed),
        (Some(_), None) => return Some(Difference::Missing),
        _ => return Some(Difference::Surplus),
    };
    let off = distance(expected.to, observed.to);
    let is_off = off > tolerance.at(observed.to);
    match (expected.shape, observed.shape) {
        (Shape::Hold, Shape::Hold) if is_off => return Some(Difference::Place(off)),
        (Shape::Hold, Shape::Hold) => return (blocks && expected.block != observed.block).then_some(Difference::Block),
        (Shape::Line, Shape::Line) => {}
        (Shape::Arc { centre: c1, direction: d1, full: f1 }, Shape::Arc { centre: c2, direction: d2, full: f2 }) => {
            let near = 2.0 * tolerance.delta;
            let extents = (expected.extent(near, 0.0), observed.extent(near, tolerance.grain));
            if d1 != d2 || f1 != f2 || !extents.0.agrees(extents.1) {
                return Some(Difference::Kind);
            }
            if distance(c1, c2) > tolerance.at(c2) {
                return Some(Difference::Centre(distance(c1, c2)));
            }
        }
        _ => return Some(Difference::Kind),
    }
    if expected.rapid != observed.rapid {
        return Some(Difference::Kind);
    }
    if is_off {
        return Some(Difference::End(off));
    }
    (blocks && expected.block != observed.block).then_some(Difference::Block)
}

/// Whether a stroke, seen from where the paths last agreed, is a move of hardly any length.
fn is_short(stroke: &Stroke, agreed: [f64; 2], tolerance: Tolerance) -> bool {
    let near = 2.0 * tolerance.delta;
    match stroke.shape {
        Shape::Line => distance(agreed, stroke.to) <= near,
        Shape::Arc { full: false, .. } => {
            distance(agreed, stroke.to) <= near
                && distance(stroke.from, stroke.to) <= near
                && stroke.extent(near, tolerance.grain) != Extent::Long
        }
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
        parting: Parting { agreed: Vec::new(), settled: 0, vector: None },
    })
}
