//! What is known of one block, and what there is to tell of it.

use radcomp_model::Decision;
use radcomp_model::number::Real;
use radcomp_spec::parameters::OuterCorner;
use radcomp_spec::{Advisory, AlarmKind, Clause, Compensation, Direction, Segment, Side, Step};
use rug::Rational;

use super::explanation::{Explanation, Row};
use super::programmed::{ProgrammedMove, Shape};
use super::{Axes, Coordinate, Corner, in_words};

/// Where a block stands in its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// The line, from 1.
    pub line: u32,
    /// The digits of its N word.
    pub sequence: Option<String>,
    /// The text of the line.
    pub text: String,
}

/// One block.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) index: usize,
    pub(super) source: Source,
    pub(super) axes: Axes,
    pub(super) programmed: Option<ProgrammedMove>,
    pub(super) compensation: Option<Compensation>,
    pub(super) radius: Option<Rational>,
    pub(super) outer_corner: Option<OuterCorner>,
    /// The side in force in the block, for the words only.
    pub(super) side: Option<Side>,
    /// Decisions on the block itself.
    pub(super) checks: Vec<Decision>,
    /// Decisions on the corner at its end, with the line of the block after that corner.
    pub(super) corner: Vec<(u32, Corner, Decision)>,
    pub(super) steps: Vec<Step<Real>>,
    pub(super) advisories: Vec<Advisory<Real>>,
    pub(super) alarm: Option<AlarmKind>,
}

impl Section {
    /// What there is to tell; closed forms stand where so many digits do not tell all.
    pub(super) fn explanation(&self, digits: usize) -> Explanation {
        let mut rows = vec![Row::plain("programmed", self.program(digits))];
        rows.extend(self.codes().into_iter().map(|code| Row::plain("code", code)));
        rows.extend(self.checks.iter().filter_map(|check| decision("check", "", check, Corner::default(), digits)));
        let mut told = 0;
        for (line, corner, of) in &self.corner {
            let place = if told == *line { String::new() } else { format!("with line {line}: ") };
            if let Some(row) = decision("corner", &place, of, *corner, digits) {
                told = *line;
                rows.push(row);
            }
        }
        rows.extend(self.steps.iter().map(|step| self.step(step, digits)));
        if self.steps.is_empty() && self.alarm.is_none() {
            rows.push(Row::plain("centre path", "not settled: the program stops before".to_owned()));
        }
        for advisory in &self.advisories {
            let amount = advisory.amount.short(digits);
            rows.push(Row::plain("WARNING", format!("{}: {}: {amount} mm", advisory.kind.id(), advisory.kind.text())));
        }
        if let Some(kind) = self.alarm {
            let words = format!("{}: {}; the tool does not enter this block", kind.id(), kind.text());
            rows.push(Row::plain("ALARM", words));
        }
        let Source { line, sequence, text } = self.source.clone();
        Explanation { block: self.index, line, n: sequence, text, rows, clauses: self.clauses() }
    }

    fn program(&self, digits: usize) -> String {
        let Some(programmed) = &self.programmed else { return "no movement in the plane".to_owned() };
        let point = |point| self.axes.words(point, digits);
        let (start, end) = (point(&programmed.start), point(&programmed.end));
        match &programmed.shape {
            Shape::Line => {
                format!("straight, {start} to {end}, {} mm", programmed.distance().short(digits))
            }
            Shape::Arc { centre, direction, full } => {
                let whole = if *full { "full circle" } else { "arc" };
                format!("{} {whole}, {start} to {end} about {}", sense(*direction), point(centre))
            }
            Shape::Direction(vector) => {
                let [a, b] = vector.map(|component| component.short(digits));
                let [first, second] = self.axes.letters();
                format!("a vector at {start}: no movement, the direction {first} {a} {second} {b} (radius values)")
            }
            Shape::Dummy(vector) => {
                let [a, b] = vector.map(|component| component.short(digits));
                let [first, second] = self.axes.letters();
                format!("dummy block at {start}: no movement, the direction {first} {a} {second} {b} (radius values)")
            }
        }
    }

    fn codes(&self) -> Vec<String> {
        let mut codes = Vec::new();
        match self.compensation {
            Some(Compensation::Off) => codes.push("compensation off".to_owned()),
            Some(Compensation::On(Side::Left)) => codes.push("compensation on, tool left of the path".to_owned()),
            Some(Compensation::On(Side::Right)) => codes.push("compensation on, tool right of the path".to_owned()),
            None => {}
        }
        if let Some(radius) = &self.radius {
            codes.push(format!("tool radius {} mm", Real::from(radius).short(9)));
        }
        match self.outer_corner {
            Some(OuterCorner::Arc) => codes.push("outer corners by an arc from here on".to_owned()),
            Some(OuterCorner::Intersection) => codes.push("outer corners by intersection from here on".to_owned()),
            Some(OuterCorner::LimitAngle) => {
                codes.push("outer corners by intersection down to the limit angle from here on".to_owned());
            }
            None => {}
        }
        codes
    }

    fn step(&self, step: &Step<Real>, digits: usize) -> Row {
        let name = if step.main || matches!(step.segment, Segment::Hold) { "centre path" } else { "corner move" };
        let rapid = if step.rapid { "rapid, " } else { "" };
        let (words, point) = match &step.segment {
            Segment::Hold => ("executed where the tool's centre stands".to_owned(), None),
            Segment::Line { end } => (format!("straight to {}", self.axes.words(end, digits)), Some(end)),
            Segment::Arc { end, centre, direction, full } => {
                let whole = if *full { "full circle" } else { "arc" };
                let [end_words, centre] = [end, centre].map(|point| self.axes.words(point, digits));
                (format!("{} {whole} to {end_words} about {centre}", sense(*direction)), Some(end))
            }
        };
        let exact = point.and_then(|point| self.axes.closed_forms(point, digits));
        Row { name, words: format!("{rapid}{words}"), margin: None, clause: Some(step.clause), exact }
    }

    /// The clauses of the block, each once: of its path, its warnings, its alarm.
    fn clauses(&self) -> Vec<Clause> {
        let path = self.steps.iter().map(|step| step.clause);
        let warnings = self.advisories.iter().map(|advisory| advisory.kind.clause());
        let mut clauses: Vec<Clause> = Vec::new();
        for clause in path.chain(warnings).chain(self.alarm.map(|kind| kind.clause())) {
            if !clauses.contains(&clause) {
                clauses.push(clause);
            }
        }
        clauses
    }
}

fn sense(direction: Direction) -> &'static str {
    match direction {
        Direction::Clockwise => "clockwise",
        Direction::Counterclockwise => "counter-clockwise",
    }
}

/// None if there is nothing to tell. The words have the margin's sign.
fn decision(name: &'static str, place: &str, of: &Decision, corner: Corner, digits: usize) -> Option<Row> {
    let words = in_words(of, corner)?;
    let margin = of.margin.abs();
    let (short, form) = (margin.short(digits), margin.closed(digits));
    let clause = Some(of.clause());
    Some(Row { name, words: format!("{place}{words}"), margin: Some((short, form)), clause, exact: None })
}
