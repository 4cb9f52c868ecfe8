//! What is drawn: gathered from the blocks as they are read and from what the model answers.

use radcomp_model::Sink;
use radcomp_model::number::{Real, nearest_f64};
use radcomp_spec::block::Point;
use radcomp_spec::{Advisory, AdvisoryKind, Alarm, Block, Compensation, Segment, Step, clause};
use rug::Rational;

use super::piece::{Form, Piece, Trace};
use crate::explain::{Axes, Coordinate, Programmed, ProgrammedMove, Shape, Source};

/// A program and its outcome, in doubles.
#[derive(Debug)]
pub struct Scene {
    /// The axes of the plane; those of the last block.
    pub axes: Axes,
    /// The programmed contour.
    pub programmed: Vec<Piece>,
    /// The path of the tool's centre.
    pub path: Vec<Piece>,
    /// The places of the tool's centre at its vectors, with the tool's radius.
    pub vectors: Vec<(Point<f64>, f64)>,
    /// The programmed end points with the names of their blocks.
    pub corners: Vec<(Point<f64>, String)>,
    /// Advisories and the alarm.
    pub marks: Vec<Mark>,
    /// The greatest tool radius, in millimetres.
    pub radius: f64,
    program: Programmed,
    tool: Point<f64>,
    blocks: Vec<Seen>,
    /// A side is in force, and a block that moves has been read since it came into force.
    side: bool,
    started: bool,
}

/// A place that is marked.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Where.
    pub point: Point<f64>,
    /// What it says.
    pub text: String,
    /// Of what kind.
    pub kind: MarkKind,
}

/// The kinds of marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// An advisory.
    Advisory,
    /// The alarm.
    Alarm,
}

/// What is kept of a block.
#[derive(Debug)]
struct Seen {
    name: String,
    programmed: Option<ProgrammedMove>,
    /// Index of its piece in the programmed contour.
    piece: Option<usize>,
    /// The radius in force, in millimetres.
    radius: f64,
}

impl Scene {
    /// A scene without blocks; the tool is at (0, 0).
    pub fn new(axes: Axes) -> Self {
        Scene {
            axes,
            programmed: Vec::new(),
            path: Vec::new(),
            vectors: Vec::new(),
            corners: Vec::new(),
            marks: Vec::new(),
            radius: 0.0,
            program: Programmed::new(),
            tool: [0.0, 0.0],
            blocks: Vec::new(),
            side: false,
            started: false,
        }
    }

    /// The next block, before the engine reads it.
    pub fn read(&mut self, block: &Block<Rational>, source: &Source, axes: Axes) {
        self.axes = axes;
        let name = match &source.sequence {
            Some(sequence) => format!("N{sequence}"),
            None => format!("line {}", source.line),
        };
        let before = self.blocks.last().map_or(0.0, |block| block.radius);
        let radius = block.radius.as_ref().map_or(before, |radius| nearest_f64(radius).abs());
        self.radius = self.radius.max(radius);
        if let Some(compensation) = block.compensation {
            self.side = compensation != Compensation::Off;
        }
        let programmed = self.program.next(block);
        let form = programmed.as_ref().and_then(|programmed| match programmed.shape {
            Shape::Line => Some(Form::Straight),
            Shape::Arc { centre, direction, full } => Some(Form::Arc { centre, direction, full }),
            Shape::Dummy(_) | Shape::Direction(_) => None,
        });
        let mut piece = None;
        if let (Some(form), Some(programmed)) = (form, &programmed) {
            piece = Some(self.programmed.len());
            let (start, end) = (programmed.start, programmed.end);
            let trace = if self.side == self.started { Trace::Programmed } else { Trace::Lead };
            self.started = self.side;
            self.programmed.push(Piece { start, end, form, trace });
            self.corners.push((end, name.clone()));
        }
        self.blocks.push(Seen { name, programmed, piece, radius });
    }

    /// The alarm that stopped the tool.
    pub fn alarm(&mut self, alarm: Alarm) {
        let Some(block) = self.blocks.get(alarm.block) else { return };
        if let Some(piece) = block.piece {
            self.programmed[piece].trace = Trace::Refused;
        }
        let text = format!("{} at {}", alarm.kind.id(), block.name);
        self.marks.push(Mark { point: self.tool, text, kind: MarkKind::Alarm });
    }

    fn trace(&self, step: &Step<Real>) -> Trace {
        match (step.main, step.clause) {
            (false, _) => Trace::Corner,
            (true, _) if step.rapid => Trace::Rapid,
            (true, clause::TRC_MODE_01) => Trace::Uncompensated,
            (true, _) => Trace::Compensated,
        }
    }
}

impl Sink for Scene {
    fn step(&mut self, step: Step<Real>) {
        let doubles = |point: &Point<Real>| [point[0].approximate(), point[1].approximate()];
        let (end, form) = match &step.segment {
            Segment::Hold => return,
            Segment::Line { end } => (doubles(end), Form::Straight),
            Segment::Arc { end, centre, direction, full } => {
                (doubles(end), Form::Arc { centre: doubles(centre), direction: *direction, full: *full })
            }
        };
        self.path.push(Piece { start: self.tool, end, form, trace: self.trace(&step) });
        if step.clause == clause::TRC_MODE_01
            && let Some(piece) = self.blocks.get(step.block).and_then(|block| block.piece)
        {
            self.programmed[piece].trace = Trace::Followed;
        }
        let leaves = [clause::TRC_MODE_01, clause::TRC_CANCEL_02, clause::TRC_CANCEL_03].contains(&step.clause);
        if let Some(block) = self.blocks.get(step.block)
            && block.radius > 0.0
            && !leaves
        {
            self.vectors.push((end, block.radius));
        }
        self.tool = end;
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        let Some(block) = self.blocks.get(advisory.block) else { return };
        let point = match (advisory.kind, &block.programmed) {
            (_, None) => self.tool,
            (AdvisoryKind::ReversedLine | AdvisoryKind::ReversedArc, Some(programmed)) => {
                [0, 1].map(|axis| programmed.start[axis].midpoint(programmed.end[axis]))
            }
            (_, Some(programmed)) => programmed.start,
        };
        let text = format!("{} at {}", advisory.kind.id(), block.name);
        self.marks.push(Mark { point, text, kind: MarkKind::Advisory });
    }
}
