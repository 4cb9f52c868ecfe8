//! What is drawn of a failure, gathered from its case.

use radcomp_model::number::nearest_f64;
use radcomp_model::run;
use radcomp_spec::block::Point;
use radcomp_spec::{Block, Compensation, Parameters, Segment, Step};
use rug::Rational;

use crate::device::Answer;
use crate::explain::{Programmed, Shape};
use crate::judge::rounded;
use crate::plot::piece::{Form, Piece, Trace};
use crate::report::Case;

/// Contour, both paths, and where they part.
#[derive(Debug)]
pub(super) struct Gathered {
    /// The programmed contour; start-up and cancel moves are [`Trace::Lead`].
    pub(super) contour: Vec<Piece>,
    /// The programmed end points with the names of their blocks.
    pub(super) names: Vec<(Point<f64>, String)>,
    /// The exact path, rounded.
    pub(super) expected: Vec<Piece>,
    /// The device's path, as far as its numbers are finite.
    pub(super) observed: Vec<Piece>,
    /// The first element that differs, in both.
    pub(super) expected_piece: Option<Piece>,
    pub(super) observed_piece: Option<Piece>,
    /// Their ends.
    pub(super) expected_end: Option<Point<f64>>,
    pub(super) observed_end: Option<Point<f64>>,
    /// Where alarms stop the tool.
    pub(super) alarms: Vec<Point<f64>>,
    /// The tool's radius at the first element that differs.
    pub(super) radius: f64,
    /// The difference in words.
    pub(super) told: String,
}

/// A coordinate beyond is not drawn.
const FARTHEST: f64 = 1e9;

/// Gathers what a case shows.
pub(super) fn gather(case: &Case, parameters: &Parameters) -> Gathered {
    let blocks: Vec<Block<Rational>> = case.program.iter().map(Block::from).collect();
    let exact = run(parameters, &blocks);
    let answer = case.answer.as_ref().map(Answer::from).unwrap_or_default();
    let (expected, observed) = (pieces(&rounded(&exact)), pieces(&answer.steps));
    let end = |end: Option<[crate::report::Binary; 2]>| {
        end.map(|point| point.map(|value| value.0)).filter(|point| point.iter().all(|value| is_drawn(*value)))
    };
    let divergence = case.divergence.as_ref();
    let expected_end = end(divergence.and_then(|divergence| divergence.expected_end));
    let observed_end = end(divergence.and_then(|divergence| divergence.observed_end));
    let block = divergence.map_or(0, |divergence| divergence.block);
    let (contour, names, radius) = contour(&blocks, block);
    let last = |pieces: &[(usize, Piece)]| pieces.last().map_or([0.0, 0.0], |(_, piece)| piece.end);
    let mut alarms = Vec::new();
    alarms.extend(exact.alarm.map(|_| last(&expected)));
    alarms.extend(answer.alarm.map(|_| last(&observed)));
    Gathered {
        contour,
        names,
        expected_piece: element(&expected, block, expected_end),
        observed_piece: element(&observed, block, observed_end),
        expected: expected.into_iter().map(|(_, piece)| piece).collect(),
        observed: observed.into_iter().map(|(_, piece)| piece).collect(),
        expected_end,
        observed_end,
        alarms,
        radius,
        told: told(case),
    }
}

impl Gathered {
    /// Lowest and highest on each axis. A device's path may leave them: it may lie anywhere.
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        let mut bounds = [[0.0_f64, 0.0_f64]; 2];
        let mut hold = |point: Point<f64>| {
            for (range, value) in bounds.iter_mut().zip(point) {
                *range = [range[0].min(value), range[1].max(value)];
            }
        };
        self.contour.iter().chain(&self.expected).flat_map(Piece::extremes).for_each(&mut hold);
        let size = bounds.map(|[low, high]| high - low);
        let room = size[0].max(size[1]).max(self.radius).max(1e-6);
        let near = |point: &Point<f64>| {
            (0..2).all(|axis| (bounds[axis][0] - room..=bounds[axis][1] + room).contains(&point[axis]))
        };
        let near: Vec<_> = self.observed.iter().flat_map(Piece::extremes).filter(near).collect();
        for (range, axis) in bounds.iter_mut().zip(0..2) {
            near.iter().for_each(|point| *range = [range[0].min(point[axis]), range[1].max(point[axis])]);
        }
        bounds
    }

    /// The middle and half the side of the square that is magnified: both ends, if they lie near each other.
    pub(super) fn focus(&self) -> (Point<f64>, f64) {
        let bounds = self.bounds();
        let size = (bounds[0][1] - bounds[0][0]).max(bounds[1][1] - bounds[1][0]).max(1e-6);
        let alarm = self.alarms.first().copied();
        let tool = if self.radius > 0.0 { 4.0 * self.radius } else { size };
        let around = tool.min(size / 10.0);
        match (self.expected_end, self.observed_end) {
            (Some(p), Some(q)) => {
                let apart = (p[0] - q[0]).hypot(p[1] - q[1]);
                let middle = [p[0].midpoint(q[0]), p[1].midpoint(q[1])];
                // Below a few units in the last place there is nothing to see.
                let least = 1e-13 * (1.0 + p[0].abs().max(p[1].abs()));
                if apart == 0.0 { (p, size / 16.0) } else { (middle, (0.8 * apart).clamp(least, size / 5.0)) }
            }
            (Some(p), None) | (None, Some(p)) => (alarm.unwrap_or(p), around),
            (None, None) => (alarm.unwrap_or([0.0, 0.0]), around),
        }
    }
}

fn is_drawn(value: f64) -> bool {
    value.abs() <= FARTHEST
}

/// The pieces of a path, each with its block, up to the first number that cannot be drawn.
fn pieces(steps: &[Step<f64>]) -> Vec<(usize, Piece)> {
    let mut at = [0.0, 0.0];
    let mut pieces = Vec::new();
    for step in steps {
        let (end, form, numbers) = match &step.segment {
            Segment::Hold => continue,
            Segment::Line { end } => (*end, Form::Straight, *end),
            Segment::Arc { end, centre, direction, full } => {
                (*end, Form::Arc { centre: *centre, direction: *direction, full: *full }, *centre)
            }
        };
        if !end.iter().chain(&numbers).all(|value| is_drawn(*value)) {
            break;
        }
        let trace = if step.main { Trace::Compensated } else { Trace::Corner };
        pieces.push((step.block, Piece { start: at, end, form, trace }));
        at = end;
    }
    pieces
}

/// The element of a block that ends there.
fn element(pieces: &[(usize, Piece)], block: usize, end: Option<Point<f64>>) -> Option<Piece> {
    let end = end?;
    let ends = || pieces.iter().filter(|(_, piece)| piece.end == end);
    let own = ends().find(|(owner, _)| *owner == block).or_else(|| ends().next());
    own.map(|(_, piece)| piece.clone())
}

type Named = Vec<(Point<f64>, String)>;

/// The programmed contour, the names of its blocks, and the radius in force at a block.
fn contour(blocks: &[Block<Rational>], block: usize) -> (Vec<Piece>, Named, f64) {
    let (mut pieces, mut names, mut radius) = (Vec::new(), Vec::new(), 0.0);
    let mut program = Programmed::new();
    let (mut side, mut started) = (false, false);
    for (index, read) in blocks.iter().enumerate() {
        if let Some(value) = read.radius.as_ref().filter(|_| index <= block) {
            radius = nearest_f64(value);
        }
        if let Some(compensation) = read.compensation {
            side = compensation != Compensation::Off;
        }
        let Some(programmed) = program.next(read) else { continue };
        let form = match programmed.shape {
            Shape::Line => Form::Straight,
            Shape::Arc { centre, direction, full } => Form::Arc { centre, direction, full },
            Shape::Dummy(_) | Shape::Direction(_) => continue,
        };
        let trace = if side == started { Trace::Programmed } else { Trace::Lead };
        started = side;
        pieces.push(Piece { start: programmed.start, end: programmed.end, form, trace });
        names.push((programmed.end, format!("N{}", index + 1)));
    }
    (pieces, names, radius)
}

/// A length in digits that are few, however short it is.
fn short(length: f64) -> String {
    if length < 1e-4 { format!("{length:.3e}") } else { format!("{length:.6}") }
}

/// What differs, in words.
fn told(case: &Case) -> String {
    let Some(divergence) = &case.divergence else {
        return format!("{}: {}", case.verdict, case.fault.as_deref().unwrap_or("no answer"));
    };
    let alarm = |alarm: Option<crate::report::AlarmRecord>| {
        alarm.map_or_else(|| "no alarm".to_owned(), |alarm| format!("{} at N{}", alarm.alarm.0.id(), alarm.block + 1))
    };
    let what = match (&*divergence.difference, divergence.off_mm) {
        ("alarm", _) => {
            format!("expected {}, observed {}", alarm(divergence.expected_alarm), alarm(divergence.observed_alarm))
        }
        ("not-finite", _) => "a number is not finite".to_owned(),
        ("missing", _) => "the path ends too early".to_owned(),
        ("surplus", _) => "the path goes on too far".to_owned(),
        ("kind", _) => "another kind of element".to_owned(),
        ("block", _) => "an element of another block".to_owned(),
        (what, Some(off)) => format!("{what} off by {} mm", short(off.0)),
        (what, None) => format!("{what} differs"),
    };
    format!("N{}, {}: {what}", divergence.block + 1, divergence.clause.0)
}
