//! The geometry behind the look-ahead: the pending element, the path's end, and the emission of steps.

mod row;
mod state;
mod vector;

use core::cmp::Ordering;

use radcomp_spec::parameters::{CornerOwner, EqualRadius, StartUp};
use radcomp_spec::{Alarm, AlarmKind, Clause, Segment, Side, Step, clause};

use crate::element::{Element, sigma};
use crate::engine::Sink;
use crate::entry;
use crate::geometry::{Begin, End, Geometry, Meeting, Part, Toward};
use crate::imaginary;
use crate::junction::{self, Junction};
use crate::path::PathEnd;
use crate::plane::{Vector, greater, magnitude};
use crate::sign::sign;
use crate::type_b;
use crate::wedge;
use state::Look;
pub(crate) use state::State;

/// The places of the pending element and of the element read.
#[inline(always)]
fn places(pending: usize) -> (usize, usize) {
    // The masks tell the compiler that the places exist.
    (pending & 1, !pending & 1)
}

/// Where an element that does not hold its vector ends, by which clause, and whether an arc ends on its own normal.
#[inline(always)]
fn end_of(element: &Element, behind: &Junction, given: Vector, end: End<Meeting>) -> (Vector, Clause, bool) {
    match end {
        End::Junction(_) => (behind.first, behind.clause, behind.ends_on_normal),
        End::Normal(clause) => (element.end_vector(element.radius), clause, true),
        End::Vector(side, clause) => (vector::end_of(element, given, side), clause, true),
        End::Programmed(clause) => (element.end, clause, true),
        End::Held => (element.end, clause::TRC_VEC_04, true),
    }
}

/// The moves of the junction behind an element are its own. [TRC-CORNER-12]
#[inline(always)]
fn owns_moves_behind(owner: CornerOwner, behind: &Junction, end: End<Meeting>) -> bool {
    // The move onto an arc of the new side is the arc's in any case. [TRC-SIDE-06]
    owner == CornerOwner::Previous && behind.clause != clause::TRC_SIDE_06 && matches!(end, End::Junction(_))
}

/// The state, with the block read and the sink of the path.
pub(crate) struct Scene<'a, S> {
    pub state: &'a mut State,
    pub sink: &'a mut S,
    /// Programmed end of the block read.
    pub end: Vector,
    /// Its index.
    pub block: usize,
    /// It moves at rapid rate.
    pub rapid: bool,
    /// It is a line or an arc, and no move that holds a vector: it may belong to a row. [TRC-INT-01]
    pub runs: bool,
    /// The vector that it gives; zero: none.
    pub given: Vector,
}

impl<S: Sink> Scene<'_, S> {
    /// Completes the element read.
    #[inline(always)]
    fn complete(&mut self, side: Side) {
        let radius = self.state.radius_in_force;
        let element = self.state.next();
        (element.side, element.radius, element.block, element.rapid) = (sigma(side), radius, self.block, self.rapid);
    }

    /// Completes the element read, whose junction was settled without it or is no junction.
    fn complete_settled(&mut self, side: Side) {
        self.complete(side);
        let (_, next) = places(self.state.pending);
        self.state.junctions[next].clear();
    }

    /// The move to the normal of an arc whose junction was settled without it, unless the tool stands there.
    /// [TRC-LOOK-05]
    fn line_in(&mut self) {
        let State { elements, junctions, pending, tool, .. } = &mut *self.state;
        let (_, next) = places(*pending);
        let element = &elements[next];
        let normal = element.start_vector(element.radius);
        let scale = element.scale + element.radius + magnitude(*tool);
        let away = sign(magnitude(normal - *tool), scale) != Ordering::Equal;
        if element.arc.is_some() && away {
            junctions[next].set(clause::TRC_LOOK_05, normal);
            junctions[next].push(normal);
        }
    }
}

impl<S: Sink> Geometry for Scene<'_, S> {
    /// It is [`State::junctions`] that holds it.
    type Junction = Meeting;

    #[inline(always)]
    fn arc_fault(&mut self, side: Side, joins: bool) -> Option<AlarmKind> {
        let State { radius_in_force: own, rules, elements, pending, .. } = &mut *self.state;
        let (pending, next) = places(*pending);
        let (arc, before) = (&elements[next], elements[pending].radius);
        if joins && before != *own {
            return vector::fault_between(arc, side, before, *own);
        }
        (!arc.tool_fits(side, *own, rules.equal_radius)).then_some(AlarmKind::RadiusTooSmall)
    }

    #[inline(never)]
    fn enter(&mut self, side: Side) -> Result<(), AlarmKind> {
        let State { radius_in_force, tool, rules, .. } = &mut *self.state;
        let (from, radius, equal) = (*tool, *radius_in_force, rules.equal_radius);
        entry::enter(self.state.next(), from, radius, side, equal)
    }

    #[inline(always)]
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<Meeting, AlarmKind> {
        if meeting == Meeting::CancelLine {
            self.set_imaginary();
        }
        self.complete(side);
        let State { imaginary, rules, elements, junctions, pending, .. } = &mut *self.state;
        let (first, second) = places(*pending);
        let (first, second, junction) = (&elements[first], &elements[second], &mut junctions[second]);
        // Both offset curves and every vector have the value of the element before. [TRC-MODE-11]
        let radius = first.radius;
        let formed = match meeting {
            Meeting::Corner => junction::corner(first, second, radius, rules, junction),
            Meeting::SideChange => junction::change_of_side(first, second, radius, rules, junction),
            Meeting::Cancel => type_b::cancel(first, second, radius, rules, junction),
            Meeting::CancelLine => imaginary::cancel(first, second, junction),
            Meeting::Shift => {
                junction.set(clause::TRC_START_08, second.start_vector(radius));
                Ok(())
            }
            Meeting::StartUp if *imaginary != Vector::zeros() => {
                imaginary::start_up(first, second, *imaginary, junction)
            }
            Meeting::StartUp if rules.start_up == StartUp::TypeB => {
                type_b::start_up(first, second, radius, rules, junction)
            }
            Meeting::StartUp => {
                junction.set(clause::TRC_START_02, second.start_vector(radius));
                Ok(())
            }
        };
        formed.map(|()| meeting)
    }

    #[inline(always)]
    fn settle(&mut self, end: End<Meeting>, part: Part) -> Result<(), Alarm> {
        if self.state.look == Look::InRows && part == Part::Contour && end != End::Held {
            return self.settle_in_row(end);
        }
        let State { elements, junctions, pending, tool, carried, rules, look, .. } = &mut *self.state;
        let (pending, next) = places(*pending);
        let (element, start, behind) = (&elements[pending], &junctions[pending], &junctions[next]);
        let tool_before = *tool;
        let from = || start.last().unwrap_or(tool_before);
        let (to, clause, on_normal) = match end {
            End::Held => (element.end + (from() - element.start), clause::TRC_VEC_04, true),
            _ => end_of(element, behind, self.given, end),
        };
        let degenerate = rules.equal_radius == EqualRadius::DegeneratePoint && element.is_point(element.radius);
        let arc = if degenerate { None } else { element.arc.as_ref() };
        let full = arc.is_some_and(|arc| arc.full) && start.starts_on_normal && on_normal;
        let looked_at = *look == Look::Alone && part != Part::StartUp && !degenerate && end != End::Held;
        if looked_at && let Some(kind) = wedge::reversed(element, from(), to, full) {
            return Err(Alarm { block: element.block, kind });
        }
        if end == End::Held {
            *carried = greater(element.scale, magnitude(from()));
        }
        let mut path = PathEnd { tool, sink: self.sink, block: element.block, rapid: element.rapid };
        path.corner_moves(start);
        path.own_move(arc, to, full, clause);
        if owns_moves_behind(rules.owner, behind, end) {
            path.corner_moves(behind);
            junctions[next].drop_moves();
        }
        Ok(())
    }

    fn lose(&mut self) -> Result<(), Alarm> {
        self.end_row()?;
        let State { elements, junctions, pending, tool, .. } = &mut *self.state;
        let (pending, _) = places(*pending);
        let element = &elements[pending];
        let mut path = PathEnd { tool, sink: self.sink, block: element.block, rapid: element.rapid };
        path.corner_moves(&junctions[pending]);
        Ok(())
    }

    #[inline(always)]
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause) {
        if self.state.row.holds_back() {
            return self.state.row.hold(rapid);
        }
        self.sink.step(Step { block, clause, rapid, main: false, segment: Segment::Hold });
    }

    fn corner_moves(&mut self) {
        let State { junctions, pending, tool, .. } = &mut *self.state;
        let (_, read) = places(*pending);
        PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid }.corner_moves(&junctions[read]);
    }

    #[inline(always)]
    fn follow(&mut self, clause: Clause) {
        let State { elements, pending, tool, .. } = &mut *self.state;
        let (_, next) = places(*pending);
        let arc = elements[next].arc.as_ref();
        let mut path = PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid };
        path.own_move(arc, self.end, arc.is_some_and(|arc| arc.full), clause);
    }

    fn retreat(&mut self) {
        let (to, tool) = (self.end, self.state.tool);
        let (last, _) = places(self.state.pending);
        let scale = greater(greater(magnitude(to), magnitude(tool)), self.state.carried);
        let scale = scale + self.state.elements[last].radius;
        if sign(magnitude(to - tool), scale) == Ordering::Equal {
            self.hold(self.block, self.rapid, clause::TRC_LOOK_01);
        } else {
            self.come_back(clause::TRC_CANCEL_06);
        }
    }

    fn come_back(&mut self, clause: Clause) {
        let tool = &mut self.state.tool;
        let mut path = PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid };
        path.own_move(None, self.end, false, clause);
    }

    #[inline(always)]
    fn begin(&mut self, begin: Begin, side: Side) {
        match begin {
            Begin::Junction => {}
            Begin::StartUp => {
                self.complete_settled(side);
                self.note_imaginary();
                self.state.carried = 0.0;
            }
            Begin::Shift => {
                let end = self.end;
                self.state.next().set_still(end);
                self.complete_settled(side);
            }
            Begin::Settled => {
                self.complete_settled(side);
                let carried = core::mem::take(&mut self.state.carried);
                let element = self.state.next();
                element.scale = greater(element.scale, carried);
                self.line_in();
            }
        }
        self.state.pending = !self.state.pending & 1;
    }

    fn corner_arc(&mut self, block: usize, rapid: bool, toward: Toward, side: Side) {
        self.emit_corner_arc(block, rapid, toward, side);
    }

    fn new_vector(&mut self, side: Side, settled: bool) {
        self.emit_new_vector(side, settled);
    }
}
