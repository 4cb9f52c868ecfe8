//! What stands beside the drawing: the legend, the scale, the axes.

use svg::Document;
use svg::node::element::{Circle, Line, Path, Text};

use super::draw::{AMBER, GREEN, INK, RED, style, text};
use super::frame::{Frame, WIDTH};
use super::piece::Trace;
use super::scene::{MarkKind, Scene};

/// Width of an entry, and height of a row of entries.
const ENTRY: (f64, f64) = (235.0, 22.0);
/// Entries in a row.
const COLUMNS: usize = 4;

/// The height of the legend of a scene.
pub(super) fn height(scene: &Scene, notes: usize) -> f64 {
    // A handful of entries.
    entries(scene).len().div_ceil(COLUMNS) as f64 * ENTRY.1 + notes as f64 * 18.0 + 14.0
}

/// Draws the legend, and notes below it.
pub(super) fn legend(mut document: Document, scene: &Scene, frame: &Frame, notes: &[String]) -> Document {
    let mut bottom = frame.bottom;
    for (index, (entry, words)) in entries(scene).into_iter().enumerate() {
        let x = 40.0 + (index % COLUMNS) as f64 * ENTRY.0;
        let y = frame.bottom + (index / COLUMNS) as f64 * ENTRY.1;
        bottom = y + ENTRY.1;
        document = match entry {
            Entry::Trace(trace) => {
                let line = Line::new().set("x1", x).set("y1", y).set("x2", x + 36.0).set("y2", y);
                document.add(line.set("style", style(trace)))
            }
            Entry::Tool => document
                .add(Circle::new().set("cx", x + 18.0).set("cy", y).set("r", 8.0).set("style", super::draw::TOOL)),
            Entry::Start => document.add(dot(x + 18.0, y)),
            Entry::Mark(kind) => document.add(mark(x + 18.0, y, kind)),
        };
        document = document.add(text(x + 46.0, y + 4.0, words, INK));
    }
    for (index, note) in notes.iter().enumerate() {
        document = document.add(text(40.0, bottom + 4.0 + index as f64 * 18.0, note, INK));
    }
    document
}

enum Entry {
    Trace(Trace),
    Tool,
    Start,
    Mark(MarkKind),
}

/// Those that the scene has use for.
fn entries(scene: &Scene) -> Vec<(Entry, &'static str)> {
    let mut entries = Vec::new();
    let traces = [
        (Trace::Programmed, "programmed contour"),
        (Trace::Lead, "programmed start-up, cancel"),
        (Trace::Compensated, "tool centre, compensated"),
        (Trace::Corner, "corner move"),
        (Trace::Uncompensated, "tool centre, uncompensated"),
        (Trace::Rapid, "rapid traverse"),
        (Trace::Refused, "block with the alarm"),
    ];
    for (trace, words) in traces {
        if scene.programmed.iter().chain(&scene.path).any(|piece| piece.trace == trace) {
            entries.push((Entry::Trace(trace), words));
        }
    }
    if !scene.vectors.is_empty() {
        entries.push((Entry::Tool, "tool at its vectors"));
    }
    entries.push((Entry::Start, "start"));
    for (kind, words) in [(MarkKind::Advisory, "advisory"), (MarkKind::Alarm, "alarm: the tool stops")] {
        if scene.marks.iter().any(|mark| mark.kind == kind) {
            entries.push((Entry::Mark(kind), words));
        }
    }
    entries
}

/// The mark of the start.
pub(super) fn dot(x: f64, y: f64) -> Circle {
    Circle::new().set("cx", x).set("cy", y).set("r", 5.0).set("style", format!("fill:{GREEN};stroke:white"))
}

/// The mark of an advisory or an alarm.
pub(super) fn mark(x: f64, y: f64, kind: MarkKind) -> Path {
    match kind {
        MarkKind::Advisory => {
            let shape = format!("M{x:.1} {:.1} l8 14 h-16 z", y - 9.0);
            Path::new().set("d", shape).set("style", format!("fill:{AMBER};stroke:white;stroke-width:1.5"))
        }
        MarkKind::Alarm => {
            let shape = format!("M{:.1} {:.1} l14 14 m-14 0 l14 -14", x - 7.0, y - 7.0);
            Path::new().set("d", shape).set("style", format!("fill:none;stroke:{RED};stroke-width:4"))
        }
    }
}

/// The scale bar at the right and the directions of the axes at the left, below the drawing.
pub(super) fn scale_and_axes(document: Document, scene: &Scene, frame: &Frame) -> Document {
    let ((length, told), y) = (frame.round_length(), frame.bottom - 30.0);
    let (left, right) = (WIDTH - 40.0 - frame.length(length), WIDTH - 40.0);
    let bar = format!("M{left:.1} {:.1} v8 M{right:.1} {:.1} v8 M{left:.1} {y:.1} H{right:.1}", y - 4.0, y - 4.0);
    let (x, floor) = (44.0, frame.bottom - 24.0);
    let arrows = format!("M{x:.1} {floor:.1} h32 m-6 -4 l6 4 l-6 4 M{x:.1} {floor:.1} v-32 m-4 6 l4 -6 l4 6");
    let [first, second] = scene.axes.letters();
    let thin = format!("fill:none;stroke:{INK};stroke-width:1.2");
    document
        .add(Path::new().set("d", bar).set("style", &*thin))
        .add(text(right, y - 8.0, &told, INK).set("text-anchor", "end"))
        .add(Path::new().set("d", arrows).set("style", &*thin))
        .add(text(x + 37.0, floor + 4.0, &first.to_string(), INK))
        .add(axis_above(x, floor, second))
}

fn axis_above(x: f64, floor: f64, letter: char) -> Text {
    text(x, floor - 37.0, &letter.to_string(), INK).set("text-anchor", "middle")
}
