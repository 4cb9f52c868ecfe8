//! Elements of a row: their vectors are compared before they are handed on. [TRC-INT-01] to [TRC-INT-05]

use radcomp_spec::parameters::{CornerOwner, EqualRadius};
use radcomp_spec::{Alarm, AlarmKind, clause};

use super::{Scene, State, end_of, owns_moves_behind, places};
use crate::element::Element;
use crate::engine::Sink;
use crate::geometry::{End, Meeting};
use crate::held::Held;
use crate::interference::{Compared, HeldBack, Next, OwnMove, Point, Removed, Row};
use crate::junction::Junction;
use crate::path::PathEnd;
use crate::plane::Vector;

/// The pending element as it ends.
struct Ending<'a> {
    element: &'a Element,
    own: OwnMove,
    /// The junctions before and behind it.
    start: &'a mut Junction,
    behind: &'a mut Junction,
    /// A corner of offset mode has been formed behind it.
    corner: bool,
    /// The moves of the junction behind it are its own.
    owns_behind: bool,
}

impl<S: Sink> Scene<'_, S> {
    /// Settles the pending element, which belongs to a row.
    ///
    /// # Errors
    /// An alarm at its block, or at one that has been held back.
    #[inline(never)]
    pub(super) fn settle_in_row(&mut self, end: End<Meeting>) -> Result<(), Alarm> {
        let State { elements, junctions: [one, other], pending, rules, tool, row, .. } = &mut *self.state;
        let (pending, next) = places(*pending);
        let (start, behind) = if pending == 0 { (one, other) } else { (other, one) };
        let (element, read) = (&elements[pending], &elements[next]);
        let (to, clause, on_normal) = end_of(element, behind, self.given, end);
        let degenerate = rules.equal_radius == EqualRadius::DegeneratePoint && element.is_point(element.radius);
        let arc = element.arc.as_ref().filter(|_| !degenerate);
        let full = arc.is_some_and(|arc| arc.full) && start.starts_on_normal && on_normal;
        let own = OwnMove { to, clause, full, straight: arc.is_none() };
        let corner = end == End::Junction(Meeting::Corner);
        let joins = corner && self.runs && read.radius == element.radius;
        let owns_behind = owns_moves_behind(rules.owner, behind, end);
        let ending = Ending { element, own, start, behind, corner, owns_behind };
        if row.removes() {
            let joined = row.joined && rules.owner == CornerOwner::Next;
            let removed = ending.removed(row, joined, *tool);
            row.joined = joins;
            let removed = removed.ok_or(Alarm { block: element.block, kind: AlarmKind::Interference })?;
            ending.make(removed, tool, self.sink);
            return Ok(());
        }
        let Ending { own, start, behind, .. } = ending;
        let held = Held::none();
        let block = HeldBack { element: *element, own, behind: *behind, corner, owns_behind, held };
        row.take(block, start, *tool);
        row.joined = joins;
        *tool = own.to;
        if owns_behind {
            *tool = behind.last().unwrap_or(own.to);
            behind.drop_moves();
        }
        let next = joins.then_some(Next { element: read, junction: behind });
        row.advance(!joins, next, self.sink)?;
        *tool = row.handed_on().unwrap_or(*tool);
        Ok(())
    }

    /// Ends the row before the pending element, which is lost.
    ///
    /// # Errors
    /// An alarm at a block that has been held back.
    pub(super) fn end_row(&mut self) -> Result<(), Alarm> {
        let State { elements, junctions, pending, tool, row, .. } = &mut *self.state;
        if row.holds_back() {
            let (pending, _) = places(*pending);
            let next = Next { element: &elements[pending], junction: &mut junctions[pending] };
            row.advance(true, Some(next), self.sink)?;
            *tool = row.handed_on().unwrap_or(*tool);
        }
        Ok(())
    }
}

impl Ending<'_> {
    /// How many vectors are removed at its ends; `joined` when all of those at its start are left. [TRC-INT-03]
    fn removed(&self, row: &Row, joined: bool, tool: Vector) -> Option<Removed> {
        let from = self.start.last().unwrap_or(tool);
        let before = Point { junction: *self.start, one: (!joined).then_some(from) };
        let behind = Point { junction: *self.behind, one: (!self.corner).then_some(self.own.to) };
        let degenerate = self.own.straight && self.element.arc.is_some();
        row.removed(&before, &behind, &Compared::element(self.element, self.own.full || degenerate))
    }

    /// Makes its moves without the vectors that are removed. [TRC-INT-03]
    fn make<S: Sink>(self, removed: Removed, tool: &mut Vector, sink: &mut S) {
        let Ending { element, mut own, start, behind, owns_behind, .. } = self;
        if removed != Removed::default() {
            start.drop_last(removed.before);
            behind.drop_first(removed.behind);
            let to = if removed.behind > 0 { behind.first } else { own.to };
            own = OwnMove { to, clause: clause::TRC_INT_03, full: false, straight: true };
        }
        let mut path = PathEnd { tool, sink, block: element.block, rapid: element.rapid };
        path.corner_moves(start);
        path.own_move(element.arc.as_ref().filter(|_| !own.straight), own.to, own.full, own.clause);
        if owns_behind {
            path.corner_moves(behind);
            behind.drop_moves();
        }
    }
}
