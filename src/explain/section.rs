//! What there is to tell of one block, and how it is written.

use std::fmt::Write;

use radcomp_model::Decision;
use radcomp_model::number::Real;
use radcomp_spec::parameters::OuterCorner;
use radcomp_spec::{Advisory, AlarmKind, Clause, Compensation, Direction, Segment, Side, Step, clause};
use rug::Rational;

use super::programmed::{ProgrammedMove, Shape};
use super::{Axes, Coordinate, Corner, first_sentence, in_words, wrapped};

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

/// Columns of the text.
const WIDTH: usize = 100;
/// Before what is told of a block.
const INDENT: &str = "               ";

impl Section {
    /// The text of the block; closed forms stand where so many digits do not tell all.
    pub(super) fn text(&self, digits: usize, bold: bool) -> String {
        let mut page = Page { text: String::new(), digits };
        let (on, off) = if bold { ("\u{1b}[1m", "\u{1b}[0m") } else { ("", "") };
        page.text.push_str(&format!("{on}line {}{off} | {on}{}{off}\n", self.source.line, self.source.text.trim()));
        page.row("programmed", &self.program(digits));
        for code in self.codes() {
            page.row("code", &code);
        }
        for check in &self.checks {
            page.decision("check", "", check, Corner::default());
        }
        let mut told = 0;
        for (line, corner, decision) in &self.corner {
            let place = if told == *line { String::new() } else { format!("with line {line}: ") };
            told = if page.decision("corner", &place, decision, *corner) { *line } else { told };
        }
        for step in &self.steps {
            let (name, words, point) = self.step(step, digits);
            page.row(name, &words);
            if let Some(forms) = point.and_then(|point| self.axes.closed_forms(point, digits)) {
                page.row("", &forms);
            }
        }
        if self.steps.is_empty() && self.alarm.is_none() {
            page.row("centre path", "not settled: the program stops before");
        }
        for advisory in &self.advisories {
            let amount = advisory.amount.short(digits);
            page.row("WARNING", &format!("{}: {}: {amount} mm", advisory.kind.id(), advisory.kind.text()));
        }
        if let Some(kind) = self.alarm {
            page.row("ALARM", &format!("{}: {}; the tool does not enter this block", kind.id(), kind.text()));
        }
        for clause in self.clauses() {
            page.clause(clause);
        }
        page.text.push('\n');
        page.text
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

    fn step<'s>(&self, step: &'s Step<Real>, digits: usize) -> (&'static str, String, Option<&'s [Real; 2]>) {
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
        (name, format!("{rapid}{words} [{}]", step.clause), point)
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

/// A block's text while it is written.
struct Page {
    text: String,
    digits: usize,
}

impl Page {
    fn row(&mut self, name: &str, words: &str) {
        let set = wrapped(words, INDENT, WIDTH);
        let place = INDENT.len().min(set.len());
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {name:<width$}{}", &set[place..], width = INDENT.len() - 2);
    }

    /// Whether there was anything to tell. The words have the margin's sign.
    fn decision(&mut self, name: &str, place: &str, decision: &Decision, corner: Corner) -> bool {
        let Some(words) = in_words(decision, corner) else { return false };
        let margin = decision.margin.abs();
        let form = margin.closed(self.digits).map_or(String::new(), |form| format!(" = {form}"));
        let margin = margin.short(self.digits);
        self.row(name, &format!("{place}{words}; margin {margin} mm{form} [{}]", decision.clause()));
        true
    }

    fn clause(&mut self, of: Clause) {
        let title = clause::ALL.iter().find(|(known, _)| *known == of).map_or("", |(_, title)| title);
        let _ = writeln!(self.text, "  [{of}] {title}");
        let _ = writeln!(self.text, "{}", wrapped(&first_sentence(of), "      ", WIDTH));
    }
}
