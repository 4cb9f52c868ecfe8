//! The closed contours that all contestants offset, and the programs that run along them.

use std::f64::consts::TAU;
use std::fmt::Write;

use cavalier_contours::polyline::{PlineSourceMut, Polyline};
use radcomp_spec::block::Point;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Side};
use rug::Rational;

/// The tool's radius, in millimetres: smaller than every arc and far smaller than every block.
pub const TOOL_RADIUS: f64 = 0.5;
const TOOL_RADIUS_MICROMETRES: i64 = 500;

/// The radius of the ring that the vertices stand about, in millimetres.
const RING: f64 = 1000.0;

/// A closed counter-clockwise contour on a grid of micrometres, so that f64, rationals and G-code say the same.
pub struct Contour {
    vertices: Vec<Vertex>,
}

/// A vertex, and the arc or line from it to the next.
struct Vertex {
    point: Point<i64>,
    /// The tangent of a quarter of the sweep to the next vertex; positive counter-clockwise, zero for a line.
    bulge: f64,
}

impl Contour {
    /// Lines with convex and concave corners of 35° in turn.
    pub fn star(vertices: usize) -> Self {
        Self::ring(vertices, |i| if i % 2 == 0 { 1.0 } else { -1.0 }, |_| 0.0)
    }

    /// Arcs alone, two to the left and two to the right: convex, concave and, but for the grid, tangent junctions.
    pub fn scallops(vertices: usize) -> Self {
        Self::ring(vertices, |_| 0.0, |i| if i % 4 < 2 { 0.25 } else { -0.25 })
    }

    fn ring(vertices: usize, outward: impl Fn(usize) -> f64, bulge: impl Fn(usize) -> f64) -> Self {
        let vertex = |i: usize| {
            let (sine, cosine) = (TAU * i as f64 / vertices as f64).sin_cos();
            let distance = RING + outward(i);
            Vertex { point: [micrometres(distance * cosine), micrometres(distance * sine)], bulge: bulge(i) }
        };
        Contour { vertices: (0..vertices).map(vertex).collect() }
    }

    /// The vertices, in millimetres.
    pub fn points(&self) -> Vec<Point<f64>> {
        self.vertices.iter().map(|vertex| vertex.point.map(millimetres)).collect()
    }

    /// The contour as the peer's polyline.
    pub fn polyline(&self) -> Polyline<f64> {
        let mut polyline = Polyline::new_closed();
        for vertex in &self.vertices {
            let [x, y] = vertex.point.map(millimetres);
            polyline.add(x, y, vertex.bulge);
        }
        polyline
    }

    /// The program that runs once round the contour, in f64.
    pub fn program_f64(&self) -> Program<f64> {
        self.program(millimetres)
    }

    /// The same program in rationals.
    pub fn program_exact(&self) -> Program<Rational> {
        self.program(|micrometres| Rational::from((micrometres, 1000)))
    }

    fn program<N>(&self, number: impl Fn(i64) -> N) -> Program<N> {
        let line = |point: Point<i64>| Block::moving(Movement::Line { end: point.map(&number) });
        let [first_x, first_y] = self.vertices[0].point;
        let approach = [first_x - 20_000, first_y - 20_000];
        let mut start_up = line([first_x, first_y]);
        start_up.compensation = Some(Compensation::On(Side::Left));
        start_up.radius = Some(number(TOOL_RADIUS_MICROMETRES));
        let mut cancel = line(approach);
        cancel.compensation = Some(Compensation::Off);
        Program { before: vec![line(approach), start_up], lap: self.lap(&number), after: vec![cancel] }
    }

    fn lap<N>(&self, number: &impl Fn(i64) -> N) -> Vec<Block<N>> {
        let edges = self.vertices.iter().zip(self.vertices.iter().cycle().skip(1));
        let block = |(from, to): (&Vertex, &Vertex)| {
            let end = to.point.map(number);
            Block::moving(if from.bulge == 0.0 {
                Movement::Line { end }
            } else {
                Movement::Arc {
                    end,
                    centre: Centre::FromStart(centre_from_start(from, to).map(number)),
                    direction: if from.bulge > 0.0 { Direction::Counterclockwise } else { Direction::Clockwise },
                }
            })
        };
        edges.map(block).collect()
    }

    /// The words of the straight blocks that run `blocks` blocks round the contour, as G-code in millimetres.
    pub fn g_code(&self, blocks: usize) -> String {
        let [first_x, first_y] = self.vertices[0].point.map(millimetres);
        let mut text = format!("g21 g17 g90 g40\ng0 x{} y{}\n", first_x - 20.0, first_y - 20.0);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "g41.1 d{} g1 x{first_x} y{first_y} f1000", 2.0 * TOOL_RADIUS);
        for vertex in self.vertices.iter().cycle().skip(1).take(blocks) {
            let [x, y] = vertex.point.map(millimetres);
            let _ = writeln!(text, "x{x} y{y}");
        }
        let _ = writeln!(text, "g40 x{} y{}", first_x - 20.0, first_y - 20.0);
        text
    }
}

/// Blocks that start compensation, run round a contour, and end it.
pub struct Program<N> {
    before: Vec<Block<N>>,
    lap: Vec<Block<N>>,
    after: Vec<Block<N>>,
}

impl<N> Program<N> {
    /// The number of blocks of the program that runs round once.
    pub fn len(&self) -> usize {
        self.before.len() + self.lap.len() + self.after.len()
    }

    /// The blocks of the program that runs round once.
    pub fn once(&self) -> impl Iterator<Item = &Block<N>> {
        self.before.iter().chain(&self.lap).chain(&self.after)
    }

    /// Blocks of the program that runs round until it has `blocks` blocks, and stays in compensation.
    pub fn laps(&self, blocks: usize) -> impl Iterator<Item = &Block<N>> {
        self.before.iter().chain(self.lap.iter().cycle()).take(blocks)
    }
}

/// The vector from the start of an arc to its centre, to the nearest micrometre.
fn centre_from_start(from: &Vertex, to: &Vertex) -> Point<i64> {
    let ([x, y], [to_x, to_y]) = (from.point.map(millimetres), to.point.map(millimetres));
    let (dx, dy) = (to_x - x, to_y - y);
    let along_normal = (1.0 - from.bulge * from.bulge) / (4.0 * from.bulge);
    [micrometres(dx / 2.0 - dy * along_normal), micrometres(dy / 2.0 + dx * along_normal)]
}

fn micrometres(millimetres: f64) -> i64 {
    (millimetres * 1000.0).round() as i64
}

fn millimetres(micrometres: i64) -> f64 {
    micrometres as f64 / 1000.0
}
