//! What a device answers.

use std::fmt;

use radcomp_spec::{Alarm, AlarmKind, Clause, Direction, Segment, Step, clause};
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer};

use crate::device::{Answer, DeviceFault};
use crate::report::Id;

/// A line that is an answer to some request.
#[derive(Clone, Debug, PartialEq)]
pub struct Reply {
    /// The request that it answers.
    pub id: String,
    /// What it says.
    pub answer: Result<Answer, DeviceFault>,
}

/// A line of which not even the id can be read, and why, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReplyError(pub String);

impl Reply {
    /// Reads a line. What is wrong with an answer whose id can be read is its [`DeviceFault::Garbled`].
    ///
    /// # Errors
    ///
    /// A line that is not JSON, or has no id.
    pub fn read(line: &[u8]) -> Result<Reply, ReplyError> {
        let identified: Identified =
            serde_json::from_slice(line).map_err(|error| ReplyError(not_json(line, &error)))?;
        let id = match identified.id {
            Some(AnyId::Text(text)) => text,
            Some(AnyId::Number(number)) => {
                let text =
                    format!("the id {number} is a number; it is a string in the request, to be repeated as it is");
                return Ok(Reply { id: number.to_string(), answer: Err(DeviceFault::Garbled(text)) });
            }
            None => return Err(ReplyError(format!("the line has no \"id\": {}", shown(line)))),
        };
        let garbled = |error: String| DeviceFault::Garbled(format!("{error}, in {}", shown(line)));
        let answer = serde_json::from_slice::<Wire>(line).map_err(|error| garbled(error.to_string()));
        Ok(Reply { id, answer: answer.and_then(|wire| wire.answer().map_err(|fault| fault.or(garbled))) })
    }

    /// The same reply to a program of so many blocks: an answer about a block that it does not have is garbled.
    #[must_use]
    pub fn within(mut self, blocks: usize) -> Reply {
        if let Ok(answer) = &self.answer {
            let named = answer.steps.iter().map(|step| step.block).chain(answer.alarm.map(|alarm| alarm.block));
            if let Some(block) = named.into_iter().find(|block| *block >= blocks) {
                let text =
                    format!("the answer names block {block}, but the program has {blocks}; blocks are counted from 0");
                self.answer = Err(DeviceFault::Garbled(text));
            }
        }
        self
    }
}

/// As much as every answer has.
#[derive(Deserialize)]
struct Identified {
    id: Option<AnyId>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum AnyId {
    Text(String),
    Number(i64),
}

/// An answer as it stands on its line.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wire {
    #[serde(rename = "id")]
    _id: serde::de::IgnoredAny,
    steps: Option<Vec<WireStep>>,
    // Absent and null are told apart: an alarm is to be given or denied, not forgotten.
    #[serde(default, deserialize_with = "present")]
    alarm: Option<Option<WireAlarm>>,
    unsupported: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WireAlarm {
    block: usize,
    alarm: Id<AlarmKind>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WireStep {
    block: usize,
    shape: Shape,
    end: Option<[Coordinate; 2]>,
    centre: Option<[Coordinate; 2]>,
    direction: Option<Id<Direction>>,
    full: Option<bool>,
    #[serde(default)]
    rapid: bool,
    main: Option<bool>,
    clause: Option<Id<Clause>>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Shape {
    Hold,
    Line,
    Arc,
}

fn present<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<Option<T>, D::Error> {
    T::deserialize(deserializer).map(Some)
}

/// What is wrong with an answer that fits its grammar, or that it is not supported.
enum Refusal {
    Unsupported(String),
    Wrong(String),
}

impl Refusal {
    fn or(self, garbled: impl Fn(String) -> DeviceFault) -> DeviceFault {
        match self {
            Refusal::Unsupported(reason) => DeviceFault::Unsupported(reason),
            Refusal::Wrong(text) => garbled(text),
        }
    }
}

impl Wire {
    fn answer(self) -> Result<Answer, Refusal> {
        let wrong = |text: &str| Refusal::Wrong(text.to_owned());
        match (self.steps, self.alarm, self.unsupported) {
            (None, None, Some(reason)) => Err(Refusal::Unsupported(reason)),
            (_, _, Some(_)) => Err(wrong("an answer with \"unsupported\" has neither \"steps\" nor \"alarm\"")),
            (None, _, None) => Err(wrong("\"steps\" is missing; a path without elements is []")),
            (Some(_), None, None) => Err(wrong("\"alarm\" is missing; without an alarm it is null")),
            (Some(steps), Some(alarm), None) => {
                let steps = steps.into_iter().enumerate().map(|(index, step)| {
                    step.step().map_err(|text| Refusal::Wrong(format!("step {index}, counted from 0: {text}")))
                });
                let alarm = alarm.map(|alarm| Alarm { block: alarm.block, kind: alarm.alarm.0 });
                Ok(Answer { steps: steps.collect::<Result<_, _>>()?, alarm })
            }
        }
    }
}

impl WireStep {
    fn step(self) -> Result<Step<f64>, &'static str> {
        let (end, centre) = (self.end.map(point), self.centre.map(point));
        let round = centre.is_some() || self.direction.is_some() || self.full.is_some();
        let segment = match self.shape {
            Shape::Hold if end.is_some() || round => return Err("a hold has \"block\" and \"shape\" only"),
            Shape::Hold => Segment::Hold,
            Shape::Line if round => return Err("a line has no \"centre\", \"direction\" or \"full\""),
            Shape::Line => Segment::Line { end: end.ok_or("a line has an \"end\"")? },
            Shape::Arc => Segment::Arc {
                end: end.ok_or("an arc has an \"end\"")?,
                centre: centre.ok_or("an arc has a \"centre\"")?,
                direction: self.direction.ok_or("an arc has a \"direction\", \"cw\" or \"ccw\"")?.0,
                full: self.full.unwrap_or(false),
            },
        };
        // A device need not name clauses; the judge does not read them.
        let clause = self.clause.map_or(clause::TRC_MODE_01, |clause| clause.0);
        Ok(Step { block: self.block, clause, rapid: self.rapid, main: self.main.unwrap_or(true), segment })
    }
}

/// A finite number: JSON's, or a decimal in a string.
#[derive(Clone, Copy)]
struct Coordinate(f64);

fn point([Coordinate(a), Coordinate(b)]: [Coordinate; 2]) -> [f64; 2] {
    [a, b]
}

impl<'de> Deserialize<'de> for Coordinate {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = Coordinate;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number in millimetres, as a JSON number or as a decimal in quotes")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Coordinate, E> {
                Ok(Coordinate(value))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Coordinate, E> {
                Ok(Coordinate(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Coordinate, E> {
                Ok(Coordinate(value as f64))
            }

            fn visit_str<E: Error>(self, text: &str) -> Result<Coordinate, E> {
                match text.trim().parse::<f64>() {
                    Ok(value) if value.is_finite() => Ok(Coordinate(value)),
                    Ok(_) => Err(E::custom(format!("{text:?} is not a finite number"))),
                    Err(_) => Err(E::invalid_value(serde::de::Unexpected::Str(text), &self)),
                }
            }
        }
        deserializer.deserialize_any(Number)
    }
}

fn not_json(line: &[u8], error: &serde_json::Error) -> String {
    let has = |word: &str| line.windows(word.len()).any(|part| part == word.as_bytes());
    let hint = if line.iter().all(u8::is_ascii_whitespace) {
        "the line is empty: each line of the standard output is one answer"
    } else if has("NaN") || has("Infinity") || has("nan") || has("inf") {
        "JSON has no NaN and no infinity"
    } else if !line.trim_ascii_start().starts_with(b"{") {
        "each line of the standard output is one answer, a JSON object; messages belong on the standard error output"
    } else {
        "each line is one JSON object and nothing else"
    };
    format!("not an answer: {error}; {hint}: {}", shown(line))
}

/// The most characters of a line that a message shows.
const MOST_SHOWN: usize = 120;

/// The beginning of a line, fit for a terminal.
pub(crate) fn shown(line: &[u8]) -> String {
    let text = String::from_utf8_lossy(&line[..line.len().min(4 * MOST_SHOWN)]);
    let mut characters = text.trim_end().chars().map(|c| if c.is_control() { '\u{fffd}' } else { c });
    let start: String = characters.by_ref().take(MOST_SHOWN).collect();
    let dots = if characters.next().is_some() || line.len() > 4 * MOST_SHOWN { "…" } else { "" };
    format!("`{start}{dots}`")
}
