//! The geometry behind the look-ahead: the pending element, the path's end, and the emission of steps.

use core::cmp::Ordering;

use radcomp_spec::parameters::{CornerOwner, ReversedPath};
use radcomp_spec::{AlarmKind, Clause, Parameters, Segment, Side, Step, clause};

use crate::arc_form::Arc;
use crate::element::{Element, sigma, tool_fits};
use crate::engine::Sink;
use crate::geometry::{Begin, End, Geometry, Meeting};
use crate::junction::{self, Junction, Moves, Rules};
use crate::plane::{Vector, is_finite, magnitude};
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
    /// The pending element, when the look-ahead has one, and the element read, while its junction is formed: they
    /// change places instead of being copied.
    elements: [Element; 2],
    /// The second of them is the pending one.
    second_pending: bool,
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
            second_pending: false,
        }
    }

    /// The element read. It is put there as soon as its form has been found sound.
    #[inline(always)]
    pub fn next(&mut self) -> &mut Element {
        meeting(&mut self.elements, self.second_pending).1
    }
}

/// The pending element and the one read.
#[inline(always)]
fn meeting(elements: &mut [Element; 2], second_pending: bool) -> (&mut Element, &mut Element) {
    let [one, other] = elements;
    if second_pending { (other, one) } else { (one, other) }
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
    /// Completes the element read: its block, its side, and that its path starts on its own normal without a lead.
    #[inline(always)]
    fn complete(&mut self, side: Side) {
        let element = self.state.next();
        (element.side, element.block, element.rapid) = (sigma(side), self.block, self.rapid);
        (element.lead.count, element.lead_on_normal) = (0, true);
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
    fn corner_moves(&mut self, moves: &Moves) {
        for point in moves.points() {
            if *point == *self.tool {
                continue;
            }
            let end = (*point).into();
            let segment = match moves.round {
                None => Segment::Line { end },
                Some(direction) => Segment::Arc { end, centre: moves.centre.into(), direction, full: false },
            };
            self.emit(moves.clause, false, segment);
            *self.tool = *point;
        }
    }

    #[inline(always)]
    fn own_move(&mut self, arc: Option<&Arc>, to: Vector, full: bool, clause: Clause) {
        let end = to.into();
        let segment = match arc {
            None => Segment::Line { end },
            Some(arc) => Segment::Arc { end, centre: arc.centre.into(), direction: arc.direction(), full },
        };
        self.emit(clause, true, segment);
        *self.tool = to;
    }

    #[inline(always)]
    fn emit(&mut self, clause: Clause, main: bool, segment: Segment<f64>) {
        self.sink.step(Step { block: self.block, clause, rapid: self.rapid, main, segment });
    }
}

impl<S: Sink> Geometry for Scene<'_, S> {
    type Junction = Junction;

    #[inline(always)]
    fn tool_fits(&mut self, side: Side) -> bool {
        let radius = self.state.radius;
        self.state.next().arc.as_ref().is_none_or(|arc| tool_fits(arc, side, radius))
    }

    #[inline(always)]
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<Junction, AlarmKind> {
        self.complete(side);
        let State { radius, rules, elements, second_pending, .. } = &mut *self.state;
        let (pending, next) = self::meeting(elements, *second_pending);
        let junction = match meeting {
            Meeting::Corner => junction::corner(pending, next, *radius, *rules)?,
            // [TRC-START-02]
            Meeting::StartUp => {
                Junction { first: next.start_vector(*radius), clause: clause::TRC_START_02, on_normals: true }
            }
            Meeting::SideChange => junction::change_of_side(pending, next, *radius, *rules),
        };
        // The points of a lead are finite already.
        if is_finite(junction.first) { Ok(junction) } else { Err(AlarmKind::OutOfRange) }
    }

    #[inline(always)]
    fn settle(&mut self, end: End<Junction>, start_up: bool) -> Result<(), AlarmKind> {
        let State { radius, elements, second_pending, tool, owner, reversed, .. } = &mut *self.state;
        let (pending, next) = meeting(elements, *second_pending);
        let (to, clause, on_normals) = match &end {
            End::Junction(junction) => (junction.first, junction.clause, junction.on_normals),
            // Sums of numbers within range: finite.
            End::Normal(clause) => (pending.end_vector(*radius), *clause, true),
            End::Programmed(clause) => (pending.end, *clause, true),
        };
        let arc = pending.arc.as_ref();
        let full = arc.is_some_and(|arc| arc.full) && pending.lead_on_normal && on_normals;
        if *reversed == ReversedPath::Alarm && !start_up {
            let from = pending.lead.last().unwrap_or(*tool);
            if let Some(kind) = wedge::reversed(pending, from, to, full) {
                return Err(kind);
            }
        }
        let mut path = PathEnd { tool, sink: self.sink, block: pending.block, rapid: pending.rapid };
        path.corner_moves(&pending.lead);
        path.own_move(arc, to, full, clause);
        if let End::Junction(junction) = end {
            next.lead_on_normal = junction.on_normals;
            if *owner == CornerOwner::Previous {
                path.corner_moves(&next.lead);
                next.lead.count = 0;
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause) {
        self.sink.step(Step { block, clause, rapid, main: false, segment: Segment::Hold });
    }

    fn dummy(&mut self) {
        let State { elements, second_pending, tool, .. } = &mut *self.state;
        let (_, dummy) = meeting(elements, *second_pending);
        PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid }.corner_moves(&dummy.lead);
    }

    #[inline(always)]
    fn follow(&mut self, clause: Clause) {
        let State { elements, second_pending, tool, .. } = &mut *self.state;
        let (_, next) = meeting(elements, *second_pending);
        let arc = next.arc.as_ref();
        let mut path = PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid };
        path.own_move(arc, self.end, arc.is_some_and(|arc| arc.full), clause);
    }

    #[inline(always)]
    fn begin(&mut self, begin: Begin, side: Side) {
        match begin {
            Begin::Junction => {}
            Begin::StartUp => {
                self.complete(side);
                self.state.radius = self.state.radius_in_force;
            }
            Begin::Settled => {
                self.complete(side);
                let State { radius, elements, second_pending, tool, .. } = &mut *self.state;
                line_in(meeting(elements, *second_pending).1, *radius, *tool);
            }
        }
        self.state.second_pending = !self.state.second_pending;
    }
}

/// The move to the normal of an arc whose junction was settled without it, unless the tool stands there. [TRC-LOOK-05]
fn line_in(element: &mut Element, radius: f64, tool: Vector) {
    let normal = element.start_vector(radius);
    let away = sign(magnitude(normal - tool), element.scale + radius + magnitude(tool)) != Ordering::Equal;
    if element.arc.is_some() && away {
        element.lead.set(clause::TRC_LOOK_05, normal);
    }
}
