//! The canonical calls and the error messages that `rs274` prints, as an answer.

use std::sync::LazyLock;

use radcomp_spec::parameters::Plane;
use radcomp_spec::{Alarm, AlarmKind, Direction, Segment, Step, clause};
use serde::Deserialize;

use super::program::Place;
use crate::device::{Answer, DeviceFault};

/// An answer as it grows, line by line.
#[derive(Debug)]
pub(super) struct Transcript {
    plane: Plane,
    places: Vec<Place>,
    answer: Answer,
    at: [f64; 2],
    /// The block whose feed is in force.
    block: usize,
    /// The first error message, and then the block that was being read.
    error: Option<String>,
    read: Option<usize>,
    fault: Option<DeviceFault>,
}

/// A point's distance from its start at which an arc is a whole turn, in millimetres: what rounding leaves of none.
const NO_DISTANCE: f64 = 1e-9;

/// The line that ends a program.
pub(super) const END_OF_PROGRAM: &str = "m2";

impl Transcript {
    /// The answer to a program of these blocks, at its beginning.
    pub(super) fn new(plane: Plane, places: Vec<Place>) -> Self {
        let answer = Answer::default();
        Transcript { plane, places, answer, at: [0.0, 0.0], block: 0, error: None, read: None, fault: None }
    }

    /// Takes a line.
    pub(super) fn line(&mut self, line: &str) {
        // What follows an error runs with a path that has lost a move.
        if self.fault.is_some() || self.read.is_some() {
            return;
        }
        let end = self.places.len() + 1;
        match (call(line), &mut self.error) {
            (Some(_), Some(_)) => {}
            (Some((name, arguments)), None) => self.call(name, arguments),
            (None, None) => self.error = Some(line.to_owned()),
            // The source of the line that was being read comes after the message: at the end of the program, M2.
            (None, Some(message)) => match number(line).or_else(|| (line == END_OF_PROGRAM).then_some(end)) {
                Some(number) => self.read = number.checked_sub(1),
                None => {
                    message.push(' ');
                    message.push_str(line);
                }
            },
        }
    }

    /// The answer, at its end.
    pub(super) fn finish(mut self) -> Result<Answer, DeviceFault> {
        if let Some(fault) = self.fault {
            return Err(fault);
        }
        if let Some(message) = &self.error {
            let read = self.read.ok_or_else(|| DeviceFault::Garbled(format!("rs274 says: {message}")))?;
            self.answer.alarm = Some(alarm(message, read, &self.places)?);
            // The block that is refused has set its feed before.
            self.answer.steps.retain(|step| step.segment != Segment::Hold || step.block != read);
        }
        Ok(self.answer)
    }

    fn call(&mut self, name: &str, arguments: &str) {
        let numbers: Option<Vec<f64>> = arguments.split(", ").map(|text| text.parse().ok()).collect();
        let segment = match (name, numbers.as_deref()) {
            ("SET_FEED_RATE", Some([feed])) => return self.feed(*feed),
            ("STRAIGHT_FEED" | "STRAIGHT_TRAVERSE", Some([x, y, z, ..])) => {
                Segment::Line { end: self.plane([*x, *y, *z]) }
            }
            ("ARC_FEED", Some([end_a, end_b, centre_a, centre_b, turn, ..])) => {
                let end = [*end_a, *end_b];
                let distance = (end[0] - self.at[0]).hypot(end[1] - self.at[1]);
                let whole_turn = self.places.get(self.block).is_some_and(|place| place.whole_turn);
                Segment::Arc {
                    end,
                    centre: [*centre_a, *centre_b],
                    direction: if *turn < 0.0 { Direction::Clockwise } else { Direction::Counterclockwise },
                    full: whole_turn && distance <= NO_DISTANCE,
                }
            }
            ("STRAIGHT_FEED" | "STRAIGHT_TRAVERSE" | "ARC_FEED" | "SET_FEED_RATE", _) => {
                self.fault = Some(DeviceFault::Garbled(format!("not a canonical call: {name}({arguments})")));
                return;
            }
            _ => return,
        };
        let (Segment::Line { end } | Segment::Arc { end, .. }) = segment else { return };
        self.at = end;
        let rapid = name == "STRAIGHT_TRAVERSE";
        self.answer.steps.push(Step { block: self.block, clause: clause::TRC_MODE_01, rapid, main: true, segment });
    }

    /// The blocks up to the one that this feed stands in have begun; those that do not move are executed here.
    fn feed(&mut self, feed: f64) {
        // The end of the program sets the feed to 0.
        let Some(block) = (feed as usize).checked_sub(1).filter(|block| *block < self.places.len()) else { return };
        self.block = block;
        if !self.places[block].moves {
            let (clause, segment) = (clause::TRC_LOOK_01, Segment::Hold);
            self.answer.steps.push(Step { block, clause, rapid: false, main: true, segment });
        }
    }

    /// The coordinates of the plane.
    fn plane(&self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        match self.plane {
            Plane::Xy => [x, y],
            Plane::Zx => [z, x],
            Plane::Yz => [y, z],
        }
    }
}

/// The name and the arguments of a canonical call: a counter, the N word of the line that is being read, the call.
fn call(line: &str) -> Option<(&str, &str)> {
    let line = line.trim_start();
    let counted = line.trim_start_matches(|c: char| c.is_ascii_digit());
    let rest = counted.strip_prefix(" N").filter(|_| counted.len() < line.len())?;
    let (head, arguments) = rest.split_once('(')?;
    // The N word is padded to six characters, which a long one fills.
    let name = head.rsplit(|c: char| !(c.is_ascii_uppercase() || c == '_')).next()?;
    Some((name, arguments.strip_suffix(')')?)).filter(|(name, _)| !name.is_empty())
}

/// The number of a line of a program.
fn number(line: &str) -> Option<usize> {
    let rest = line.trim_start().strip_prefix(['n', 'N'])?;
    let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    rest[..end].parse().ok()
}

/// An error message of the table.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Message {
    text: String,
    alarm: String,
    block: Where,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Where {
    Read,
    Before,
}

#[derive(Debug, Deserialize)]
struct Table {
    message: Vec<Message>,
}

static TABLE: LazyLock<Table> =
    // A test reads this constant text.
    LazyLock::new(|| toml::from_str(include_str!("alarms.toml")).expect("the table is well-formed"));

/// The alarm that a message stands for, when so many blocks had been read before.
fn alarm(text: &str, read: usize, places: &[Place]) -> Result<Alarm, DeviceFault> {
    let unknown =
        || DeviceFault::Garbled(format!("rs274 stops at N{} with an error that is no alarm here: {text}", read + 1));
    let message = TABLE.message.iter().find(|message| text.starts_with(&message.text)).ok_or_else(unknown)?;
    let kind = AlarmKind::ALL.iter().find(|kind| kind.id() == message.alarm).ok_or_else(unknown)?;
    // One message for either code, and one for either change of a radius.
    let place = places.get(read);
    let kind = match kind {
        AlarmKind::SideChangeForbidden if place.is_some_and(|place| place.same_code) => &AlarmKind::SameCode,
        AlarmKind::OffsetChangedInMode if place.is_some_and(|place| place.other_sign) => {
            &AlarmKind::SideChangeForbidden
        }
        kind => kind,
    };
    let before = (0..read).rev().find(|block| places.get(*block).is_some_and(|place| place.moves));
    let is_arc = before.is_none_or(|block| places[block].arc);
    let block = match (message.block, kind) {
        // Of a line before it this is said when the arc's offset does not meet the line's.
        (Where::Before, AlarmKind::ReversedArc) if !is_arc => {
            return Ok(Alarm { block: read, kind: AlarmKind::NoIntersection });
        }
        (Where::Read, _) => read,
        (Where::Before, _) => before.unwrap_or(read),
    };
    Ok(Alarm { block, kind: *kind })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_is_no_alarm_is_told() {
        let fault = alarm("Bad character used", 4, &[]).unwrap_err();
        assert_eq!(fault.id(), "garbled");
        assert!(fault.text().contains("at N5") && fault.text().contains("Bad character used"), "{fault}");
    }

    #[test]
    fn every_message_of_the_table_is_an_alarm_of_the_specification() {
        for message in &TABLE.message {
            assert!(AlarmKind::ALL.iter().any(|kind| kind.id() == message.alarm), "{}", message.alarm);
        }
    }

    #[test]
    fn calls_are_told_from_messages() {
        assert_eq!(call("   12 N3     STRAIGHT_FEED(1, 2, 3)"), Some(("STRAIGHT_FEED", "1, 2, 3")));
        assert_eq!(call("99999 N123456ARC_FEED(1)"), Some(("ARC_FEED", "1")));
        assert_eq!(call("    1 N..... ON_RESET()"), Some(("ON_RESET", "")));
        assert_eq!(call("N3 g1 x1 (a)"), None);
        assert_eq!(call("Zero-radius arc: start=(X0.0000,Y0.0000)"), None);
        assert_eq!(number("n12 g1 x1"), Some(12));
        assert_eq!(number("m2"), None);
    }
}
