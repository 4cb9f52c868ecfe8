//! The junction of two compensated elements: which rule forms it, and what it hands over.

use core::cmp::Ordering;

use radcomp_spec::parameters::{Reversal, SideChange};
use radcomp_spec::{AlarmKind, Clause, Direction, OuterCorner, clause};

use crate::corner;
use crate::element::Element;
use crate::inner;
use crate::plane::{Vector, cross, dot, is_finite};
use crate::side_change;
use crate::sign::sign;

/// The moves of a corner, after its first vector. [TRC-CORNER-12]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moves {
    /// The clause that made them.
    pub clause: Clause,
    /// How many of `points` count.
    pub count: u8,
    /// The one move is an arc of this sense about `centre`. [TRC-CORNER-10]
    pub round: Option<Direction>,
    /// The end of each move.
    pub points: [Vector; 3],
    /// The centre of an arc.
    pub centre: Vector,
}

impl Moves {
    /// No moves.
    #[inline(always)]
    pub fn none(clause: Clause) -> Moves {
        let zero = Vector::new(0.0, 0.0);
        Moves { clause, count: 0, round: None, points: [zero; 3], centre: zero }
    }

    /// One straight move.
    #[inline]
    pub fn to(clause: Clause, point: Vector) -> Moves {
        let mut moves = Moves::none(clause);
        moves.push(point);
        moves
    }

    /// Adds a straight move; a corner has at most three. [TRC-CORNER-07]
    #[inline]
    pub fn push(&mut self, point: Vector) {
        if let Some(slot) = self.points.get_mut(usize::from(self.count)) {
            *slot = point;
            self.count += 1;
        }
    }

    /// The ends of the moves, in order.
    #[inline]
    pub fn points(&self) -> &[Vector] {
        self.points.get(..usize::from(self.count)).unwrap_or(&[])
    }

    /// The last vector of the junction.
    #[inline]
    pub fn last(&self) -> Option<Vector> {
        self.points().last().copied()
    }
}

/// A formed junction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Junction {
    /// Its first vector: the end of the first element's own move.
    pub first: Vector,
    /// The moves from there to its last vector, with the clause of the junction.
    pub moves: Moves,
    /// An arc on either side ends or starts on its own normal. [TRC-ARC-07]
    pub on_normals: bool,
}

impl Junction {
    /// A junction of one vector.
    #[inline(always)]
    pub fn at(clause: Clause, vector: Vector, on_normals: bool) -> Junction {
        Junction { first: vector, moves: Moves::none(clause), on_normals }
    }

    /// Every coordinate is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        is_finite(self.first) && self.moves.points().iter().all(|point| is_finite(*point))
    }
}

/// What a profile says of junctions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rules {
    /// [TRC-CORNER-09]
    pub reversal: Reversal,
    /// [TRC-SIDE-01]
    pub side_change: SideChange,
    /// [TRC-CORNER-11]
    pub outer: OuterCorner,
}

/// The turn of the path at P.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    /// `c` of [TRC-CORNER-01].
    pub cross: f64,
    /// `d`.
    pub dot: f64,
    /// The sign of `c`.
    pub turns: Ordering,
    /// The sum of the tangents' errors, in units of rounding.
    pub error: f64,
}

impl Turn {
    /// The turn between two elements.
    #[inline(always)]
    pub fn between(first: &Element, second: &Element) -> Turn {
        let error = first.last_error + second.first_error;
        let cross = cross(first.last, second.first);
        Turn { cross, dot: dot(first.last, second.first), turns: sign(cross, error), error }
    }

    /// tan(|φ|/2) of a turn that is no reversal, by the quotient that does not cancel.
    #[inline(always)]
    pub fn half_tangent(&self) -> f64 {
        let c = self.cross.abs();
        if self.dot >= 0.0 { c / (1.0 + self.dot) } else { (1.0 - self.dot) / c }
    }
}

/// Forms the corner of two elements on one side.
///
/// # Errors
/// [TRC-CORNER-05], [TRC-CORNER-09], at the second block.
#[inline(always)]
pub(crate) fn corner(first: &Element, second: &Element, radius: f64, rules: Rules) -> Result<Junction, AlarmKind> {
    let turn = Turn::between(first, second);
    let toward_tool = if first.side > 0.0 { turn.turns } else { turn.turns.reverse() };
    match toward_tool {
        Ordering::Equal if turn.dot > 0.0 => {
            // [TRC-CORNER-02]
            Ok(Junction::at(clause::TRC_CORNER_02, first.end_vector(radius), true))
        }
        Ordering::Equal if rules.reversal == Reversal::Alarm => Err(AlarmKind::Reversal),
        Ordering::Greater => inner::corner(first, second, radius, turn),
        Ordering::Equal | Ordering::Less => Ok(corner::outer(first, second, radius, turn, rules.outer)),
    }
}

/// Forms the junction of two elements on different sides; `forbidden` is not asked here.
pub(crate) fn change_of_side(first: &Element, second: &Element, radius: f64, rules: Rules) -> Junction {
    if rules.side_change == SideChange::IntersectionWithin
        && let Some(junction) = side_change::contact(first, second, radius)
    {
        return junction;
    }
    // [TRC-SIDE-03]
    let moves = Moves::to(clause::TRC_SIDE_03, second.start_vector(radius));
    Junction { first: first.end_vector(radius), moves, on_normals: true }
}
