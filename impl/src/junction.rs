//! The junction of two compensated elements: which rule forms it, and what it hands over.

use core::cmp::Ordering;

use radcomp_spec::parameters::{Reversal, SideChange};
use radcomp_spec::{AlarmKind, Clause, Direction, OuterCorner, clause};

use crate::corner;
use crate::element::Element;
use crate::inner;
use crate::plane::{Vector, cross, dot};
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
    pub fn none() -> Moves {
        let zero = Vector::new(0.0, 0.0);
        Moves { clause: clause::TRC_CORNER_12, count: 0, round: None, points: [zero; 3], centre: zero }
    }

    /// Makes these one straight move.
    #[inline(always)]
    pub fn set(&mut self, clause: Clause, point: Vector) {
        self.start(clause);
        self.push(point);
    }

    /// Makes these no moves, to which straight ones are added.
    #[inline(always)]
    pub fn start(&mut self, clause: Clause) {
        (self.clause, self.count, self.round) = (clause, 0, None);
    }

    /// Adds a straight move; a corner has at most three. [TRC-CORNER-07]
    #[inline(always)]
    pub fn push(&mut self, point: Vector) {
        if let Some(slot) = self.points.get_mut(usize::from(self.count)) {
            *slot = point;
            self.count += 1;
        }
    }

    /// The ends of the moves, in order.
    #[inline(always)]
    pub fn points(&self) -> &[Vector] {
        self.points.get(..usize::from(self.count)).unwrap_or(&[])
    }

    /// The last vector of the junction.
    #[inline]
    pub fn last(&self) -> Option<Vector> {
        self.points().last().copied()
    }
}

/// A formed junction, but for the moves from its first vector to its last: they are put in the second element's
/// [`Element::lead`], where they stay until that element is emitted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Junction {
    /// Its first vector: the end of the first element's own move.
    pub first: Vector,
    /// The clause that formed it.
    pub clause: Clause,
    /// An arc on either side ends or starts on its own normal. [TRC-ARC-07]
    pub on_normals: bool,
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
    /// The sum of the tangents' errors, in units of rounding.
    pub error: f64,
}

impl Turn {
    /// The turn between two elements.
    #[inline(always)]
    pub fn between(first: &Element, second: &Element) -> Turn {
        let error = first.last_error + second.first_error;
        Turn { cross: cross(first.last, second.first), dot: dot(first.last, second.first), error }
    }

    /// The sign of `c`, seen from the tool: greater at an inner corner. [TRC-CORNER-01]
    #[inline(always)]
    pub fn toward_tool(&self, side: f64) -> Ordering {
        sign(side * self.cross, self.error)
    }

    /// The path goes straight on or straight back.
    pub fn is_straight(&self) -> bool {
        sign(self.cross, self.error) == Ordering::Equal
    }

    /// tan(|φ|/2) of a turn that is no reversal, by the quotient that does not cancel.
    #[inline(always)]
    pub fn half_tangent(&self) -> f64 {
        let c = self.cross.abs();
        if self.dot >= 0.0 { c / (1.0 + self.dot) } else { (1.0 - self.dot) / c }
    }
}

/// Forms the corner of two elements on one side; the second has no lead yet.
///
/// # Errors
/// [TRC-CORNER-05], [TRC-CORNER-09], at the second block.
#[inline(always)]
pub(crate) fn corner(first: &Element, second: &mut Element, radius: f64, rules: Rules) -> Result<Junction, AlarmKind> {
    let turn = Turn::between(first, second);
    match turn.toward_tool(first.side) {
        Ordering::Equal if turn.dot > 0.0 => {
            // [TRC-CORNER-02]
            Ok(Junction { first: first.end_vector(radius), clause: clause::TRC_CORNER_02, on_normals: true })
        }
        Ordering::Equal if rules.reversal == Reversal::Alarm => Err(AlarmKind::Reversal),
        Ordering::Greater => inner::corner(first, second, radius, turn),
        Ordering::Equal | Ordering::Less => corner::outer(first, second, radius, turn, rules.outer),
    }
}

/// Forms the junction of two elements on different sides, the second without a lead yet; `forbidden` is not asked here.
pub(crate) fn change_of_side(first: &Element, second: &mut Element, radius: f64, rules: Rules) -> Junction {
    if rules.side_change == SideChange::IntersectionWithin
        && let Some(junction) = side_change::contact(first, second, radius)
    {
        return junction;
    }
    // [TRC-SIDE-03]
    second.lead.set(clause::TRC_SIDE_03, second.start_vector(radius));
    Junction { first: first.end_vector(radius), clause: clause::TRC_SIDE_03, on_normals: true }
}
