//! The device's side of the protocol: requests read, answers written.

use std::io::{self, BufRead, Write};

use radcomp_spec::{Block, Direction, Parameters, Segment, Step};
use rug::Rational;
use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::{PROTOCOL, shown};
use crate::device::{Answer, Device, DeviceFault, ask};
use crate::report::{BlockRecord, ParametersRecord};

/// A request, read.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The id that the answer repeats.
    pub id: String,
    /// The parameters that the compensation reads.
    pub parameters: Parameters,
    /// The program.
    pub blocks: Vec<Block<Rational>>,
}

/// A request as it stands on its line. Of what a later radcomp adds, nothing is needed here.
#[derive(Deserialize)]
struct Wire {
    radcomp: u64,
    id: String,
    profile: Map<String, Value>,
    blocks: Vec<BlockRecord>,
}

impl Asked {
    /// Reads a request.
    ///
    /// # Errors
    ///
    /// What is wrong with the line, in words.
    pub fn read(line: &[u8]) -> Result<Asked, String> {
        let wire: Wire =
            serde_json::from_slice(line).map_err(|error| format!("not a request: {error}: {}", shown(line)))?;
        if wire.radcomp != PROTOCOL {
            return Err(format!("a request of protocol {}; this radcomp speaks protocol {PROTOCOL}", wire.radcomp));
        }
        let mut own = Map::new();
        for (key, value) in wire.profile {
            let Some(name) = key.strip_prefix("compensation.") else { continue };
            // Every parameter is a string on the line; a count is a number in a record.
            let count =
                value.as_str().filter(|_| name == "non-moving-allowed").and_then(|text| text.parse::<u64>().ok());
            own.insert(name.to_owned(), count.map_or(value, Value::from));
        }
        let record: ParametersRecord = serde_json::from_value(Value::Object(own))
            .map_err(|error| format!("the request's profile cannot be used: {error}"))?;
        let blocks = wire.blocks.iter().map(Block::from).collect();
        Ok(Asked { id: wire.id, parameters: Parameters::from(&record), blocks })
    }
}

/// The line that answers a request, without its end. What is not finite stands in quotes, where it will be refused.
///
/// # Errors
///
/// A fault that is no answer: a device that has it ends.
pub fn answer_line(id: &str, answer: &Result<Answer, DeviceFault>) -> Result<String, DeviceFault> {
    let value = match answer {
        Err(DeviceFault::Unsupported(reason)) => json!({ "id": id, "unsupported": reason }),
        Err(fault) => return Err(fault.clone()),
        Ok(answer) => {
            let steps: Vec<Value> = answer.steps.iter().map(step).collect();
            let alarm = answer.alarm.map(|alarm| json!({ "block": alarm.block, "alarm": alarm.kind.id() }));
            json!({ "id": id, "steps": steps, "alarm": alarm })
        }
    };
    Ok(value.to_string())
}

fn step(step: &Step<f64>) -> Value {
    let number = |value: f64| if value.is_finite() { json!(value) } else { json!(value.to_string()) };
    let point = |point: &[f64; 2]| json!(point.map(number));
    let mut record = json!({ "block": step.block });
    match &step.segment {
        Segment::Hold => record["shape"] = json!("hold"),
        Segment::Line { end } => {
            record["shape"] = json!("line");
            record["end"] = point(end);
        }
        Segment::Arc { end, centre, direction, full } => {
            record["shape"] = json!("arc");
            record["end"] = point(end);
            record["centre"] = point(centre);
            record["direction"] = json!(if *direction == Direction::Clockwise { "cw" } else { "ccw" });
            record["full"] = json!(full);
        }
    }
    record["rapid"] = json!(step.rapid);
    record["main"] = json!(step.main);
    record["clause"] = json!(step.clause.id());
    record
}

/// Answers every request of an input with a device, in order, until the input ends.
///
/// # Errors
///
/// Those of input and output, a line that is no request, and a device that gives no answer.
pub fn serve(device: &mut dyn Device, mut input: impl BufRead, mut output: impl Write) -> io::Result<()> {
    let mut line = Vec::new();
    loop {
        line.clear();
        if input.read_until(b'\n', &mut line)? == 0 {
            return Ok(());
        }
        let asked = Asked::read(&line).map_err(|text| io::Error::new(io::ErrorKind::InvalidData, text))?;
        let answer = ask(device, &asked.parameters, &asked.blocks);
        let line = answer_line(&asked.id, &answer)
            .map_err(|fault| io::Error::new(io::ErrorKind::InvalidData, fault.text().to_owned()))?;
        writeln!(output, "{line}")?;
        output.flush()?;
    }
}
