//! Closed contours that begin in the middle of a straight edge.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};

/// A closed contour in whole thousandths: its corners, and of each edge the arc's bulge, 0 for a line.
pub struct Shape {
    pub corners: Vec<[i64; 2]>,
    /// Radius in thousandths and sense of the arc from each corner to the next.
    pub arcs: Vec<Option<(i64, bool)>>,
}

pub struct Dice(ChaCha8Rng);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Dice(ChaCha8Rng::seed_from_u64(seed))
    }

    /// From low to high, both included.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        low + (self.0.next_u64() % (high - low + 1) as u64) as i64
    }
}

/// A star-shaped contour, counter-clockwise, of 4 to 14 corners about the origin; the first edge is a line.
pub fn star(dice: &mut Dice, arcs: bool) -> Shape {
    let count = dice.between(4, 14);
    let mut corners = Vec::new();
    for index in 0..count {
        let turn = (index as f64 + dice.between(-300, 300) as f64 / 1000.0) / count as f64;
        let (sine, cosine) = (turn * std::f64::consts::TAU).sin_cos();
        let radius = dice.between(15_000, 60_000) as f64;
        // Even, so that the middle of an edge is a whole number.
        corners.push([2 * (radius * cosine / 2.0) as i64, 2 * (radius * sine / 2.0) as i64]);
    }
    let chord = |index: usize| {
        let (p, q) = (corners[index], corners[(index + 1) % corners.len()]);
        ((p[0] - q[0]) as f64).hypot((p[1] - q[1]) as f64)
    };
    let mut of = |index: usize| {
        let bends = arcs && index > 0 && dice.between(0, 2) == 0;
        bends.then(|| ((chord(index) * dice.between(700, 3000) as f64 / 1000.0) as i64, dice.between(0, 1) == 1))
    };
    let arcs = (0..corners.len()).map(&mut of).collect();
    Shape { corners, arcs }
}

fn word(value: i64) -> String {
    format!("{}{}.{:03}", if value < 0 { "-" } else { "" }, value.abs() / 1000, value.abs() % 1000)
}

impl Shape {
    /// The middle of the first edge.
    pub fn start(&self) -> [i64; 2] {
        let (p, q) = (self.corners[0], self.corners[1]);
        [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2]
    }

    /// The program: G41 keeps to the inside, G42 to the outside.
    pub fn program(&self, code: &str) -> String {
        let start = self.start();
        let mut text = format!("{code} D1 G01 X{} Y{} F1\n", word(start[0]), word(start[1]));
        let count = self.corners.len();
        for index in 1..=count {
            let end = self.corners[index % count];
            let end = format!("X{} Y{}", word(end[0]), word(end[1]));
            text += &match self.arcs[index - 1] {
                None => format!("G01 {end}\n"),
                Some((radius, ccw)) => format!("{} {end} R{}\n", if ccw { "G03" } else { "G02" }, word(radius)),
            };
        }
        text + &format!("G01 X{} Y{}\nG40 X0 Y0\n", word(start[0]), word(start[1]))
    }

    /// Corners and bulges, tan(sweep / 4), in millimetres.
    pub fn bulges(&self) -> Vec<[f64; 3]> {
        let count = self.corners.len();
        let bulge = |index: usize| {
            let Some((radius, ccw)) = self.arcs[index] else { return 0.0 };
            let (p, q) = (self.corners[index], self.corners[(index + 1) % count]);
            let chord = ((p[0] - q[0]) as f64).hypot((p[1] - q[1]) as f64);
            let bulge = ((chord / (2.0 * radius as f64)).asin() / 2.0).tan();
            if ccw { bulge } else { -bulge }
        };
        (0..count).map(|k| [self.corners[k][0] as f64 / 1e3, self.corners[k][1] as f64 / 1e3, bulge(k)]).collect()
    }
}
