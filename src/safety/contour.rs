//! The programmed contour: stretches of compensated elements that have one side.

use std::ops::RangeInclusive;

use radcomp_spec::Side;

use super::curve::Curve;
use super::interval::{Interval, Spot, cross, dot};
use super::piece::{Piece, Turn};

/// The compensated elements of a program; made by [`Contour::of`].
#[derive(Clone, Debug, Default)]
pub struct Contour {
    pub(crate) stretches: Vec<Stretch>,
}

/// Consecutive elements of one offset mode that have one side and one tool radius.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    pub(crate) side: Side,
    /// Tool radius in millimetres.
    pub(crate) radius: Interval,
    /// The block that starts up, if the mode begins with this stretch.
    pub(crate) start_up: Option<usize>,
    /// The blocks whose path elements run along this stretch.
    pub(crate) blocks: RangeInclusive<usize>,
    /// The blocks from the one with G40 to the one that cancels, if the mode ends with this stretch.
    pub(crate) cancel: Option<RangeInclusive<usize>>,
    /// A change of side comes before the first element.
    pub(crate) enters: bool,
    /// A change of side comes after the last element.
    pub(crate) leaves: bool,
    pub(crate) elements: Vec<Element>,
    /// The last element ends where the first one starts.
    pub(crate) closed: bool,
}

/// One programmed line or arc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element {
    /// Index of the block.
    pub(crate) block: usize,
    pub(crate) shape: ElementShape,
    /// In plain f64.
    pub(crate) curve: Curve,
    /// Directions of travel at the start and at the end, as long as the element or its radius.
    pub(crate) tangents: [Spot; 2],
    /// The corner after it, to the next element of its stretch.
    pub(crate) corner: Corner,
}

/// The exact shape of an element, to within rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) enum ElementShape {
    Line([Spot; 2]),
    Arc(Turn),
}

/// A corner of the contour, as the tool sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Corner {
    /// An end of the contour: nothing is known of the material beyond it.
    Open,
    /// The tangents are one: points nearest to the corner lie on its normal, which both elements judge.
    Smooth,
    /// The path turns away from the tool, or reverses: points nearest to the corner are on the tool's side.
    Outer,
    /// The path turns toward the tool: points nearest to the corner are in the material.
    Inner,
    /// Rounding does not tell.
    Unknown,
}

/// A piece of the contour with all that its neighbourhood needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wall {
    /// The piece.
    pub(crate) piece: Piece,
    /// Index of the block.
    pub(crate) block: usize,
    /// Where the tool belongs.
    pub(crate) front: Front,
    /// The corners at the ends `a` and `b` of the piece.
    pub(crate) joints: [Joint; 2],
}

/// The side of a wall on which the tool belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Front {
    /// Left of the direction from `a` to `b`.
    Left,
    /// Right of the direction from `a` to `b`.
    Right,
    /// Of an arc, on the side of its centre.
    Inside,
    /// Of an arc, on the side away from its centre.
    Outside,
}

/// A corner with the directions of travel before and after it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint {
    pub(crate) corner: Corner,
    pub(crate) tangents: [Spot; 2],
    pub(crate) side: Side,
}

impl Contour {
    /// The same contour without the elements of this block and those after it: what a path can follow that ends in an
    /// alarm at this block.
    #[must_use]
    pub fn before(mut self, block: usize) -> Self {
        for stretch in &mut self.stretches {
            let count = stretch.elements.len();
            stretch.elements.retain(|element| element.block < block);
            if stretch.elements.len() < count {
                stretch.closed = false;
                stretch.leaves = false;
                if let Some(last) = stretch.elements.last_mut() {
                    last.corner = Corner::Open;
                }
            }
        }
        self.stretches.retain(|stretch| !stretch.elements.is_empty());
        self
    }

    /// How many elements it has.
    pub fn len(&self) -> usize {
        self.stretches.iter().map(|stretch| stretch.elements.len()).sum()
    }

    /// Whether the program compensates nothing.
    pub fn is_empty(&self) -> bool {
        self.stretches.is_empty()
    }
}

impl Element {
    /// Start and end.
    pub(crate) fn ends(&self) -> [Spot; 2] {
        match self.shape {
            ElementShape::Line(ends) => ends,
            ElementShape::Arc(turn) => [turn.start, turn.end],
        }
    }

    /// The pieces in the order of travel.
    pub(crate) fn pieces(&self) -> Vec<Piece> {
        match &self.shape {
            ElementShape::Line([start, end]) => vec![Piece::line(*start, *end)],
            ElementShape::Arc(turn) => Piece::of_turn(turn),
        }
    }
}

impl Stretch {
    /// The walls in the order of travel.
    pub(crate) fn walls(&self) -> Vec<Wall> {
        let count = self.elements.len();
        let mut walls = Vec::with_capacity(count);
        for (index, element) in self.elements.iter().enumerate() {
            let before = match index {
                0 if self.closed => Some(&self.elements[count - 1]),
                0 => None,
                _ => Some(&self.elements[index - 1]),
            };
            let after = match index + 1 {
                next if next < count => Some(&self.elements[next]),
                _ if self.closed => Some(&self.elements[0]),
                _ => None,
            };
            let entry = Joint {
                corner: before.map_or(Corner::Open, |before| before.corner),
                tangents: [before.map_or(element.tangents[0], |before| before.tangents[1]), element.tangents[0]],
                side: self.side,
            };
            let exit = Joint {
                corner: if after.is_some() { element.corner } else { Corner::Open },
                tangents: [element.tangents[1], after.map_or(element.tangents[1], |after| after.tangents[0])],
                side: self.side,
            };
            let smooth = Joint { corner: Corner::Smooth, ..entry };
            let pieces = element.pieces();
            let last = pieces.len() - 1;
            let front = front(element, self.side);
            for (place, piece) in pieces.into_iter().enumerate() {
                let mut joints = [if place == 0 { entry } else { smooth }, if place == last { exit } else { smooth }];
                if matches!(&element.shape, ElementShape::Arc(turn) if !turn.ccw) {
                    joints.reverse();
                }
                walls.push(Wall { piece, block: element.block, front, joints });
            }
        }
        walls
    }
}

fn front(element: &Element, side: Side) -> Front {
    match (&element.shape, side) {
        (ElementShape::Line(_), Side::Left) => Front::Left,
        (ElementShape::Line(_), Side::Right) => Front::Right,
        (ElementShape::Arc(turn), side) if turn.ccw == (side == Side::Left) => Front::Inside,
        (ElementShape::Arc(_), _) => Front::Outside,
    }
}

/// The corner between two directions of travel that are known to within rounding.
pub(crate) fn corner_between(before: &Spot, after: &Spot, side: Side) -> Corner {
    let turn = cross(before, after);
    let toward_tool = if side == Side::Left { turn } else { -turn };
    if toward_tool.is_positive() {
        Corner::Inner
    } else if toward_tool.is_negative() {
        Corner::Outer
    } else if turn.low == 0.0 && turn.high == 0.0 {
        if dot(before, after).is_positive() { Corner::Smooth } else { Corner::Outer }
    } else {
        Corner::Unknown
    }
}
