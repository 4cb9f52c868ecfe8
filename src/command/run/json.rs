//! The format for programs: one JSON document, written as it comes.

use std::io::{self, Write};

use radcomp::explain::Coordinate;
use radcomp::tip;
use radcomp_spec::block::Point;
use radcomp_spec::parameters::Plane;
use radcomp_spec::{Advisory, Step};
use serde_json::{Map, Value, json};

use super::{Ending, Engine, Print};
use crate::command::ledger::Ledger;
use crate::command::program::{Control, Placed};

/// Prints the document.
pub struct Json<'c> {
    control: &'c Control,
    engine: Engine,
    digits: usize,
    with_tip: bool,
    begun: bool,
    plane: Plane,
}

impl<'c> Json<'c> {
    /// A printer at the start of its document.
    pub fn new(control: &'c Control, engine: Engine, digits: usize, with_tip: bool) -> Self {
        Json { control, engine, digits, with_tip, begun: false, plane: control.profile.machine.plane }
    }

    /// Writes what stands before an event: the head, or a comma.
    fn before(&mut self, out: &mut dyn Write) -> io::Result<()> {
        if std::mem::replace(&mut self.begun, true) {
            return out.write_all(b",\n");
        }
        let engine = match self.engine {
            Engine::Model => "model",
            Engine::Impl => "impl",
        };
        let head = json!({
            "radcomp": env!("CARGO_PKG_VERSION"),
            "program": self.control.name,
            "profile": self.control.profile.name,
            "engine": engine,
            "x_words": self.control.profile.machine.x_words.id(),
        });
        // The object is left open: its last brace is cut off.
        let head = head.to_string();
        writeln!(out, "{},\"events\":[", head.trim_end_matches('}'))
    }

    fn point<N: Coordinate>(&self, block: &Placed, point: &Point<N>) -> Value {
        let axes = block.axes.program(point).map(|(letter, value)| (letter.to_string(), self.number(&value)));
        Value::Object(Map::from_iter(axes))
    }

    /// Adds where the tip stands, if that is asked for.
    fn tip<N: Coordinate>(&self, event: &mut Value, step: &Step<N>, block: &Placed) {
        let tip = tip::at_end(step, block.read.nose.as_ref(), &self.control.profile.parameters);
        if let Some(tip) = tip.filter(|_| self.with_tip) {
            event["tip"] = self.point(block, &tip);
        }
    }

    fn number<N: Coordinate>(&self, value: &N) -> Value {
        radcomp::explain::number(value, self.digits)
    }
}

impl<N: Coordinate> Print<N> for Json<'_> {
    fn step(&mut self, out: &mut dyn Write, step: &Step<N>, block: &Placed) -> io::Result<()> {
        self.before(out)?;
        self.plane = block.axes.plane;
        let mut event = place(block);
        if let (Value::Object(event), Value::Object(more)) =
            (&mut event, radcomp::explain::event(step, block.axes, self.digits))
        {
            event.extend(more);
        }
        self.tip(&mut event, step, block);
        write!(out, "{event}")
    }

    fn advisory(&mut self, out: &mut dyn Write, advisory: &Advisory<N>, block: &Placed) -> io::Result<()> {
        self.before(out)?;
        let mut event = place(block);
        event["kind"] = json!("advisory");
        event["clause"] = json!(advisory.kind.clause().id());
        event["advisory"] = json!(advisory.kind.id());
        event["amount"] = self.number(&advisory.amount);
        write!(out, "{event}")
    }

    fn end(&mut self, out: &mut dyn Write, ending: &Ending, ledger: &Ledger) -> io::Result<()> {
        if !self.begun {
            self.before(out)?;
        }
        let (mut alarm, mut refused) = (Value::Null, Value::Null);
        match ending {
            Ending::Complete => {}
            Ending::Alarm(raised) => {
                alarm = ledger.block(raised.block).map_or_else(|| json!({}), place);
                alarm["alarm"] = json!(raised.kind.id());
                alarm["clause"] = json!(raised.kind.clause().id());
                alarm["text"] = json!(raised.kind.text());
                alarm["number"] = json!(self.control.profile.alarm_number(raised.kind));
            }
            Ending::Refused(diagnostic) => {
                refused = json!({
                    "line": diagnostic.line,
                    "column": diagnostic.column,
                    "title": diagnostic.kind.title(),
                    "text": diagnostic.message,
                    "clause": diagnostic.clause.map(|clause| clause.id()),
                });
            }
        }
        let tail = json!({
            "plane": self.plane.id(),
            "blocks": ledger.count(),
            "alarm": alarm,
            "refused": refused,
        });
        let tail = tail.to_string();
        writeln!(out, "\n],{}", tail.trim_start_matches('{'))
    }
}

fn place(block: &Placed) -> Value {
    json!({ "line": block.source.line, "n": block.source.sequence })
}
