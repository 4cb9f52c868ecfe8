//! A picture of a failure: the programmed contour, the path that the rules give, the path that the device gave, the first
//! element that differs, and that place magnified.
//!
//! Coordinates are drawn as doubles; nothing is decided here.

mod gather;
mod view;

use svg::Document;
use svg::node::element::{Circle, ClipPath, Definitions, Group, Line, Path, Rectangle};

use super::draw::{INK, TOOL, short, text};
use super::labels::Labels;
use super::legend;
use super::piece::{Piece, Trace};
use super::scene::MarkKind;
use crate::explain::Axes;
use crate::report::Case;
use gather::{Gathered, gather};
use radcomp_spec::Parameters;
use view::View;

/// Width and height of the picture.
const SIZE: [f64; 2] = [1000.0, 640.0];
/// The whole, and the place that is magnified: the upper left corners and the sizes.
const WHOLE: ([f64; 2], [f64; 2]) = ([20.0, 84.0], [600.0, 460.0]);
const INSET: ([f64; 2], [f64; 2]) = ([640.0, 84.0], [340.0, 340.0]);

const CONTOUR: &str = "fill:none;stroke:#333333;stroke-width:1.6";
const EXPECTED: &str = "fill:none;stroke:#1f5fbf;stroke-width:2.4";
const OBSERVED: &str = "fill:none;stroke:#d9480f;stroke-width:2.2;stroke-dasharray:8 5";
/// The band under the first element that differs.
const MARKED: &str = "fill:none;stroke:#ffd43b;stroke-width:11;stroke-opacity:0.75;stroke-linecap:round";
const FRAME: &str = "fill:none;stroke:#868e96;stroke-width:1.2";

/// The picture of a failed case. `name` sets its elements apart from those of other pictures on one page; `title` stands
/// above it.
pub fn comparison(case: &Case, parameters: &Parameters, axes: Axes, name: &str, title: &str) -> String {
    let gathered = gather(case, parameters);
    let whole = View::of(gathered.bounds(), WHOLE.0, WHOLE.1);
    let (middle, half) = gathered.focus();
    let bounds = [0, 1].map(|axis: usize| [middle[axis] - half, middle[axis] + half]);
    let inset = View::of(bounds, INSET.0, INSET.1);
    let mut document = Document::new()
        .set("viewBox", format!("0 0 {} {}", SIZE[0], SIZE[1]))
        .set("width", SIZE[0])
        .set("height", SIZE[1])
        .set("role", "img")
        .set("aria-label", title)
        .set("font-family", "Helvetica, Arial, 'DejaVu Sans', sans-serif")
        .set("font-size", 12)
        .add(Rectangle::new().set("width", SIZE[0]).set("height", SIZE[1]).set("fill", "white"))
        .add(text(20.0, 30.0, title, INK).set("font-size", 16).set("font-weight", "bold"));
    let subtitle = format!("{}: {}", case.name, gathered.told);
    document = document.add(text(20.0, 52.0, &subtitle, INK));
    let mut clips = Definitions::new();
    for (part, (corner, size)) in [("whole", WHOLE), ("inset", INSET)] {
        let window = Rectangle::new().set("x", corner[0]).set("y", corner[1]).set("width", size[0]);
        let clip = ClipPath::new().set("id", format!("{name}-{part}")).add(window.set("height", size[1]));
        clips = clips.add(clip);
    }
    document = document.add(clips);
    let mark = place_of(&whole, middle, half);
    if case.divergence.is_some() {
        document = document.add(leader(mark));
    }
    for (part, view) in [("whole", &whole), ("inset", &inset)] {
        let clip = format!("url(#{name}-{part})");
        document = document.add(drawing(&gathered, view).set("clip-path", clip)).add(view.border(FRAME));
    }
    if case.divergence.is_some() {
        let clip = format!("url(#{name}-whole)");
        document = document.add(square(mark).set("style", FRAME).set("clip-path", clip));
    }
    document = labels(document, &gathered, &whole);
    document = document.add(whole.scale_bar()).add(whole.scale_words()).add(inset.scale_bar()).add(inset.scale_words());
    document = axes_words(document, axes);
    let times = short_count(inset.scale() / whole.scale());
    document = document.add(text(INSET.0[0], INSET.0[1] - 8.0, &format!("magnified {times} times"), INK));
    legend_words(document, &gathered).to_string()
}

/// Both paths and the contour in one view.
fn drawing(gathered: &Gathered, view: &View) -> Group {
    let mut group = Group::new();
    for end in [gathered.expected_end, gathered.observed_end].into_iter().flatten() {
        let [x, y] = view.place(end);
        let radius = view.length(gathered.radius);
        // A tool that fills the view shows nothing.
        if gathered.radius > 0.0 && radius < 2.0 * SIZE[0] {
            let circle = Circle::new().set("cx", short(x)).set("cy", short(y)).set("r", short(radius));
            group = group.add(circle.set("style", TOOL));
        }
    }
    for piece in [&gathered.expected_piece, &gathered.observed_piece].into_iter().flatten() {
        group = group.add(path(piece, view, MARKED));
    }
    let layers = [(&gathered.contour, CONTOUR), (&gathered.expected, EXPECTED), (&gathered.observed, OBSERVED)];
    for (pieces, style) in layers {
        for piece in pieces {
            group = group.add(path(piece, view, style));
        }
    }
    let [x, y] = view.place([0.0, 0.0]);
    if view.holds([0.0, 0.0]) {
        group = group.add(legend::dot(short(x), short(y)));
    }
    for (end, style) in [(gathered.expected_end, EXPECTED), (gathered.observed_end, OBSERVED)] {
        let Some([x, y]) = end.map(|end| view.place(end)) else { continue };
        let ring = Circle::new().set("cx", short(x)).set("cy", short(y)).set("r", 5.5);
        group = group.add(ring.set("style", style.replace("dasharray:8 5", "dasharray:none")));
    }
    for point in &gathered.alarms {
        let [x, y] = view.place(*point);
        group = group.add(legend::mark(x, y, MarkKind::Alarm));
    }
    group
}

fn path(piece: &Piece, view: &View, style: &str) -> Path {
    let mut style = style.to_owned();
    if piece.trace == Trace::Lead {
        style = style.replace("#333333", "#9a9a9a");
    }
    Path::new().set("d", view.outline(piece)).set("style", style)
}

/// Where the magnified place lies in the whole: the middle and half the side of a square that can be seen.
fn place_of(whole: &View, middle: [f64; 2], half: f64) -> ([f64; 2], f64) {
    (whole.place(middle), whole.length(half).max(9.0))
}

fn square(([x, y], half): ([f64; 2], f64)) -> Rectangle {
    let side = short(2.0 * half);
    Rectangle::new().set("x", short(x - half)).set("y", short(y - half)).set("width", side).set("height", side)
}

/// From the square to the inset.
fn leader(([x, y], half): ([f64; 2], f64)) -> Line {
    let line = Line::new().set("x1", short(x + half)).set("y1", short(y - half));
    line.set("x2", INSET.0[0]).set("y2", INSET.0[1]).set("style", FRAME).set("stroke-opacity", 0.5)
}

fn labels(mut document: Document, gathered: &Gathered, view: &View) -> Document {
    const MOST: usize = 40;
    let pieces = gathered.contour.iter().chain(&gathered.expected).chain(&gathered.observed);
    let samples = pieces.flat_map(|piece| view.samples(piece)).take(20_000).collect();
    let high = [WHOLE.0[0] + WHOLE.1[0], WHOLE.0[1] + WHOLE.1[1]];
    let mut labels = Labels::new(samples, WHOLE.0, high);
    for (point, name) in gathered.names.iter().filter(|(point, _)| view.holds(*point)).take(MOST) {
        let [x, y] = view.place(*point).map(short);
        document = document.add(Circle::new().set("cx", x).set("cy", y).set("r", 2.2).set("fill", INK));
        let [a, b] = labels.place([x, y], name).map(short);
        document = document.add(text(a, b + 4.0, name, INK).set("text-anchor", "middle"));
    }
    document
}

/// The letters of the axes below the whole.
fn axes_words(document: Document, axes: Axes) -> Document {
    let [first, second] = axes.letters();
    let words = format!("{} ({first}, {second}): {first} to the right, {second} up", axes.code());
    document.add(text(WHOLE.0[0], WHOLE.0[1] + WHOLE.1[1] + 20.0, &words, INK))
}

fn legend_words(mut document: Document, gathered: &Gathered) -> Document {
    let lines = [
        (CONTOUR, "programmed contour"),
        (EXPECTED, "expected: the tool's centre by the rules"),
        (OBSERVED, "observed: the device's path"),
        (MARKED, "the first element that differs"),
    ];
    let x = INSET.0[0];
    let top = INSET.0[1] + INSET.1[1] + 44.0;
    let mut y = top;
    for (style, words) in lines {
        let line = Line::new().set("x1", x).set("x2", x + 40.0).set("y1", y - 4.0).set("y2", y - 4.0);
        document = document.add(line.set("style", style)).add(text(x + 52.0, y, words, INK));
        y += 22.0;
    }
    if gathered.radius > 0.0 {
        let circle = Circle::new().set("cx", x + 20.0).set("cy", y - 4.0).set("r", 8.0).set("style", TOOL);
        let words = format!("the tool there, radius {} mm", gathered.radius);
        document = document.add(circle).add(text(x + 52.0, y, &words, INK));
        y += 22.0;
    }
    if !gathered.alarms.is_empty() {
        document = document.add(legend::mark(x + 20.0, y - 4.0, MarkKind::Alarm));
        document = document.add(text(x + 52.0, y, "an alarm stops the tool", INK));
    }
    document
}

/// A count to about two digits.
fn short_count(count: f64) -> String {
    match count {
        ..1e5 => format!("{count:.1}"),
        _ => format!("{count:.1e}").replace('e', "·10^"),
    }
}
