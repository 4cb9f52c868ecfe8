//! A block that is held back, and the vectors at a programmed point.

use core::iter::once;

use radcomp_spec::{Clause, Segment, Step, clause};

use crate::element::Element;
use crate::engine::Sink;
use crate::held::Held;
use crate::junction::Junction;
use crate::plane::Vector;

/// A block of a row, with what follows it up to the next one.
#[derive(Clone, Debug)]
pub(crate) struct HeldBack {
    pub element: Element,
    pub own: OwnMove,
    /// The junction at its end, if it is one, with its corner moves.
    pub behind: Junction,
    /// It is a corner of offset mode; else the own move's end is the only vector there.
    pub corner: bool,
    /// The corner moves there are its own.
    pub owns_behind: bool,
    /// The blocks without movement behind it, which the junction there does not lose. [TRC-LOOK-02]
    pub held: Held,
}

/// A block's own move.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnMove {
    pub to: Vector,
    pub clause: Clause,
    /// It is run as a full circle. [TRC-ARC-07]
    pub full: bool,
    /// It is a straight move: a line, or an arc whose offset curve is a point. [TRC-ARC-08]
    pub straight: bool,
}

/// The vectors at a programmed point. [TRC-INT-01]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// The junction there, with its corner moves.
    pub junction: Junction,
    /// The only vector, where no corner has been formed.
    pub one: Option<Vector>,
}

impl HeldBack {
    /// A place that no block has taken yet.
    pub fn unused() -> HeldBack {
        let zero = Vector::zeros();
        HeldBack {
            element: Element::unused(),
            own: OwnMove { to: zero, clause: clause::TRC_INT_01, full: false, straight: true },
            behind: Junction::unused(),
            corner: false,
            owns_behind: false,
            held: Held::none(),
        }
    }

    /// It is an arc whose offset curve is a point. [TRC-ARC-08]
    pub fn is_point(&self) -> bool {
        self.own.straight && self.element.arc.is_some()
    }

    /// The vectors at its end.
    pub fn end(&self) -> Point {
        Point { junction: self.behind, one: (!self.corner).then_some(self.own.to) }
    }

    /// Emits the blocks without movement behind it.
    pub fn emit_held<S: Sink>(&self, sink: &mut S) {
        let mut block = self.element.block;
        for rapid in self.held.rapid() {
            block = block.wrapping_add(1);
            sink.step(Step { block, clause: clause::TRC_LOOK_02, rapid, main: false, segment: Segment::Hold });
        }
    }
}

impl Point {
    /// A point of one vector, without corner moves.
    pub fn one(clause: Clause, vector: Vector) -> Point {
        let mut junction = Junction::unused();
        junction.set(clause, vector);
        Point { junction, one: Some(vector) }
    }

    /// The vectors in the order in which the tool's centre passes them: four at most.
    pub fn vectors(&self) -> impl Iterator<Item = Vector> {
        let corner = if self.one.is_none() { usize::MAX } else { 0 };
        once(self.one.unwrap_or(self.junction.first)).chain(self.junction.points().take(corner))
    }

    /// The last of them.
    pub fn last(&self) -> Vector {
        self.one.or(self.junction.last()).unwrap_or(self.junction.first)
    }
}
