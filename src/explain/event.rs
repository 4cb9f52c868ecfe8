//! Elements of a path as JSON, for programs.

use radcomp_spec::block::Point;
use radcomp_spec::{Direction, Segment, Step};
use serde_json::{Map, Value, json};

use super::{Axes, Coordinate};

/// A path element: `kind` (line, arc or hold), `clause`, and of a move `main`, `end`, for an arc `centre`, `direction` and
/// `full`, for a line `rapid`. Points are objects of [`number`]s by axis, as the program writes them.
pub fn event<N: Coordinate>(step: &Step<N>, axes: Axes, digits: usize) -> Value {
    let point = |point: &Point<N>| {
        let axes = axes.program(point).map(|(letter, value)| (letter.to_string(), number(&value, digits)));
        Value::Object(Map::from_iter(axes))
    };
    let clause = step.clause.id();
    match &step.segment {
        Segment::Hold => json!({ "kind": "hold", "clause": clause }),
        Segment::Line { end } => json!({
            "kind": "line",
            "clause": clause,
            "rapid": step.rapid,
            "main": step.main,
            "end": point(end),
        }),
        Segment::Arc { end, centre, direction, full } => {
            let sense = match direction {
                Direction::Clockwise => "cw",
                Direction::Counterclockwise => "ccw",
            };
            json!({
                "kind": "arc",
                "clause": clause,
                "main": step.main,
                "end": point(end),
                "centre": point(centre),
                "direction": sense,
                "full": full,
            })
        }
    }
}

/// A number: `decimal` with at most so many digits after its point, and `exact`, its closed form, null if that is long.
pub fn number<N: Coordinate>(value: &N, digits: usize) -> Value {
    json!({ "decimal": value.short(digits), "exact": value.exact() })
}
