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

/// The junction at the start of an element. It is formed in place: a copy costs as much as its geometry.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Junction {
    /// Its first vector: the end of the own move of the element before.
    pub first: Vector,
    /// The clause that formed it.
    pub clause: Clause,
    /// An arc on either side ends or starts on its own normal. [TRC-ARC-07]
    pub on_normals: bool,
    /// How many of `points` count.
    count: u8,
    /// The one move is an arc of this sense about `centre`. [TRC-CORNER-10]
    pub round: Option<Direction>,
    /// The ends of the moves from the first vector to the last one. [TRC-CORNER-12]
    points: [Vector; 3],
    /// The centre of an arc.
    pub centre: Vector,
}

impl Junction {
    /// A junction that no elements have formed yet.
    pub fn unused() -> Junction {
        let zero = Vector::new(0.0, 0.0);
        Junction {
            first: zero,
            clause: clause::TRC_CORNER_12,
            on_normals: true,
            count: 0,
            round: None,
            points: [zero; 3],
            centre: zero,
        }
    }

    /// Makes this a junction of one vector, on the normals; straight moves may be added.
    #[inline(always)]
    pub fn set(&mut self, clause: Clause, first: Vector) {
        (self.first, self.clause) = (first, clause);
        self.clear();
    }

    /// Makes this a junction without moves, on the normals.
    #[inline(always)]
    pub fn clear(&mut self) {
        (self.on_normals, self.count, self.round) = (true, 0, None);
    }

    /// The moves have been made.
    #[inline(always)]
    pub fn drop_moves(&mut self) {
        self.count = 0;
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
    pub fn points(&self) -> impl Iterator<Item = Vector> {
        self.points.iter().take(usize::from(self.count)).copied()
    }

    /// The end of the last move.
    #[inline]
    pub fn last(&self) -> Option<Vector> {
        self.points().last()
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
        let (sine, cosine) = if self.dot >= 0.0 { (c, 1.0 + self.dot) } else { (1.0 - self.dot, c) };
        sine / cosine
    }
}

/// Forms the corner of two elements on one side.
///
/// # Errors
/// [TRC-CORNER-05], [TRC-CORNER-09], at the second block; [TRC-MODE-07] where rounding leaves a corner out of range.
#[inline(always)]
pub(crate) fn corner(
    first: &Element,
    second: &Element,
    radius: f64,
    rules: &Rules,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    let turn = Turn::between(first, second);
    match turn.toward_tool(first.side) {
        Ordering::Equal if turn.dot > 0.0 => {
            // [TRC-CORNER-02]
            junction.set(clause::TRC_CORNER_02, first.end_vector(radius));
            Ok(())
        }
        Ordering::Equal if rules.reversal == Reversal::Alarm => Err(AlarmKind::Reversal),
        Ordering::Greater => inner::corner(first, second, radius, turn, junction),
        Ordering::Equal | Ordering::Less => corner::outer(first, second, radius, turn, rules.outer, junction),
    }
}

/// Forms the junction of two elements on different sides; `forbidden` is not asked here.
///
/// # Errors
/// [TRC-MODE-07] where rounding leaves a contact point out of range.
pub(crate) fn change_of_side(
    first: &Element,
    second: &Element,
    radius: f64,
    rules: &Rules,
    junction: &mut Junction,
) -> Result<(), AlarmKind> {
    if rules.side_change == SideChange::IntersectionWithin && side_change::contact(first, second, radius, junction) {
        return in_range(junction.first);
    }
    // [TRC-SIDE-03]
    junction.set(clause::TRC_SIDE_03, first.end_vector(radius));
    junction.push(second.start_vector(radius));
    Ok(())
}

/// Every vector but intersections is a sum of few numbers within range, and finite already. [TRC-MODE-07]
#[inline(always)]
pub(crate) fn in_range(vector: Vector) -> Result<(), AlarmKind> {
    if is_finite(vector) { Ok(()) } else { Err(AlarmKind::OutOfRange) }
}
