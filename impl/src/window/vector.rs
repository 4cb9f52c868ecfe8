//! Vector blocks in offset mode, and moves that end on a vector of their own: the junction behind them is settled at once.
//! [TRC-VEC-01] to [TRC-VEC-06]

use radcomp_spec::parameters::SideCodeVector;
use radcomp_spec::{Alarm, Side, clause};

use super::{Start, Window};
use crate::geometry::{Begin, End, Event, Geometry, Kind, Toward};

impl Window {
    /// A vector block that is no move, on this side. [TRC-VEC-01]
    #[inline(never)]
    pub(super) fn vector_block<G: Geometry>(
        &mut self,
        block: usize,
        event: Event,
        side: Side,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        // Another one waits no longer. [TRC-VEC-03]
        self.release(geometry);
        let settled = self.pending.is_none();
        let (end, own) = match event.kind {
            Kind::CornerArc => (End::Normal(clause::TRC_VEC_02), clause::TRC_VEC_02),
            Kind::CornerToNext => (End::Normal(clause::TRC_VEC_03), clause::TRC_VEC_03),
            _ => (End::Vector(side, clause::TRC_VEC_05), clause::TRC_VEC_05),
        };
        if !settled {
            if let Some(kind) = self.side_fault(side) {
                return self.fault(block, kind, geometry);
            }
            self.settle(end, clause::TRC_LOOK_02, geometry)?;
            (self.side, self.first) = (side, false);
        }
        self.lost = false;
        match event.kind {
            Kind::CornerArc | Kind::CornerToNext if settled => geometry.hold(block, event.rapid, own),
            Kind::CornerArc => geometry.corner_arc(block, event.rapid, Toward::Vector, side),
            Kind::CornerToNext => {
                self.await_end(block, Start::CornerArc, event.rapid);
                return self.stop_behind(event, geometry);
            }
            _ => geometry.new_vector(side, settled),
        }
        Ok(())
    }

    /// Makes the corner arc that waits for the element read, and the blocks without movement behind it. [TRC-VEC-03]
    #[inline(never)]
    pub(super) fn end_corner_arc<G: Geometry>(&mut self, geometry: &mut G) {
        if let Some(corner) = self.pending.take() {
            geometry.corner_arc(corner.block, corner.rapid, Toward::Element, self.side);
            self.emit_held(corner.block, clause::TRC_LOOK_02, geometry);
        }
    }

    /// A move that holds the vector. [TRC-VEC-04]
    #[inline(never)]
    pub(super) fn hold_vector<G: Geometry>(
        &mut self,
        block: usize,
        event: Event,
        side: Side,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        self.move_to(End::Held, block, event, side, geometry)
    }

    /// A straight move beside the code of a side, with I, J, K. [TRC-VEC-06]
    #[inline(never)]
    pub(super) fn move_to_vector<G: Geometry>(
        &mut self,
        block: usize,
        event: Event,
        side: Side,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        self.move_to(End::Vector(side, clause::TRC_VEC_06), block, event, side, geometry)
    }

    /// A straight move of offset mode whose end does not wait for a next element.
    fn move_to<G: Geometry>(
        &mut self,
        end: End<G::Junction>,
        block: usize,
        event: Event,
        side: Side,
        geometry: &mut G,
    ) -> Result<(), Alarm> {
        let begin = if self.joins() { Begin::Junction } else { Begin::Settled };
        self.meet(block, side, geometry)?;
        self.await_end(block, Start::No, event.rapid);
        geometry.begin(begin, side);
        self.settle(end, clause::TRC_LOOK_02, geometry)
    }

    /// The block's I, J, K are a vector at right angles. [TRC-START-10], [TRC-VEC-06]
    #[inline(always)]
    pub(super) fn gives_vector(&self, event: Event) -> bool {
        event.vector && self.policy.side_vector == SideCodeVector::RightAngles
    }

    /// An element is pending that the element read meets at a junction.
    #[inline(always)]
    pub(super) fn joins(&self) -> bool {
        self.pending.is_some_and(|pending| pending.start != Start::CornerArc)
    }

    /// A corner arc waits for the next element. [TRC-VEC-03]
    #[inline(always)]
    pub(super) fn corner_waits(&self) -> bool {
        self.pending.is_some_and(|pending| pending.start == Start::CornerArc)
    }
}
