//! The format for people: a line for each path element.

use std::io::{self, Write};

use radcomp::explain::Coordinate;
use radcomp::tip;
use radcomp_spec::block::Point;
use radcomp_spec::{Advisory, Direction, Parameters, Segment, Step};

use super::{Ending, Print};
use crate::command::ledger::Ledger;
use crate::command::program::Placed;

/// Prints lines.
pub struct Text<'c> {
    /// Digits after the decimal point.
    pub digits: usize,
    /// The parameters, if the tip is asked for.
    pub tip: Option<&'c Parameters>,
    /// Path elements printed.
    pub count: u64,
}

impl<N: Coordinate> Print<N> for Text<'_> {
    fn step(&mut self, out: &mut dyn Write, step: &Step<N>, block: &Placed) -> io::Result<()> {
        if self.count == 0 {
            let width = 2 * (self.digits + 12);
            writeln!(out, "{:>6}  {:<7} {:<16}{:<width$}clause", "line", "N", "path element", "end point, mm")?;
        }
        self.count += 1;
        let place = format!("{:>6}  {:<7} {:<16}", block.source.line, name(block), kind(step));
        let (end, more) = match &step.segment {
            Segment::Hold => (String::new(), None),
            Segment::Line { end } => (self.columns(block, end), block.axes.closed_forms(end, self.digits)),
            Segment::Arc { end, centre, .. } => {
                let about = format!("about {}", block.axes.words(centre, self.digits));
                let forms =
                    block.axes.closed_forms(end, self.digits).map_or(String::new(), |forms| format!("; {forms}"));
                (self.columns(block, end), Some(about + &forms))
            }
        };
        let width = 2 * (self.digits + 12);
        match more {
            Some(more) => writeln!(out, "{place}{end:<width$}{:<16}{more}", step.clause.id())?,
            None => writeln!(out, "{place}{end:<width$}{}", step.clause.id())?,
        }
        let tip = self.tip.and_then(|parameters| tip::at_end(step, block.read.nose.as_ref(), parameters));
        match tip {
            Some(tip) => {
                let forms = block
                    .axes
                    .closed_forms(&tip, self.digits)
                    .map_or(String::new(), |forms| format!("{:16}{forms}", ""));
                let line = format!("{:>6}  {:<7} {:<16}{:<width$}{forms}", "", "", "tip", self.columns(block, &tip));
                writeln!(out, "{}", line.trim_end())
            }
            None => Ok(()),
        }
    }

    fn advisory(&mut self, out: &mut dyn Write, advisory: &Advisory<N>, block: &Placed) -> io::Result<()> {
        let (kind, amount) = (advisory.kind, advisory.amount.short(self.digits));
        let form = advisory.amount.closed(self.digits).map_or(String::new(), |form| format!(" = {form}"));
        let (line, name, clause) = (block.source.line, name(block), kind.clause());
        writeln!(out, "{line:>6}  {name:<7} warning {}: {}: {amount} mm{form} [{clause}]", kind.id(), kind.text())
    }

    fn end(&mut self, out: &mut dyn Write, ending: &Ending, ledger: &Ledger) -> io::Result<()> {
        let (blocks, elements) = (ledger.count(), self.count);
        match ending {
            Ending::Complete => writeln!(out, "{blocks} blocks, {elements} path elements"),
            Ending::Alarm(_) => writeln!(out, "stopped at an alarm after {elements} path elements"),
            Ending::Refused(_) => {
                writeln!(out, "stopped at a line that cannot be read, {elements} path elements before it")
            }
        }
    }
}

impl Text<'_> {
    fn columns<N: Coordinate>(&self, block: &Placed, point: &Point<N>) -> String {
        let width = self.digits + 7;
        let columns =
            block.axes.program(point).map(|(letter, value)| format!("{letter} {:>width$}", value.decimal(self.digits)));
        columns.join("   ") + "   "
    }
}

fn name(block: &Placed) -> String {
    block.source.sequence.as_ref().map_or(String::new(), |sequence| format!("N{sequence}"))
}

fn kind<N>(step: &Step<N>) -> String {
    let form = match &step.segment {
        Segment::Hold => return "hold".to_owned(),
        Segment::Line { .. } if step.rapid => "rapid",
        Segment::Line { .. } => "line",
        Segment::Arc { direction: Direction::Clockwise, full: false, .. } => "arc cw",
        Segment::Arc { direction: Direction::Counterclockwise, full: false, .. } => "arc ccw",
        Segment::Arc { direction: Direction::Clockwise, .. } => "circle cw",
        Segment::Arc { direction: Direction::Counterclockwise, .. } => "circle ccw",
    };
    if step.main { form.to_owned() } else { format!("corner {form}") }
}
