//! The geometry behind the look-ahead: the pending element, the path's end, and the emission of steps.

use core::cmp::Ordering;

use radcomp_spec::parameters::{CornerOwner, ReversedPath};
use radcomp_spec::{AlarmKind, Clause, Parameters, Segment, Side, Step, clause};

use crate::arc_form::Arc;
use crate::element::{Element, sigma};
use crate::engine::Sink;
use crate::geometry::{Begin, End, Geometry, Meeting};
use crate::junction::{self, Junction, Rules};
use crate::plane::{Vector, magnitude};
use crate::sign::sign;
use crate::wedge;

/// What lasts from block to block, but for the look-ahead.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// What the profile says of junctions, and the outer corner in force. [TRC-CORNER-11]
    pub rules: Rules,
    /// [TRC-ARC-03], in millimetres.
    pub tolerance: f64,
    owner: CornerOwner,
    reversed: ReversedPath,
    /// Programmed end of the last block.
    pub position: Vector,
    /// Where the tool's centre stands at the end of what has been emitted.
    tool: Vector,
    /// The radius that the program has put in force.
    pub radius_in_force: f64,
    /// The tool radius: the one in force in the start-up block. [TRC-MODE-03]
    radius: f64,
    /// The pending element, when the look-ahead has one, and the element read: they change places instead of being
    /// copied.
    elements: [Element; 2],
    /// The junction at the start of each element. The moves of it that the element owns are part of its block, which
    /// an alarm may keep from moving; where it owns none, the junction has none any more.
    junctions: [Junction; 2],
    /// Which of them is the pending one, 0 or 1.
    pending: usize,
}

impl State {
    /// The state at the start of a program.
    pub fn new(parameters: &Parameters) -> State {
        let tolerance = parameters.arc_end_tolerance;
        let zero = Vector::new(0.0, 0.0);
        State {
            rules: Rules {
                reversal: parameters.reversal,
                side_change: parameters.side_change,
                outer: parameters.outer_corner,
            },
            tolerance: f64::from(tolerance.numerator) / f64::from(tolerance.denominator),
            owner: parameters.corner_owner,
            reversed: parameters.reversed_path,
            position: zero,
            tool: zero,
            radius_in_force: 0.0,
            radius: 0.0,
            elements: [Element::unused(); 2],
            junctions: [Junction::unused(); 2],
            pending: 0,
        }
    }

    /// The element read. It is put there as soon as its form has been found sound.
    #[inline(always)]
    pub fn next(&mut self) -> &mut Element {
        let (_, next) = places(self.pending);
        &mut self.elements[next]
    }
}

/// The places of the pending element and of the element read.
#[inline(always)]
fn places(pending: usize) -> (usize, usize) {
    // The masks tell the compiler that the places exist.
    (pending & 1, !pending & 1)
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
}

impl<S: Sink> Scene<'_, S> {
    /// Completes the element read.
    #[inline(always)]
    fn complete(&mut self, side: Side) {
        let element = self.state.next();
        (element.side, element.block, element.rapid) = (sigma(side), self.block, self.rapid);
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
        let State { radius, elements, junctions, pending, tool, .. } = &mut *self.state;
        let (_, next) = places(*pending);
        let element = &elements[next];
        let normal = element.start_vector(*radius);
        let away = sign(magnitude(normal - *tool), element.scale + *radius + magnitude(*tool)) != Ordering::Equal;
        if element.arc.is_some() && away {
            junctions[next].set(clause::TRC_LOOK_05, normal);
            junctions[next].push(normal);
        }
    }
}

/// The end of the path: where it goes on, and where its steps go.
struct PathEnd<'a, S> {
    tool: &'a mut Vector,
    sink: &'a mut S,
    block: usize,
    rapid: bool,
}

impl<S: Sink> PathEnd<'_, S> {
    /// Emits corner moves of the block. Moves of no length are not made. [TRC-CORNER-12]
    #[inline(always)]
    fn corner_moves(&mut self, junction: &Junction) {
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

    #[inline(always)]
    fn own_move(&mut self, arc: Option<&Arc>, to: Vector, full: bool, clause: Clause) {
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

    #[inline(always)]
    fn emit(&mut self, clause: Clause, main: bool, segment: Segment<f64>) {
        self.sink.step(Step { block: self.block, clause, rapid: self.rapid, main, segment });
    }
}

impl<S: Sink> Geometry for Scene<'_, S> {
    /// It is [`State::junctions`] that holds it.
    type Junction = ();

    #[inline(always)]
    fn tool_fits(&mut self, side: Side) -> bool {
        let radius = self.state.radius;
        self.state.next().tool_fits(side, radius)
    }

    #[inline(always)]
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<(), AlarmKind> {
        self.complete(side);
        let State { radius, rules, elements, junctions, pending, .. } = &mut *self.state;
        let (first, second) = places(*pending);
        let junction = &mut junctions[second];
        let (first, second) = (&elements[first], &elements[second]);
        match meeting {
            Meeting::Corner => junction::corner(first, second, *radius, rules, junction),
            Meeting::StartUp => {
                junction.set(clause::TRC_START_02, second.start_vector(*radius));
                Ok(())
            }
            Meeting::SideChange => junction::change_of_side(first, second, *radius, rules, junction),
        }
    }

    #[inline(always)]
    fn settle(&mut self, end: End<()>, start_up: bool) -> Result<(), AlarmKind> {
        let State { radius, elements, junctions, pending, tool, owner, reversed, .. } = &mut *self.state;
        let (pending, next) = places(*pending);
        let (element, start, behind) = (&elements[pending], &junctions[pending], &junctions[next]);
        let (to, clause, on_normal) = match end {
            End::Junction(()) => (behind.first, behind.clause, behind.on_normals),
            End::Normal(clause) => (element.end_vector(*radius), clause, true),
            End::Programmed(clause) => (element.end, clause, true),
        };
        let arc = element.arc.as_ref();
        let full = arc.is_some_and(|arc| arc.full) && start.on_normals && on_normal;
        if *reversed == ReversedPath::Alarm && !start_up {
            let from = start.last().unwrap_or(*tool);
            if let Some(kind) = wedge::reversed(element, from, to, full) {
                return Err(kind);
            }
        }
        let mut path = PathEnd { tool, sink: self.sink, block: element.block, rapid: element.rapid };
        path.corner_moves(start);
        path.own_move(arc, to, full, clause);
        if *owner == CornerOwner::Previous && end == End::Junction(()) {
            path.corner_moves(behind);
            junctions[next].drop_moves();
        }
        Ok(())
    }

    #[inline(always)]
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause) {
        self.sink.step(Step { block, clause, rapid, main: false, segment: Segment::Hold });
    }

    fn dummy(&mut self) {
        let State { junctions, pending, tool, .. } = &mut *self.state;
        let (_, dummy) = places(*pending);
        PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid }.corner_moves(&junctions[dummy]);
    }

    #[inline(always)]
    fn follow(&mut self, clause: Clause) {
        let State { elements, pending, tool, .. } = &mut *self.state;
        let (_, next) = places(*pending);
        let arc = elements[next].arc.as_ref();
        let mut path = PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid };
        path.own_move(arc, self.end, arc.is_some_and(|arc| arc.full), clause);
    }

    #[inline(always)]
    fn begin(&mut self, begin: Begin, side: Side) {
        match begin {
            Begin::Junction => {}
            Begin::StartUp => {
                self.complete_settled(side);
                self.state.radius = self.state.radius_in_force;
            }
            Begin::Settled => {
                self.complete_settled(side);
                self.line_in();
            }
        }
        self.state.pending = !self.state.pending & 1;
    }
}
