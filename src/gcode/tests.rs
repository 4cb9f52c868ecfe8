//! Tests of the reader and the printer. Behaviour is data, in `tests/gcode`.

mod behaviour;
mod messages;
mod printing;
mod properties;
mod streaming;
mod tables;

use radcomp_model::number::format_decimal;
use radcomp_spec::{Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

use super::{ReadBlock, Tool, Tools};

/// The tool table of the tests.
fn tools() -> Tools {
    let tool = |tools: Tools, number, numerator, denominator| {
        tools.with_radius(number, Rational::from((numerator, denominator)))
    };
    let tools = tool(tool(tool(Tools::empty(), 1, 5, 1), 2, 4, 5), 12, 1, 2);
    let nose = Tool { geometry: Rational::from(1), wear: Rational::from((-1, 4)), orientation: Some(3) };
    tool(tools.with_tool(3, nose), 4, -1, 1)
}

/// A block in one line: movement, then the codes, then the normal coordinate unless it is 0.
fn describe(read: &ReadBlock) -> String {
    let number = |value: &Rational| format_decimal(value).unwrap_or_else(|| value.to_string());
    let pair = |point: &[Rational; 2]| format!("{} {}", number(&point[0]), number(&point[1]));
    let mut text = match &read.block.movement {
        Movement::None if read.block.rapid => "none at rapid".to_owned(),
        Movement::None => "none".to_owned(),
        Movement::Line { end } if read.block.rapid => format!("rapid {}", pair(end)),
        Movement::Line { end } => format!("line {}", pair(end)),
        Movement::Dummy { vector } if read.block.rapid => format!("dummy {} at rapid", pair(vector)),
        Movement::Dummy { vector } => format!("dummy {}", pair(vector)),
        Movement::HeldVector { end } if read.block.rapid => format!("held {} at rapid", pair(end)),
        Movement::HeldVector { end } => format!("held {}", pair(end)),
        Movement::NewVector { vector } => format!("new vector {}", pair(vector)),
        Movement::CornerArc { vector: Some(vector) } => format!("corner arc to {}", pair(vector)),
        Movement::CornerArc { vector: None } => "corner arc".to_owned(),
        Movement::Arc { end, centre, direction } => {
            let sense = if *direction == Direction::Clockwise { "cw" } else { "ccw" };
            let centre = match centre {
                Centre::FromStart(centre) => format!("centre {}", pair(centre)),
                Centre::Radius(radius) => format!("radius {}", number(radius)),
            };
            format!("{sense} {} {centre}", pair(end))
        }
    };
    text += match read.block.compensation {
        None => "",
        Some(Compensation::Off) => ", off",
        Some(Compensation::On(Side::Left)) => ", left",
        Some(Compensation::On(Side::Right)) => ", right",
    };
    if let Some(vector) = &read.block.vector {
        text += &format!(", vector {}", pair(vector));
    }
    if let Some(radius) = &read.block.radius {
        text += &format!(", tool radius {}", number(radius));
    }
    text += match read.block.corner {
        None => "",
        Some(OuterCorner::Arc) => ", corners by arc",
        Some(OuterCorner::Intersection) => ", corners by intersection",
        Some(OuterCorner::LimitAngle) => ", corners by limit angle",
    };
    if read.block.stops_look_ahead {
        text += ", stops reading ahead";
    }
    if let Some(kind) = read.block.not_in_mode {
        text += &format!(", {}", kind.id());
    }
    if let Some(nose) = &read.nose {
        text += &format!(", tip {} of radius {}", nose.tip.id(), number(&nose.radius));
    }
    if !read.normal.is_zero() {
        text += &format!(", normal {}", number(&read.normal));
    }
    text
}
