//! Contours that lie exactly on a decision, in any unit of length.

use radcomp_spec::{Direction, Side};
use rug::Rational;

use super::arm::sign;
use super::choice::Choice;
use super::point::{Point, root};

/// A contour at whose tool radius one decision has margin zero, and which of its numbers moves it off.
#[derive(Clone, Debug)]
pub(super) struct Figure {
    pub(super) family: &'static str,
    /// One more than there are moves.
    pub(super) vertices: Vec<Point>,
    pub(super) moves: Vec<Move>,
    /// Tool radius; not read in cancel mode.
    pub(super) tool: Rational,
    pub(super) nudge: Nudge,
    /// Whether the margin changes its sign with the nudge.
    pub(super) two_sided: bool,
    /// Whether the margin's sign turns around when the contour is mirrored, and when it is reversed.
    pub(super) odd: [bool; 2],
    /// Lengths are thousandths of a millimetre already: the decision compares with a length of the profile.
    pub(super) to_scale: bool,
    /// What its neighbours' number differs by, in thousandths of a millimetre.
    pub(super) increment: Rational,
    /// The path may be run from its end to its start.
    pub(super) reversible: bool,
    /// Where the tool stands before the first vertex, and where it goes after the last, when that matters.
    pub(super) approach: Option<Point>,
    pub(super) away: Option<Point>,
    /// A point of the imaginary line beside the code that cancels, seen from the last vertex ([TRC-CANCEL-08]).
    pub(super) imaginary: Option<Point>,
    /// How the start-up block leads to the first vertex.
    pub(super) entry: Shape,
    side: Option<Side>,
}

/// One move of a contour.
#[derive(Clone, Debug)]
pub(super) struct Move {
    pub(super) shape: Shape,
    /// None in cancel mode.
    pub(super) side: Option<Side>,
    pub(super) pause: Pause,
}

#[derive(Clone, Debug)]
pub(super) enum Shape {
    Line,
    Arc { centre: Point, sense: Direction },
    Radius { radius: Rational, sense: Direction },
}

/// What stands between a move and the one before.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Pause {
    None,
    /// One block without movement more than look-ahead allows.
    Lost,
    Dummy(Point),
}

/// The number that is one least increment lower and higher in the neighbours.
#[derive(Clone, Debug)]
pub(super) struct Nudge {
    pub(super) what: What,
    /// The direction in which the margin grows; the first coordinate's sign for a radius.
    pub(super) toward: Point,
}

/// A number by its owner, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A vertex of the contour.
    Vertex(usize),
    /// The centre of a move's arc.
    Centre(usize),
    /// The R word of a move's arc.
    Word(usize),
    /// The tool radius.
    Tool,
}

impl Figure {
    /// A contour that begins at a point, on the left side; the tool radius is nudged, a greater one has a smaller
    /// margin.
    pub(super) fn new(family: &'static str, start: Point) -> Self {
        Figure {
            family,
            vertices: vec![start],
            moves: Vec::new(),
            tool: Rational::from(1),
            nudge: Nudge { what: What::Tool, toward: Point::new(-1, 0) },
            two_sided: true,
            odd: [false; 2],
            to_scale: false,
            increment: Rational::from(1),
            reversible: true,
            approach: None,
            away: None,
            imaginary: None,
            entry: Shape::Line,
            side: Some(Side::Left),
        }
    }

    fn push(mut self, end: Point, shape: Shape) -> Self {
        self.vertices.push(end);
        self.moves.push(Move { shape, side: self.side, pause: Pause::None });
        self
    }

    pub(super) fn line(self, end: Point) -> Self {
        self.push(end, Shape::Line)
    }

    pub(super) fn arc(self, end: Point, centre: Point, sense: Direction) -> Self {
        self.push(end, Shape::Arc { centre, sense })
    }

    pub(super) fn radius_arc(self, end: Point, radius: Rational, sense: Direction) -> Self {
        self.push(end, Shape::Radius { radius, sense })
    }

    /// The side of the moves that follow; none for cancel mode.
    pub(super) fn on(mut self, side: Option<Side>) -> Self {
        self.side = side;
        self
    }

    pub(super) fn tool(mut self, radius: Rational) -> Self {
        self.tool = radius;
        self
    }

    pub(super) fn nudge(mut self, what: What, toward: Point) -> Self {
        self.nudge = Nudge { what, toward };
        self
    }

    pub(super) fn one_sided(mut self) -> Self {
        self.two_sided = false;
        self
    }

    /// Puts a pause before the last move, which then has its place in the order of moves.
    pub(super) fn after(mut self, pause: Pause) -> Self {
        if let Some(last) = self.moves.last_mut() {
            last.pause = pause;
        }
        self.reversible = false;
        self
    }

    /// The same contour from its end to its start, the tool on the same side of it in space.
    pub(super) fn reversed(mut self) -> Self {
        let (vertices, moves) = (self.vertices.len(), self.moves.len());
        self.vertices.reverse();
        self.moves.reverse();
        for each in &mut self.moves {
            each.side = each.side.map(Side::other);
            if let Shape::Arc { sense, .. } | Shape::Radius { sense, .. } = &mut each.shape {
                *sense = sense.reversed();
            }
        }
        self.nudge.what = match self.nudge.what {
            What::Vertex(index) => What::Vertex(vertices - 1 - index),
            What::Centre(index) => What::Centre(moves - 1 - index),
            What::Word(index) => What::Word(moves - 1 - index),
            What::Tool => What::Tool,
        };
        if self.odd[1] {
            self.nudge.toward = self.nudge.toward.opposite();
        }
        std::mem::swap(&mut self.approach, &mut self.away);
        self
    }

    /// Writes some of its arcs with R, where the nudge does not move them: those of a rational radius, but for half turns and
    /// whole ones.
    pub(super) fn give_radii(&mut self, choice: &mut Choice) {
        let nudged = |index| match self.nudge.what {
            What::Vertex(vertex) => vertex == index || vertex == index + 1,
            What::Centre(centre) => centre == index,
            What::Word(_) | What::Tool => false,
        };
        for (index, (each, ends)) in self.moves.iter_mut().zip(self.vertices.windows(2)).enumerate() {
            let Shape::Arc { centre, sense } = &each.shape else { continue };
            let (from, to) = (ends[0].minus(centre), ends[1].minus(centre));
            let turn = from.cross(&to) * sign(*sense);
            let Some(radius) = root(&from.length_squared()) else { continue };
            if turn.is_zero() || nudged(index) || choice.coin() {
                continue;
            }
            let radius = if turn > 0 { radius } else { -radius };
            each.shape = Shape::Radius { radius, sense: *sense };
        }
    }

    /// Whether the nudge moves a point of an arc or its radius.
    pub(super) fn nudges_arc(&self) -> bool {
        let is_arc = |index: usize| self.moves.get(index).is_some_and(|each| !matches!(each.shape, Shape::Line));
        match self.nudge.what {
            What::Vertex(index) => is_arc(index) || index > 0 && is_arc(index - 1),
            What::Centre(_) | What::Word(_) => true,
            What::Tool => false,
        }
    }

    /// Every point and length of the contour changed alike: `point` for points, `vector` for directions.
    pub(super) fn map(&mut self, point: impl Fn(&Point) -> Point, vector: impl Fn(&Point) -> Point, scale: &Rational) {
        let ends = self.approach.iter_mut().chain(&mut self.away).chain(&mut self.imaginary);
        for vertex in self.vertices.iter_mut().chain(ends) {
            *vertex = point(vertex);
        }
        for shape in self.moves.iter_mut().map(|each| &mut each.shape).chain([&mut self.entry]) {
            match shape {
                Shape::Line => {}
                Shape::Arc { centre, .. } => *centre = point(centre),
                Shape::Radius { radius, .. } => *radius *= scale,
            }
        }
        for each in &mut self.moves {
            if let Pause::Dummy(along) = &mut each.pause {
                *along = vector(along);
            }
        }
        self.tool *= scale;
        if matches!(self.nudge.what, What::Vertex(_) | What::Centre(_)) {
            self.nudge.toward = vector(&self.nudge.toward);
        }
    }

    /// The sides and senses changed over, as in a mirror.
    pub(super) fn mirror_codes(&mut self) {
        for each in &mut self.moves {
            each.side = each.side.map(Side::other);
        }
        for shape in self.moves.iter_mut().map(|each| &mut each.shape).chain([&mut self.entry]) {
            if let Shape::Arc { sense, .. } | Shape::Radius { sense, .. } = shape {
                *sense = sense.reversed();
            }
        }
        if self.odd[0] {
            self.nudge.toward = self.nudge.toward.opposite();
        }
    }

    /// Every number that a program writes, apart from the place of the whole contour.
    pub(super) fn numbers(&self) -> impl Iterator<Item = &Rational> {
        let entry = match &self.entry {
            Shape::Arc { centre, .. } => Some(centre),
            Shape::Line | Shape::Radius { .. } => None,
        };
        let points = self.vertices.iter().chain(&self.approach).chain(&self.away).chain(&self.imaginary).chain(entry);
        let of_moves = self.moves.iter().flat_map(|each| {
            let (point, word) = match &each.shape {
                Shape::Line => (None, None),
                Shape::Arc { centre, .. } => (Some(centre), None),
                Shape::Radius { radius, .. } => (None, Some(radius)),
            };
            let along = match &each.pause {
                Pause::Dummy(along) => Some(along),
                Pause::None | Pause::Lost => None,
            };
            point.into_iter().chain(along).flat_map(|point| [&point.a, &point.b]).chain(word)
        });
        points.flat_map(|point| [&point.a, &point.b]).chain(of_moves).chain([&self.tool])
    }
}
