//! An adapter between radcomp and a control: JSON Lines in, JSON Lines out.
//!
//!     cargo build --release
//!     radcomp ping pipe:target/release/adapter
//!     radcomp certify pipe:target/release/adapter --profile NAME
//!
//! As it stands it knows programs without compensation, and says of every other one that it is not supported. Put your
//! control into `compensated`.

use std::io::{self, BufRead, Write};

use serde_json::{Value, json};

/// The number of the protocol that this adapter knows.
const PROTOCOL: u64 = 2;
/// What may stand in its blocks. Rather than read past what it does not know, it says that the program is not supported.
const KNOWN: [&str; 8] =
    ["movement", "rapid", "compensation", "radius", "corner", "approach", "stops_look_ahead", "not_in_mode"];

fn main() -> io::Result<()> {
    let mut out = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let request: Value = serde_json::from_str(&line?)?;
        let id = &request["id"];
        let answer = match path(&request) {
            // An alarm is {"block": 3, "alarm": "reversal"}.
            Ok(steps) => json!({ "id": id, "steps": steps, "alarm": null }),
            Err(reason) => json!({ "id": id, "unsupported": reason }),
        };
        writeln!(out, "{answer}")?;
        out.flush()?;
    }
    Ok(())
}

/// The path of the tool's centre, or why there is none.
fn path(request: &Value) -> Result<Vec<Value>, String> {
    if request["radcomp"] != PROTOCOL {
        return Err(format!("protocol {}: this adapter knows {PROTOCOL}", request["radcomp"]));
    }
    let blocks = request["blocks"].as_array().ok_or("no blocks")?;
    let fields = blocks.iter().filter_map(Value::as_object).flat_map(|block| block.keys());
    if let Some(field) = fields.into_iter().find(|field| !KNOWN.contains(&field.as_str())) {
        return Err(format!("blocks with {field}"));
    }
    match blocks.iter().any(|block| matches!(block["compensation"].as_str(), Some("left" | "right"))) {
        true => compensated(request),
        false => uncompensated(blocks),
    }
}

/// The program as your control reads it is `request["program"]`, G-code, with the tool radii `request["tools"]`; or
/// `request["blocks"]`, resolved. Numbers of a program are exact decimals in strings.
fn compensated(_request: &Value) -> Result<Vec<Value>, String> {
    Err("compensation: put your control here".to_owned())
}

/// Without compensation the centre follows the program.
fn uncompensated(blocks: &[Value]) -> Result<Vec<Value>, String> {
    let (mut steps, mut at) = (Vec::new(), [0.0, 0.0]);
    for (index, block) in blocks.iter().enumerate() {
        let rapid = block["rapid"].as_bool().unwrap_or(false);
        let (line, arc) = (&block["movement"]["line"], &block["movement"]["arc"]);
        if !line.is_null() {
            at = point(&line["end"])?;
            steps.push(json!({ "block": index, "shape": "line", "end": at, "rapid": rapid }));
        } else if !arc.is_null() {
            let [a, b] = point(&arc["centre"]["from-start"])?;
            let (start, end) = (at, point(&arc["end"])?);
            // The centre is absolute.
            let centre = [start[0] + a, start[1] + b];
            let direction = &arc["direction"];
            steps.push(json!({
                "block": index, "shape": "arc", "end": end, "centre": centre, "direction": direction,
                "full": start == end,
            }));
            at = end;
        } else if block["movement"] == "none" || !block["movement"]["dummy"].is_null() {
            steps.push(json!({ "block": index, "shape": "hold" }));
        } else {
            return Err(format!("the movement {}", block["movement"]));
        }
    }
    Ok(steps)
}

fn point(decimals: &Value) -> Result<[f64; 2], String> {
    let number = |index: usize| decimals[index].as_str().and_then(|text| text.parse().ok());
    match (number(0), number(1)) {
        (Some(a), Some(b)) => Ok([a, b]),
        _ => Err("not a point in the plane".to_owned()),
    }
}
