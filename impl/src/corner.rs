//! Outer corners: by intersection, squared off, by an arc, and the exact reversal. [TRC-CORNER-06] to [TRC-CORNER-10]

use core::cmp::Ordering;

use radcomp_spec::{Direction, OuterCorner, clause};

use crate::element::Element;
use crate::junction::{Junction, Moves, Turn};
use crate::plane::Vector;
use crate::sign::sign;

/// Forms an outer corner.
#[inline]
pub(crate) fn outer(first: &Element, second: &Element, radius: f64, turn: Turn, rule: OuterCorner) -> Junction {
    match rule {
        OuterCorner::Arc => round(first, second, radius),
        OuterCorner::Intersection => by_intersection(first, second, radius, turn),
    }
}

/// [TRC-CORNER-10]
fn round(first: &Element, second: &Element, radius: f64) -> Junction {
    let mut moves = Moves::to(clause::TRC_CORNER_10, second.start_vector(radius));
    moves.round = Some(if first.side > 0.0 { Direction::Clockwise } else { Direction::Counterclockwise });
    moves.centre = first.end;
    Junction { first: first.end_vector(radius), moves, on_normals: true }
}

#[inline(always)]
fn by_intersection(first: &Element, second: &Element, radius: f64, turn: Turn) -> Junction {
    let acute = turn.dot < 0.0 && sign(turn.dot, turn.error) == Ordering::Less;
    let with_arc = first.arc.is_some() || second.arc.is_some();
    let clause = match (turn.turns, acute) {
        (Ordering::Equal, _) => clause::TRC_CORNER_09,
        (_, true) => clause::TRC_CORNER_08,
        (_, false) if with_arc => clause::TRC_CORNER_07,
        (_, false) => clause::TRC_CORNER_06,
    };
    let first_normal = first.end_vector(radius);
    // A of [TRC-CORNER-08], or M of [TRC-CORNER-06]; [TRC-CORNER-09] is [TRC-CORNER-08] with α = 0.
    let beyond = if acute { radius } else { radius * turn.half_tangent() };
    let before = first_normal + first.last * beyond;
    // B of [TRC-CORNER-08].
    let after = acute.then(|| second.start_vector(radius) - second.first * radius);
    if !with_arc {
        let moves = after.map_or(Moves::none(clause), |after| Moves::to(clause, after));
        return Junction { first: before, moves, on_normals: true };
    }
    // [TRC-CORNER-07]
    let mut path = Path { first: None, moves: Moves::none(clause) };
    if first.arc.is_some() {
        path.pass(first_normal);
    }
    path.pass(before);
    if let Some(after) = after {
        path.pass(after);
    }
    if second.arc.is_some() {
        path.pass(second.start_vector(radius));
    }
    Junction { first: path.first.unwrap_or(before), moves: path.moves, on_normals: true }
}

/// Collects the points that the tool passes: the first ends the first element, the others are moves.
struct Path {
    first: Option<Vector>,
    moves: Moves,
}

impl Path {
    #[inline(always)]
    fn pass(&mut self, point: Vector) {
        if self.first.is_none() {
            self.first = Some(point);
        } else {
            self.moves.push(point);
        }
    }
}
