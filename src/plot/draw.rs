//! The picture as SVG.

use svg::Document;
use svg::node::element::{Circle, Line, Path, Polygon, Rectangle, Text};

use super::frame::{Frame, WIDTH};
use super::labels::Labels;
use super::legend;
use super::piece::{Form, Piece, Trace};
use super::scene::{MarkKind, Scene};

/// Dark grey of the programmed contour and of all text.
pub(super) const INK: &str = "#333333";
/// Blue of the centre path.
const BLUE: &str = "#1f5fbf";
/// Orange of the corner moves.
const ORANGE: &str = "#d9480f";
/// Colour of alarms.
pub(super) const RED: &str = "#c00000";
/// Colour of advisories.
pub(super) const AMBER: &str = "#e69500";
/// Colour of the start.
pub(super) const GREEN: &str = "#2b8a3e";
/// The tool.
pub(super) const TOOL: &str = "fill:#74a9e8;fill-opacity:0.14;stroke:#74a9e8;stroke-width:0.8";

/// At most so many tools, marks, labels, arrows are drawn.
const MOST_TOOLS: usize = 60;
const MOST_MARKS: usize = 200;
const MOST_LABELS: usize = 80;
const MOST_ARROWS: usize = 120;

/// The picture of a scene. What is left out of a large one is said below it.
pub fn svg(scene: &Scene, title: &str, subtitle: &str) -> String {
    let frame = Frame::around(scene);
    let notes = notes(scene);
    let height = frame.bottom + legend::height(scene, notes.len());
    let background = Rectangle::new().set("width", WIDTH).set("height", height).set("fill", "white");
    let mut document = Document::new()
        .set("viewBox", format!("0 0 {WIDTH} {height:.0}"))
        .set("width", WIDTH)
        .set("height", format!("{height:.0}"))
        .set("font-family", "Helvetica, Arial, 'DejaVu Sans', sans-serif")
        .set("font-size", 12)
        .add(background)
        .add(text(40.0, 28.0, title, INK).set("font-size", 16).set("font-weight", "bold"))
        .add(text(40.0, 47.0, subtitle, INK));
    document = axes_through_zero(document, &frame);
    for (point, radius) in spread(&scene.vectors, MOST_TOOLS) {
        let [x, y] = frame.place(*point);
        let circle = Circle::new().set("cx", short(x)).set("cy", short(y)).set("r", short(frame.length(*radius)));
        document = document.add(circle.set("style", TOOL));
    }
    for piece in scene.programmed.iter().filter(|piece| piece.trace != Trace::Followed).chain(&scene.path) {
        document = document.add(path(piece, &frame).set("style", style(piece.trace)));
    }
    for piece in spread(&arrowed(scene, &frame), MOST_ARROWS) {
        document = document.add(arrow(piece, &frame));
    }
    let start = scene.path.first().map_or([0.0, 0.0], |piece| piece.start);
    let [x, y] = frame.place(start);
    document = document.add(legend::dot(x, y));
    document = labels(document, scene, &frame);
    document = legend::scale_and_axes(document, scene, &frame);
    legend::legend(document, scene, &frame, &notes).to_string()
}

/// What is left out.
fn notes(scene: &Scene) -> Vec<String> {
    let mut notes = vec!["A name such as N40 stands at the programmed end of its block.".to_owned()];
    let (tools, names) = (scene.vectors.len(), scene.corners.len());
    if tools > MOST_TOOLS {
        notes.push(format!("The tool is drawn at {MOST_TOOLS} of its {tools} vectors."));
    }
    if scene.marks.len() > MOST_MARKS {
        notes.push(format!("{MOST_MARKS} of {} advisories and alarms are marked.", scene.marks.len()));
    }
    if names > MOST_LABELS {
        notes.push(format!("{MOST_LABELS} of {names} blocks are named."));
    }
    notes
}

/// At most so many of a list, evenly spread.
fn spread<T>(list: &[T], most: usize) -> impl Iterator<Item = &T> {
    let step = list.len().div_ceil(most).max(1);
    list.iter().step_by(step)
}

/// The line of a trace.
pub(super) fn style(trace: Trace) -> String {
    let (colour, width, dashes) = match trace {
        Trace::Programmed => (INK, 1.6, ""),
        Trace::Lead | Trace::Followed => ("#9a9a9a", 1.0, ""),
        Trace::Refused => (RED, 2.6, ""),
        Trace::Compensated => (BLUE, 1.8, ""),
        Trace::Corner => (ORANGE, 2.6, ""),
        Trace::Uncompensated => (BLUE, 1.0, ""),
        Trace::Rapid => (BLUE, 1.2, ";stroke-dasharray:7 5"),
    };
    format!("fill:none;stroke:{colour};stroke-width:{width};stroke-linejoin:round{dashes}")
}

/// A line of text that stays legible on what is drawn below it. Characters that XML does not have are left out.
pub(super) fn text(x: f64, y: f64, words: &str, colour: &str) -> Text {
    let words: String = words.chars().filter(|character| !character.is_control()).collect();
    let halo = "paint-order:stroke;stroke:white;stroke-width:3;stroke-linejoin:round";
    Text::new(words).set("x", short(x)).set("y", short(y)).set("fill", colour).set("style", halo)
}

/// A hundredth of a unit of the picture is not seen.
pub(super) fn short(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

fn axes_through_zero(document: Document, frame: &Frame) -> Document {
    let [x, y] = frame.place([0.0, 0.0]);
    let (top, bottom) = (58.0, frame.bottom - 80.0);
    let faint = |line: Line| line.set("stroke", "#bbbbbb").set("stroke-width", 0.7).set("stroke-dasharray", "2 3");
    let across = Line::new().set("x1", 30).set("x2", WIDTH - 30.0).set("y1", short(y)).set("y2", short(y));
    let up = Line::new().set("x1", short(x)).set("x2", short(x)).set("y1", top).set("y2", short(bottom));
    document.add(faint(across)).add(faint(up))
}

fn path(piece: &Piece, frame: &Frame) -> Path {
    Path::new().set("d", outline(piece, frame))
}

/// The path data of a piece.
pub(super) fn outline(piece: &Piece, frame: &Frame) -> String {
    let [x, y] = frame.place(piece.start).map(short);
    let mut data = format!("M{x} {y}");
    match (piece.form, piece.sweep(), piece.radius()) {
        (Form::Arc { .. }, Some((_, sweep)), Some(radius)) => {
            // Two arcs, so that a whole circle is drawn too. Up is negative: counter-clockwise is sweep 0.
            let (radius, flag) = (short(frame.length(radius)), u8::from(sweep < 0.0));
            for point in [piece.at(0.5).0, piece.end] {
                let [x, y] = frame.place(point).map(short);
                data.push_str(&format!("A{radius} {radius} 0 0 {flag} {x} {y}"));
            }
        }
        _ => {
            let [x, y] = frame.place(piece.end).map(short);
            data.push_str(&format!("L{x} {y}"));
        }
    }
    data
}

/// The pieces of the centre path that are long enough for an arrow.
pub(super) fn arrowed<'s>(scene: &'s Scene, frame: &Frame) -> Vec<&'s Piece> {
    scene.path.iter().filter(|piece| frame.length(piece.length()) > 34.0).collect()
}

fn arrow(piece: &Piece, frame: &Frame) -> Polygon {
    let (point, heading) = piece.at(0.5);
    let [x, y] = frame.place(point);
    let tip = |along: f64, across: f64| {
        let (sine, cosine) = heading.sin_cos();
        format!("{:.1},{:.1}", x + along * cosine + across * sine, y - along * sine + across * cosine)
    };
    let colour = if piece.trace == Trace::Corner { ORANGE } else { BLUE };
    let points = [tip(7.0, 0.0), tip(-5.0, 4.5), tip(-5.0, -4.5)].join(" ");
    Polygon::new().set("points", points).set("fill", colour)
}

fn labels(mut document: Document, scene: &Scene, frame: &Frame) -> Document {
    let mut labels = Labels::new(frame.samples(scene), [4.0, 54.0], [WIDTH - 4.0, frame.bottom - 78.0]);
    for mark in spread(&scene.marks, MOST_MARKS) {
        let [x, y] = frame.place(mark.point);
        document = document.add(legend::mark(x, y, mark.kind));
    }
    for mark in spread(&scene.marks, MOST_LABELS) {
        let colour = if mark.kind == MarkKind::Alarm { RED } else { "#8a5a00" };
        document = document.add(label(&mut labels, frame.place(mark.point), &mark.text, colour));
    }
    for (point, name) in spread(&scene.corners, MOST_LABELS) {
        let [x, y] = frame.place(*point).map(short);
        document = document.add(Circle::new().set("cx", x).set("cy", y).set("r", 2.2).set("fill", INK));
        document = document.add(label(&mut labels, [x, y], name, INK));
    }
    document
}

fn label(labels: &mut Labels, point: [f64; 2], words: &str, colour: &str) -> Text {
    let [x, y] = labels.place(point, words);
    text(x, y + 4.0, words, colour).set("text-anchor", "middle")
}
