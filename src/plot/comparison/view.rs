//! A window of the picture, and what of a piece lies in it.

use radcomp_spec::block::Point;
use svg::node::element::{Path, Rectangle, Text};

use crate::plot::draw::{INK, short, text};
use crate::plot::piece::{Form, Piece};

/// A map from a part of the plane to a window of the picture: the first axis to the right, the second up.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    scale: f64,
    /// The part's middle in the plane, and the window's in the picture.
    middle: Point<f64>,
    centre: Point<f64>,
    /// The window.
    corner: Point<f64>,
    size: Point<f64>,
}

/// The parts of the window that stay free around what it must hold.
const MARGIN: f64 = 0.06;

impl View {
    /// The window that holds these bounds, lowest and highest on each axis.
    pub(super) fn of(bounds: [[f64; 2]; 2], corner: Point<f64>, size: Point<f64>) -> View {
        let room = [0, 1].map(|axis: usize| size[axis] * (1.0 - 2.0 * MARGIN));
        let extent = bounds.map(|[low, high]| (high - low).max(f64::MIN_POSITIVE));
        let scale = (room[0] / extent[0]).min(room[1] / extent[1]).min(1e15);
        let middle = bounds.map(|[low, high]| low.midpoint(high));
        let centre = [0, 1].map(|axis: usize| corner[axis] + size[axis] / 2.0);
        View { scale, middle, centre, corner, size }
    }

    /// Units of the picture to a millimetre.
    pub(super) fn scale(&self) -> f64 {
        self.scale
    }

    /// A point of the plane in the picture. Subtracting first keeps what differs by little apart.
    pub(super) fn place(&self, point: Point<f64>) -> Point<f64> {
        let [a, b] = [0, 1].map(|axis: usize| (point[axis] - self.middle[axis]) * self.scale);
        [self.centre[0] + a, self.centre[1] - b]
    }

    /// A length of the plane in the picture.
    pub(super) fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// Whether a point lies in the window.
    pub(super) fn holds(&self, point: Point<f64>) -> bool {
        let place = self.place(point);
        (0..2).all(|axis| (self.corner[axis]..=self.corner[axis] + self.size[axis]).contains(&place[axis]))
    }

    /// The path of what may be seen of a piece, as short chords: a renderer's numbers are too coarse for the whole of it
    /// in a window far smaller.
    pub(super) fn outline(&self, piece: &Piece) -> String {
        let reach = self.size[0].hypot(self.size[1]) / 2.0 / self.scale;
        let mut chords = Vec::new();
        self.chords(piece, [0.0, 1.0], reach, 0, &mut chords);
        let mut data = String::new();
        let mut last = f64::NAN;
        for [from, to] in chords {
            let point = |part: f64| {
                let [x, y] = self.place(at(piece, part)).map(short);
                format!("{x} {y}")
            };
            if from != last {
                data.push_str(&format!("M{}", point(from)));
            }
            data.push_str(&format!("L{}", point(to)));
            last = to;
        }
        data
    }

    /// The parts of a piece near the window, each so short that its chord stands for it.
    fn chords(&self, piece: &Piece, part: [f64; 2], reach: f64, depth: u32, found: &mut Vec<[f64; 2]>) {
        const DEEPEST: u32 = 64;
        let [from, to] = part;
        let (length, middle) = (piece.length() * (to - from), from.midpoint(to));
        let [a, b] = at(piece, middle);
        // No point of a part is farther from its middle than half its length.
        if (a - self.middle[0]).hypot(b - self.middle[1]) > length / 2.0 + reach {
            return;
        }
        let short_enough = if piece.form == Form::Straight { 4.0 * reach } else { reach / 40.0 };
        if length <= short_enough || depth == DEEPEST {
            found.push(part);
            return;
        }
        self.chords(piece, [from, middle], reach, depth + 1, found);
        self.chords(piece, [middle, to], reach, depth + 1, found);
    }

    /// Points of a piece in the picture, for labels to keep away from.
    pub(super) fn samples(&self, piece: &Piece) -> Vec<Point<f64>> {
        let count = (self.length(piece.length()) / 6.0).ceil().clamp(1.0, 400.0);
        (0..=count as u32).map(|index| self.place(at(piece, f64::from(index) / count))).collect()
    }

    /// The window's border.
    pub(super) fn border(&self, style: &str) -> Rectangle {
        let rectangle = Rectangle::new().set("x", self.corner[0]).set("y", self.corner[1]);
        rectangle.set("width", self.size[0]).set("height", self.size[1]).set("style", style)
    }

    /// A round length, in millimetres, that takes about a quarter of the window's width.
    fn round_length(&self) -> f64 {
        let wanted = self.size[0] / 4.0 / self.scale;
        let power = wanted.log10().floor() as i32;
        // A parsed decimal has no digits of rounding.
        let steps = [5, 2, 1].map(|step| format!("{step}e{power}").parse().unwrap_or(wanted));
        steps.into_iter().find(|step| *step <= wanted).unwrap_or(wanted)
    }

    /// The scale bar below the window, at its right.
    pub(super) fn scale_bar(&self) -> Path {
        let right = self.corner[0] + self.size[0];
        let (left, y) = (short(right - self.length(self.round_length())), self.corner[1] + self.size[1] + 12.0);
        let data = format!("M{left} {} v8 M{right} {} v8 M{left} {y} H{right}", y - 4.0, y - 4.0);
        Path::new().set("d", data).set("style", format!("fill:none;stroke:{INK};stroke-width:1.2"))
    }

    /// What the scale bar measures.
    pub(super) fn scale_words(&self) -> Text {
        let length = self.round_length();
        let words = if length < 1e-4 { format!("{length:e} mm") } else { format!("{length} mm") };
        let x = self.corner[0] + self.size[0] - self.length(length) / 2.0;
        text(x, self.corner[1] + self.size[1] + 28.0, &words, INK).set("text-anchor", "middle")
    }
}

/// A point of a piece; its ends are its own.
fn at(piece: &Piece, part: f64) -> Point<f64> {
    match part {
        0.0 => piece.start,
        1.0 => piece.end,
        part => piece.at(part).0,
    }
}
