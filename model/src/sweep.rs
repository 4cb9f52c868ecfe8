//! Exact comparison of the angles that arcs sweep, without angles.

use core::cmp::Ordering;

use radcomp_spec::Direction;

use crate::geometry::Vector;

/// A direction as seen from another one: its angle from there, in the sense of an arc, lies in [0°, 360°).
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    /// Cosine part and sine part, times the lengths of the two directions.
    pub(crate) relative: Vector,
}

impl Sweep {
    /// The sweep from direction `from` to direction `to`; neither is zero.
    pub(crate) fn between(from: &Vector, to: &Vector, sense: Direction) -> Self {
        let sine = from.cross(to);
        let sine = match sense {
            Direction::Counterclockwise => sine,
            Direction::Clockwise => -sine,
        };
        Sweep { relative: Vector::new(from.dot(to), sine) }
    }

    /// Whether the sweep is exactly nothing.
    pub(crate) fn is_none(&self) -> bool {
        self.relative.b.is_zero() && self.relative.a.sign() == Ordering::Greater
    }

    /// Whether the sweep is less than a half turn.
    pub(crate) fn below_half_turn(&self) -> bool {
        match self.relative.b.sign() {
            Ordering::Greater => true,
            Ordering::Less => false,
            Ordering::Equal => self.relative.a.sign() == Ordering::Greater,
        }
    }

    /// The sweep of the opposite direction: a half turn more or less.
    pub(crate) fn plus_half_turn(&self) -> Sweep {
        Sweep { relative: self.relative.opposite() }
    }

    /// Exact comparison.
    pub(crate) fn compare(&self, other: &Sweep) -> Ordering {
        match (self.below_half_turn(), other.below_half_turn()) {
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            _ => other.relative.cross(&self.relative).sign(),
        }
    }
}

/// Whether `tool` and `programmed` sweeps differ by more than a half turn ([TRC-WEDGE-03]); a programmed sweep of
/// nothing is a whole turn.
pub(crate) fn differ_by_more_than_half_turn(tool: &Sweep, programmed: &Sweep, whole_turn: bool) -> bool {
    if whole_turn || programmed.is_none() {
        return tool.below_half_turn();
    }
    let tool_longer = programmed.below_half_turn() && tool.compare(&programmed.plus_half_turn()) == Ordering::Greater;
    let tool_shorter = tool.below_half_turn() && programmed.compare(&tool.plus_half_turn()) == Ordering::Greater;
    tool_longer || tool_shorter
}
