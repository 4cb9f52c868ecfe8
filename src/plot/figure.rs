//! A small figure for a page of the book: its colours are the page's, its numbers stand beside it.

use std::fmt::Write;

use radcomp_spec::block::Point;

use super::draw::{arrowed, outline, short};
use super::frame::{Frame, Sheet};
use super::labels::Labels;
use super::piece::Trace;
use super::scene::{MarkKind, Scene};

/// As wide as a telephone shows without making it smaller.
const SHEET: Sheet = Sheet { width: 340.0, top: 22.0, side: 34.0, height: (270.0, 70.0), below: 40.0 };

/// At most so many tools and names are drawn; examples have fewer.
const MOST_TOOLS: usize = 40;
const MOST_NAMES: usize = 30;

/// The figure of a scene as an `svg` element; `label` says for those who do not see it what it shows.
///
/// Every part has a class, so that a style sheet gives it its colour: `programmed`, `lead`, `followed`, `refused`, `path`,
/// `corner`, `free`, `rapid`, `tool`, `normal`, `vector`, `start`, `advisory`, `alarm`.
pub fn figure(scene: &Scene, label: &str) -> String {
    let frame = Frame::on(SHEET, scene, &scene.normals);
    let mut out = format!(
        "<svg class=\"figure\" role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\">",
        escaped(label),
        SHEET.width,
        short(frame.bottom)
    );
    // Writing to a string cannot fail.
    for (point, radius) in scene.vectors.iter().take(MOST_TOOLS) {
        let [x, y] = frame.place(*point).map(short);
        let _ = write!(out, "<circle class=\"tool\" cx=\"{x}\" cy=\"{y}\" r=\"{}\"/>", short(frame.length(*radius)));
    }
    for [from, to] in &scene.normals {
        let ([x1, y1], [x2, y2]) = (frame.place(*from).map(short), frame.place(*to).map(short));
        let _ = write!(out, "<path class=\"normal\" d=\"M{x1} {y1}L{x2} {y2}\"/>");
    }
    let programmed = scene.programmed.iter().filter(|piece| piece.trace != Trace::Followed);
    for piece in programmed.chain(&scene.path) {
        let _ = write!(out, "<path class=\"{}\" d=\"{}\"/>", class(piece.trace), outline(piece, &frame));
    }
    for piece in arrowed(scene, &frame) {
        let (point, heading) = piece.at(0.5);
        let [x, y] = frame.place(point).map(short);
        let turn = short(-heading.to_degrees());
        let _ = write!(
            out,
            "<path class=\"arrow {}\" transform=\"translate({x} {y}) rotate({turn})\" d=\"M5 0L-4 3.4V-3.4Z\"/>",
            class(piece.trace)
        );
    }
    for (point, _) in scene.vectors.iter().take(MOST_TOOLS) {
        dot(&mut out, &frame, *point, "vector", 2.0);
    }
    dot(&mut out, &frame, scene.path.first().map_or([0.0, 0.0], |piece| piece.start), "start", 3.4);
    names(&mut out, scene, &frame);
    scale(&mut out, scene, &frame);
    out + "</svg>"
}

fn class(trace: Trace) -> &'static str {
    match trace {
        Trace::Programmed => "programmed",
        Trace::Lead => "lead",
        Trace::Followed => "followed",
        Trace::Refused => "refused",
        Trace::Compensated => "path",
        Trace::Corner => "corner",
        Trace::Uncompensated => "free",
        Trace::Rapid => "rapid",
    }
}

fn dot(out: &mut String, frame: &Frame, point: Point<f64>, class: &str, radius: f64) {
    let [x, y] = frame.place(point).map(short);
    let _ = write!(out, "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>");
}

/// The marks of advisories and the alarm, and the names of blocks at their programmed ends.
fn names(out: &mut String, scene: &Scene, frame: &Frame) {
    let mut labels = Labels::new(frame.samples(scene), [2.0, 2.0], [SHEET.width - 2.0, frame.bottom - 24.0]);
    for mark in &scene.marks {
        let [x, y] = frame.place(mark.point).map(short);
        let (class, shape) = match mark.kind {
            MarkKind::Advisory => ("advisory", "M0 -7L6 4H-6Z"),
            MarkKind::Alarm => ("alarm", "M-5 -5L5 5M-5 5L5 -5"),
        };
        let _ = write!(out, "<path class=\"{class}\" transform=\"translate({x} {y})\" d=\"{shape}\"/>");
    }
    let mut seen: Vec<(Point<f64>, String)> = Vec::new();
    for (point, name) in scene.corners.iter().take(MOST_NAMES) {
        let name = name.trim_start_matches("line ");
        // Blocks that end at one point share a label.
        match seen.iter_mut().find(|(known, _)| known == point) {
            Some((_, names)) => *names = format!("{names}, {name}"),
            None => seen.push((*point, name.to_owned())),
        }
    }
    for (point, names) in seen {
        dot(out, frame, point, "point", 1.8);
        let [x, y] = labels.place(frame.place(point), &names).map(short);
        let _ = write!(out, "<text class=\"name\" x=\"{x}\" y=\"{}\">{}</text>", y + 4.0, escaped(&names));
    }
}

/// The scale at the right and the directions of the axes at the left, below the drawing.
fn scale(out: &mut String, scene: &Scene, frame: &Frame) {
    let ((length, told), y) = (frame.round_length(), short(frame.bottom - 8.0));
    let (left, right) = (short(SHEET.width - 10.0 - frame.length(length)), SHEET.width - 10.0);
    let [first, second] = scene.axes.letters();
    let _ = write!(
        out,
        "<path class=\"rule\" d=\"M{left} {}V{y}H{right}V{}\"/><text class=\"unit length\" x=\"{}\" y=\"{}\">{told}</text>",
        y - 4.0,
        y - 4.0,
        right,
        y - 6.0
    );
    let _ = write!(
        out,
        "<path class=\"rule\" d=\"M10 {}V{y}H28m-4 -3l4 3l-4 3M7 {}l3 -4l3 4\"/><text class=\"unit\" x=\"36\" y=\"{}\">\
         {first}</text><text class=\"unit\" x=\"10\" y=\"{}\">{second}</text>",
        y - 18.0,
        y - 14.0,
        y + 4.0,
        y - 21.0
    );
}

fn escaped(text: &str) -> String {
    let text: String = text.chars().filter(|character| !character.is_control()).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
