//! What the page draws: shapes in doubles, millimetres, coordinates of the plane. Nothing is decided here.

use std::cmp::Ordering;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Sink};
use radcomp_spec::{Advisory, Alarm, Block, Segment, Step};
use rug::Rational;
use serde_json::{Value, json};

use crate::explain::{Axes, Source};
use crate::plot::{Form, MarkKind, Piece, Scene, Trace};

/// A scene whose parts know their blocks.
pub(super) struct Drawing {
    scene: Scene,
    blocks: usize,
    /// The block of each piece of the contour.
    contour: Vec<usize>,
    /// The block of each mark.
    marked: Vec<usize>,
    /// The block of each place of the tool.
    placed: Vec<usize>,
    /// The tool's radius at the end of each element of the path that has a vector there.
    radii: Vec<Option<f64>>,
}

impl Drawing {
    /// A drawing without blocks.
    pub(super) fn new(axes: Axes) -> Self {
        Drawing {
            scene: Scene::new(axes),
            blocks: 0,
            contour: Vec::new(),
            marked: Vec::new(),
            placed: Vec::new(),
            radii: Vec::new(),
        }
    }

    /// The next block, before the engine reads it.
    pub(super) fn read(&mut self, block: &Block<Rational>, source: &Source, axes: Axes) {
        self.scene.read(block, source, axes);
        self.contour.resize(self.scene.programmed.len(), self.blocks);
        self.blocks += 1;
    }

    /// The alarm that stopped the tool.
    pub(super) fn alarm(&mut self, alarm: Alarm) {
        self.scene.alarm(alarm);
        self.marked.resize(self.scene.marks.len(), alarm.block);
    }

    /// The greatest tool radius, in millimetres.
    pub(super) fn radius(&self) -> f64 {
        self.scene.radius
    }

    /// The programmed contour.
    pub(super) fn programmed(&self) -> Vec<Value> {
        let pieces = self.scene.programmed.iter().zip(&self.contour);
        pieces.map(|(piece, block)| json!({ "block": block, "shape": shape(piece) })).collect()
    }

    /// The shapes of the centre path, one for each element that moves, and the tool's radius at its end.
    pub(super) fn path(&self) -> impl Iterator<Item = (Value, Option<f64>)> {
        self.scene.path.iter().map(shape).zip(self.radii.iter().copied())
    }

    /// The places of the tool at its vectors.
    pub(super) fn tools(&self) -> Vec<Value> {
        let tools = self.scene.vectors.iter().zip(&self.placed);
        tools.map(|((at, radius), block)| json!({ "block": block, "at": at, "radius": radius })).collect()
    }

    /// Warnings and the alarm.
    pub(super) fn marks(&self) -> Vec<Value> {
        let marks = self.scene.marks.iter().zip(&self.marked);
        let kind = |kind| if kind == MarkKind::Alarm { "alarm" } else { "advisory" };
        let mark = |mark: &crate::plot::Mark, block| json!({ "block": block, "at": mark.point, "text": mark.text, "kind": kind(mark.kind) });
        marks.map(|(each, block)| mark(each, block)).collect()
    }
}

impl Sink for Drawing {
    fn step(&mut self, step: Step<Real>) {
        let block = step.block;
        self.scene.step(step);
        let placed = self.placed.len() < self.scene.vectors.len();
        self.placed.resize(self.scene.vectors.len(), block);
        let radius = self.scene.vectors.last().filter(|_| placed).map(|(_, radius)| *radius);
        self.radii.resize(self.scene.path.len(), radius);
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        let block = advisory.block;
        self.scene.advisory(advisory);
        self.marked.resize(self.scene.marks.len(), block);
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        decision.exact
    }
}

/// A piece: its trace, its ends, and of an arc its centre, its radius and the angle that it sweeps, in radians, positive
/// counter-clockwise.
pub(super) fn shape(piece: &Piece) -> Value {
    let mut record = json!({ "trace": trace(piece.trace), "from": piece.start, "to": piece.end });
    if let (Form::Arc { centre, .. }, Some(radius), Some((_, sweep))) = (piece.form, piece.radius(), piece.sweep()) {
        record["about"] = json!(centre);
        record["radius"] = json!(radius);
        record["sweep"] = json!(sweep);
    }
    record
}

/// A device's path, drawn.
pub(super) fn steps(path: &[Step<f64>]) -> Vec<Value> {
    let mut at = [0.0, 0.0];
    let piece = |step: &Step<f64>| {
        let (end, form) = match step.segment {
            Segment::Hold => return None,
            Segment::Line { end } => (end, Form::Straight),
            Segment::Arc { end, centre, direction, full } => (end, Form::Arc { centre, direction, full }),
        };
        let start = std::mem::replace(&mut at, end);
        let trace = if step.main { Trace::Compensated } else { Trace::Corner };
        Some(json!({ "block": step.block, "shape": shape(&Piece { start, end, form, trace }) }))
    };
    path.iter().filter_map(piece).collect()
}

/// The name of a trace in the page's style sheet.
fn trace(trace: Trace) -> &'static str {
    match trace {
        Trace::Programmed => "programmed",
        Trace::Lead => "lead",
        Trace::Followed => "followed",
        Trace::Refused => "refused",
        Trace::Compensated => "compensated",
        Trace::Corner => "corner",
        Trace::Uncompensated => "uncompensated",
        Trace::Rapid => "rapid",
    }
}
