//! The end of the path: where it goes on, and where its steps go.

use radcomp_spec::{Clause, Direction, Segment, Step};

use crate::arc_form::Arc;
use crate::engine::Sink;
use crate::junction::Junction;
use crate::plane::Vector;

/// The end of the path, as far as one block moves it.
pub(crate) struct PathEnd<'a, S> {
    /// Where the tool's centre stands.
    pub tool: &'a mut Vector,
    pub sink: &'a mut S,
    /// The block that owns the steps.
    pub block: usize,
    /// It moves at rapid rate.
    pub rapid: bool,
}

impl<S: Sink> PathEnd<'_, S> {
    /// Emits corner moves of the block. Moves of no length are not made. [TRC-CORNER-12]
    #[inline(always)]
    pub fn corner_moves(&mut self, junction: &Junction) {
        for point in junction.points() {
            if point == *self.tool {
                continue;
            }
            let end = [point.x, point.y];
            match junction.round {
                None => self.emit(junction.clause, false, Segment::Line { end }),
                Some(direction) => {
                    let centre = junction.centre.into();
                    self.emit(junction.clause, false, Segment::Arc { end, centre, direction, full: false });
                }
            }
            *self.tool = point;
        }
    }

    /// Emits the block's own move.
    #[inline(always)]
    pub fn own_move(&mut self, arc: Option<&Arc>, to: Vector, full: bool, clause: Clause) {
        let end = to.into();
        match arc {
            None => self.emit(clause, true, Segment::Line { end }),
            Some(arc) => {
                let (centre, direction) = (arc.centre.into(), arc.direction());
                self.emit(clause, true, Segment::Arc { end, centre, direction, full });
            }
        }
        *self.tool = to;
    }

    /// Emits a corner arc as the block's own move. [TRC-VEC-02]
    pub fn corner_arc(&mut self, to: Vector, centre: Vector, direction: Direction, clause: Clause) {
        self.emit(clause, true, Segment::Arc { end: to.into(), centre: centre.into(), direction, full: false });
        *self.tool = to;
    }

    #[inline(always)]
    fn emit(&mut self, clause: Clause, main: bool, segment: Segment<f64>) {
        self.sink.step(Step { block: self.block, clause, rapid: self.rapid, main, segment });
    }
}
