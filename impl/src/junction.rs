//! The junction of two compensated elements: which rule forms it, and what it hands over.

use core::cmp::Ordering;

use radcomp_spec::parameters::{Reversal, SideChange};
use radcomp_spec::{AlarmKind, Clause, Direction, clause};

use crate::corner;
use crate::element::Element;
use crate::inner;
use crate::plane::{Vector, cross, dot, greater, is_finite, magnitude};
use crate::rules::Rules;
use crate::side_change;
use crate::sign::sign;

/// The junction at the start of an element. It is formed in place: a copy costs as much as its geometry.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Junction {
    /// Its first vector: the end of the own move of the element before.
    pub first: Vector,
    /// The clause that formed it.
    pub clause: Clause,
    /// An arc before it ends on its own normal. [TRC-ARC-07]
    pub ends_on_normal: bool,
    /// An arc behind it starts on its own normal.
    pub starts_on_normal: bool,
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
            ends_on_normal: true,
            starts_on_normal: true,
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
        (self.ends_on_normal, self.starts_on_normal) = (true, true);
        (self.count, self.round) = (0, None);
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

    /// Puts a vector before the first one.
    pub fn put_first(&mut self, vector: Vector) {
        let [a, b, _] = self.points;
        self.points = [self.first, a, b];
        self.count += 1;
        self.first = vector;
    }

    /// Drops so many moves, the last ones. [TRC-INT-03]
    pub fn drop_last(&mut self, moves: u8) {
        self.count = self.count.saturating_sub(moves);
        // A corner by an arc has one move, and loses it.
        self.round = None;
    }

    /// Drops so many vectors, the first ones; at least one is to be left. [TRC-INT-03]
    pub fn drop_first(&mut self, vectors: u8) {
        for _ in 0..vectors.min(self.count) {
            let [a, b, c] = self.points;
            (self.first, self.points) = (a, [b, c, c]);
            self.count -= 1;
        }
        // A corner by an arc has one move, and loses it.
        self.round = None;
    }

    /// An arc neither ends nor starts on its own normal: both meet in one point off their normals.
    #[inline(always)]
    pub fn leave_normals(&mut self) {
        (self.ends_on_normal, self.starts_on_normal) = (false, false);
    }

    /// Drops each vector behind the first that differs from the last one kept by at most `limit` in each coordinate,
    /// but the last if `keep_last`; `scale` bounds the coordinates. [TRC-CORNER-18]
    pub fn drop_small(&mut self, limit: f64, keep_last: bool, scale: f64) {
        let (points, count) = (self.points, usize::from(self.count));
        let mut kept = self.first;
        self.count = 0;
        for (place, point) in points.into_iter().take(count).enumerate() {
            let small = sign(magnitude(point - kept) - limit, scale) != Ordering::Greater;
            if !small || keep_last && place + 1 == count {
                self.push(point);
                kept = point;
            }
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

    /// The path goes straight back.
    pub fn is_reversal(&self) -> bool {
        self.is_straight() && self.dot < 0.0
    }

    /// The sign of `d + cosine`, for the cosine of an angle on the workpiece side. [TRC-CORNER-13], [TRC-CORNER-15]
    pub fn against(&self, cosine: f64) -> Ordering {
        sign(self.dot + cosine, self.error)
    }

    /// `1 + d` and `1 - d`, by products where the difference would lose digits.
    pub fn one_and_cosine(&self) -> (f64, f64) {
        let square = self.cross * self.cross;
        if self.dot >= 0.0 {
            (1.0 + self.dot, square / (1.0 + self.dot))
        } else {
            (square / (1.0 - self.dot), 1.0 - self.dot)
        }
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
        _ if rules.straight > 0.0 && turn.against(-rules.straight) != Ordering::Less => {
            // [TRC-CORNER-16]
            junction.set(clause::TRC_CORNER_16, first.end_vector(radius));
            // Without a radius every normal ends at P.
            junction.starts_on_normal = radius == 0.0;
            Ok(())
        }
        Ordering::Equal if rules.reversal == Reversal::Alarm => Err(AlarmKind::Reversal),
        Ordering::Greater => inner::corner(first, second, radius, turn, junction),
        Ordering::Equal | Ordering::Less => {
            corner::outer(first, second, radius, turn, rules, junction)?;
            if rules.small > 0.0 && junction.round.is_none() && junction.clause != clause::TRC_CORNER_17 {
                let scale = greater(first.scale, second.scale) + radius;
                junction.drop_small(rules.small, second.arc.is_some(), scale);
            }
            Ok(())
        }
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
    match rules.side_change {
        SideChange::IntersectionWithin | SideChange::Intersection => {
            let within = rules.side_change == SideChange::IntersectionWithin;
            if side_change::contact(first, second, radius, within, junction) {
                return in_range(junction.first);
            }
        }
        SideChange::Crossing => {
            // [TRC-SIDE-06]
            junction.set(clause::TRC_SIDE_06, first.end_vector(radius));
            if second.arc.is_some() {
                junction.push(second.start_vector(radius));
            }
            return Ok(());
        }
        SideChange::TwoNormals | SideChange::Forbidden => {}
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
