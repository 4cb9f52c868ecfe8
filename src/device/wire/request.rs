//! What a device is asked.

use std::collections::BTreeMap;

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Centre, Movement, Parameters};
use rug::Rational;
use serde::Serialize;
use serde_json::{Map, Value};

use super::PROTOCOL;
use crate::device::DeviceFault;
use crate::gcode::print_blocks;
use crate::report::{BlockRecord, ParametersRecord};
use radcomp_model::number::format_decimal;

/// One request.
#[derive(Clone, Debug, Serialize)]
pub struct Request<'p> {
    /// [`PROTOCOL`].
    pub radcomp: u64,
    /// What the answer has to repeat.
    pub id: &'p str,
    /// The control: every parameter of its profile.
    pub profile: &'p ProfileRecord,
    /// The program as G-code; none if the profile's control has no G-code for it.
    pub program: Option<String>,
    /// The tool radius that each offset number of the G-code stands for, in millimetres.
    pub tools: BTreeMap<String, String>,
    /// The program as blocks.
    pub blocks: Vec<BlockRecord>,
}

/// The parameters of a profile, each as a string, by the names of `spec/PARAMETERS.md`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(transparent)]
pub struct ProfileRecord(Map<String, Value>);

impl ProfileRecord {
    /// The parameters of a profile, those that the compensation reads replaced by `parameters`.
    pub fn new(profile: &Profile, parameters: &Parameters) -> Self {
        let mut record = Map::new();
        record.insert("name".to_owned(), Value::String(profile.name.clone()));
        for entry in &profile.provenance {
            record.insert(entry.parameter.to_owned(), Value::String(entry.value.clone()));
        }
        // A record of ids and decimals is always written.
        if let Ok(Value::Object(own)) = serde_json::to_value(ParametersRecord::from(parameters)) {
            for (name, value) in own {
                let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
                record.insert(format!("compensation.{name}"), Value::String(text));
            }
        }
        ProfileRecord(record)
    }

    /// The value of a parameter, by its key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.get(key)?.as_str()
    }
}

/// The line that asks for a program's path, with its end of line. `profile` is the record of `control` with the
/// parameters that count.
///
/// # Errors
///
/// [`DeviceFault::Unsupported`] for a program with a number that is no finite decimal: no control can be told it.
pub fn request(
    id: &str,
    control: &Profile,
    profile: &ProfileRecord,
    blocks: &[Block<Rational>],
) -> Result<String, DeviceFault> {
    if let Some(number) = blocks.iter().flat_map(numbers).find(|number| format_decimal(number).is_none()) {
        return Err(DeviceFault::Unsupported(format!("not asked: {number} has no finite decimal")));
    }
    let listing = print_blocks(blocks, control).ok();
    let tools = listing.as_ref().map(|listing| {
        let radii = (1..).map_while(|number: u32| Some((number, listing.tools.tool(number)?.radius())));
        radii.filter_map(|(number, radius)| Some((number.to_string(), format_decimal(&radius)?))).collect()
    });
    let request = Request {
        radcomp: PROTOCOL,
        id,
        profile,
        program: listing.map(|listing| listing.program),
        tools: tools.unwrap_or_default(),
        blocks: blocks.iter().map(BlockRecord::from).collect(),
    };
    let mut line = serde_json::to_string(&request)
        .map_err(|error| DeviceFault::Unsupported(format!("not asked: the request cannot be written: {error}")))?;
    line.push('\n');
    Ok(line)
}

/// Every number of a block.
fn numbers(block: &Block<Rational>) -> impl Iterator<Item = &Rational> {
    let (point, further): (&[Rational], &[Rational]) = match &block.movement {
        Movement::None => (&[], &[]),
        Movement::CornerArc { vector: None } => (&[], &[]),
        Movement::Line { end } | Movement::HeldVector { end } => (end, &[]),
        Movement::Dummy { vector } | Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) } => {
            (vector, &[])
        }
        Movement::Arc { end, centre: Centre::FromStart(vector), .. } => (end, vector),
        Movement::Arc { end, centre: Centre::Radius(radius), .. } => (end, std::slice::from_ref(radius)),
    };
    point.iter().chain(further).chain(&block.radius).chain(block.vector.iter().flatten())
}
