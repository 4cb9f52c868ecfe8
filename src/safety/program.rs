//! The contour that a program's blocks describe.

use std::cmp::Ordering;

use radcomp_model::Vector;
use radcomp_model::number::Real;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Side};
use rug::Rational;

use super::contour::{Contour, Corner, Element, ElementShape, Stretch};
use super::curve::Curve;
use super::interval::{Interval, Spot, middle};
use super::piece::Turn;

impl Contour {
    /// The compensated elements of a program: the blocks that move after a start-up block and before the cancel block.
    ///
    /// Reading ends at a block that no control runs: an arc that cancels, that does not exist, or whose centre is its start
    /// or its end, another radius in offset mode, and a code that is not for offset mode. It ends too where the program
    /// itself gives or holds a vector, which need not stand off from the contour. An arc that starts up, which
    /// some controls run about another centre, is a start-up block like others. A negative radius swaps the sides.
    ///
    /// # Exactness
    ///
    /// Every number is kept as an interval of f64 that contains it. Corners are told inner from outer exactly.
    pub fn of(blocks: &[Block<Rational>]) -> Contour {
        let mut reading = Reading {
            stretches: Vec::new(),
            open: None,
            at: [Rational::new(), Rational::new()],
            side: None,
            radius: Rational::new(),
            mode: Mode::Cancel,
        };
        for (index, block) in blocks.iter().enumerate() {
            if reading.block(index, block).is_none() {
                break;
            }
        }
        reading.close();
        Contour { stretches: reading.stretches }
    }
}

enum Mode {
    Cancel,
    Offset,
    /// G40 has come at this block, the move that cancels has not.
    Cancelling(usize),
}

struct Reading {
    stretches: Vec<Stretch>,
    open: Option<Open>,
    at: [Rational; 2],
    side: Option<Side>,
    radius: Rational,
    mode: Mode,
}

/// A stretch that may go on.
struct Open {
    stretch: Stretch,
    start: [Rational; 2],
    first: Option<Vector>,
    last: Option<Vector>,
}

/// An element with its exact tangents at start and end.
struct Exact {
    shape: ElementShape,
    curve: Curve,
    tangents: [Vector; 2],
}

impl Reading {
    /// Reads a block; none ends the contour.
    fn block(&mut self, index: usize, block: &Block<Rational>) -> Option<()> {
        if block.not_in_mode.is_some() || gives_vector(block) {
            return None;
        }
        let in_offset = matches!(self.mode, Mode::Offset);
        let off = block.compensation == Some(Compensation::Off);
        if let Some(radius) = &block.radius {
            if in_offset && !off && radius.clone().abs() != self.radius.clone().abs() {
                return None;
            }
            self.radius = radius.clone();
        }
        match block.compensation {
            Some(Compensation::Off) => self.side = None,
            Some(Compensation::On(side)) => self.side = Some(side),
            None => {}
        }
        if in_offset && off {
            self.mode = Mode::Cancelling(index);
        }
        let end = match &block.movement {
            Movement::Line { end } if *end != self.at => end,
            Movement::Arc { end, .. } => end,
            _ => return Some(()),
        };
        let exact = Exact::of(&self.at, &block.movement)?;
        let is_line = matches!(exact.shape, ElementShape::Line(_));
        let swapped = self.radius.is_negative();
        let side = self.side.map(|side| if swapped { side.other() } else { side });
        match (&self.mode, side) {
            (Mode::Offset, Some(side)) => self.element(index, side, exact),
            (Mode::Offset, None) | (Mode::Cancel, None) => {}
            (Mode::Cancelling(from), side) => {
                let from = *from;
                if !is_line {
                    return None;
                }
                if let Some(open) = &mut self.open {
                    open.stretch.cancel = Some(from..=index);
                    open.stretch.blocks = *open.stretch.blocks.start()..=from.saturating_sub(1);
                }
                self.close();
                self.mode = Mode::Cancel;
                if side.is_some() {
                    self.start_up(index, end);
                }
            }
            (Mode::Cancel, Some(_)) => self.start_up(index, end),
        }
        self.at = end.clone();
        Some(())
    }

    fn start_up(&mut self, index: usize, end: &[Rational; 2]) {
        self.mode = Mode::Offset;
        self.open = Some(Open::new(Side::Left, &self.radius, index + 1, end));
        if let Some(open) = &mut self.open {
            open.stretch.start_up = Some(index);
        }
    }

    fn element(&mut self, index: usize, side: Side, exact: Exact) {
        let Some(open) = &mut self.open else { return };
        if !open.stretch.elements.is_empty() && open.stretch.side != side {
            open.stretch.leaves = true;
            open.stretch.blocks = *open.stretch.blocks.start()..=index - 1;
            self.close();
            let mut next = Open::new(side, &self.radius, index, &self.at);
            next.stretch.enters = true;
            self.open = Some(next);
        }
        let Some(open) = &mut self.open else { return };
        open.stretch.side = side;
        if let (Some(last), Some(element)) = (&open.last, open.stretch.elements.last_mut()) {
            element.corner = corner(last, &exact.tangents[0], side);
        }
        let tangents = exact.tangents.each_ref().map(enclosed);
        let Exact { shape, curve, tangents: [first, last] } = exact;
        open.stretch.elements.push(Element { block: index, shape, curve, tangents, corner: Corner::Open });
        open.first.get_or_insert(first);
        open.last = Some(last);
    }

    /// Ends the open stretch at the current point.
    fn close(&mut self) {
        let Some(mut open) = self.open.take() else { return };
        if open.start == self.at
            && let (Some(first), Some(last), Some(element)) =
                (&open.first, &open.last, open.stretch.elements.last_mut())
        {
            element.corner = corner(last, first, open.stretch.side);
            open.stretch.closed = true;
        }
        if !open.stretch.elements.is_empty() {
            self.stretches.push(open.stretch);
        }
    }
}

/// Whether a block gives or holds a vector; one that cancels only says where the contour before it ends.
fn gives_vector(block: &Block<Rational>) -> bool {
    let by_code =
        matches!(block.movement, Movement::HeldVector { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. });
    by_code || (block.vector.is_some() && matches!(block.compensation, Some(Compensation::On(_))))
}

impl Open {
    fn new(side: Side, radius: &Rational, from: usize, start: &[Rational; 2]) -> Self {
        let stretch = Stretch {
            side,
            radius: interval(&Real::from(&radius.clone().abs())),
            start_up: None,
            blocks: from..=usize::MAX,
            cancel: None,
            enters: false,
            leaves: false,
            elements: Vec::new(),
            closed: false,
        };
        Open { stretch, start: start.clone(), first: None, last: None }
    }
}

impl Exact {
    /// The line or arc of a movement, or none if there is no such arc.
    fn of(at: &[Rational; 2], movement: &Movement<Rational>) -> Option<Exact> {
        let start = Vector::rational(at);
        let (end, centre, direction) = match movement {
            Movement::Line { end } => {
                let end = Vector::rational(end);
                let along = end.minus(&start);
                let ends = [enclosed(&start), enclosed(&end)];
                let curve = Curve::Line { start: middle(&ends[0]), end: middle(&ends[1]) };
                return Some(Exact { shape: ElementShape::Line(ends), curve, tangents: [along.clone(), along] });
            }
            Movement::Arc { end, centre, direction } => (Vector::rational(end), centre, *direction),
            _ => return None,
        };
        let ccw = direction == Direction::Counterclockwise;
        let centre = match centre {
            Centre::FromStart(vector) => start.plus(&Vector::rational(vector)),
            Centre::Radius(radius) => centre_of(&start, &end, &Real::from(radius), ccw)?,
        };
        let arms = [start.minus(&centre), end.minus(&centre)];
        if arms.iter().any(Vector::is_zero) {
            return None;
        }
        let tangents = arms.map(|arm| if ccw { arm.perp() } else { arm.perp().opposite() });
        let full = start == end;
        let turn = Turn { start: enclosed(&start), end: enclosed(&end), centre: enclosed(&centre), ccw, full };
        let curve = Curve::arc(middle(&turn.centre), middle(&turn.start), middle(&turn.end), ccw, full);
        Some(Exact { shape: ElementShape::Arc(turn), curve, tangents })
    }
}

/// The centre of an arc with a radius, of at most a half turn if that is positive.
fn centre_of(start: &Vector, end: &Vector, radius: &Real, ccw: bool) -> Option<Vector> {
    let chord = end.minus(start);
    let squared = chord.length_squared();
    let quarter = Real::rational(Rational::from((1, 4)));
    let height = (radius.square() - &squared * &quarter).checked_div(&squared)?.sqrt()?;
    let left = (radius.sign() != Ordering::Less) == ccw;
    let half = Real::rational(Rational::from((1, 2)));
    Some(start.along(&chord, &half).along(&chord.perp(), &if left { height } else { -height }))
}

fn corner(before: &Vector, after: &Vector, side: Side) -> Corner {
    let turn = before.cross(after).sign();
    match if side == Side::Left { turn } else { turn.reverse() } {
        Ordering::Greater => Corner::Inner,
        Ordering::Less => Corner::Outer,
        Ordering::Equal if before.dot(after).sign() == Ordering::Greater => Corner::Smooth,
        Ordering::Equal => Corner::Outer,
    }
}

fn enclosed(vector: &Vector) -> Spot {
    [interval(&vector.a), interval(&vector.b)]
}

/// The interval of an exact number.
fn interval(value: &Real) -> Interval {
    let (low, high) = value.filter();
    Interval::between(low, high)
}
