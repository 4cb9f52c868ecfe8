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
    /// The corner moves at its start that it owns. They are part of its block, which an alarm may keep from moving.
    lead: Moves,
    /// Its own move starts on its own normal. [TRC-ARC-07]
    lead_on_normal: bool,
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
            lead: Moves::none(clause::TRC_MODE_01),
            lead_on_normal: false,
        }
    }

    /// The pending element and the one read.
    #[inline(always)]
    fn meeting(&self) -> (&Element, &Element) {
        let [one, other] = &self.elements;
        if self.second_pending { (other, one) } else { (one, other) }
    }

    /// Where the element read is put; its arc, if it is one, is there as soon as its form has been found sound.
    #[inline(always)]
    pub fn next(&mut self) -> &mut Element {
        let [one, other] = &mut self.elements;
        if self.second_pending { one } else { other }
    }
}

/// The movement of the block read, as its element needs it.
#[derive(Clone, Copy)]
pub(crate) enum Piece {
    /// To the block's end, or nowhere.
    Straight,
    /// Along the vector.
    Dummy(Vector),
    /// The arc of [`State::next`], to the block's end.
    Arc,
}

/// The state, with the block read and the sink of the path.
pub(crate) struct Scene<'a, S> {
    pub state: &'a mut State,
    pub sink: &'a mut S,
    pub piece: Piece,
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
    fn make(&mut self, side: Side) {
        let start = self.state.position;
        let element = self.state.next();
        match self.piece {
            Piece::Straight => element.set_line(start, self.end),
            Piece::Dummy(vector) => element.set_dummy(start, vector),
            Piece::Arc => element.set_arc(start, self.end),
        }
        (element.side, element.block, element.rapid) = (sigma(side), self.block, self.rapid);
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
        self.make(side);
        let (pending, next) = self.state.meeting();
        let (radius, rules) = (self.state.radius, self.state.rules);
        let junction = match meeting {
            // [TRC-START-02]
            Meeting::StartUp => Junction::at(clause::TRC_START_02, next.start_vector(radius), true),
            Meeting::Corner => junction::corner(pending, next, radius, rules)?,
            Meeting::SideChange => junction::change_of_side(pending, next, radius, rules),
        };
        if junction.is_finite() { Ok(junction) } else { Err(AlarmKind::OutOfRange) }
    }

    #[inline(always)]
    fn settle(&mut self, end: End<Junction>, start_up: bool) -> Result<(), AlarmKind> {
        let (pending, _) = self.state.meeting();
        let junction = match end {
            End::Junction(junction) => junction,
            End::Normal(clause) => Junction::at(clause, pending.end_vector(self.state.radius), true),
            End::Programmed(clause) => Junction::at(clause, pending.end, true),
        };
        let to = junction.first;
        if !is_finite(to) {
            return Err(AlarmKind::OutOfRange);
        }
        let (arc, lead) = (pending.arc.as_ref(), &self.state.lead);
        let full = arc.is_some_and(|arc| arc.full) && self.state.lead_on_normal && junction.on_normals;
        if self.state.reversed == ReversedPath::Alarm && !start_up {
            let from = lead.last().unwrap_or(self.state.tool);
            if let Some(kind) = wedge::reversed(pending, from, to, full) {
                return Err(kind);
            }
        }
        let mut tool = self.state.tool;
        let mut path = PathEnd { tool: &mut tool, sink: self.sink, block: pending.block, rapid: pending.rapid };
        path.corner_moves(lead);
        path.own_move(arc, to, full, junction.moves.clause);
        let owner = self.state.owner;
        if owner == CornerOwner::Previous {
            path.corner_moves(&junction.moves);
        }
        self.state.tool = tool;
        self.state.lead.count = 0;
        if owner == CornerOwner::Next && junction.moves.count > 0 {
            self.state.lead = junction.moves;
        }
        self.state.lead_on_normal = junction.on_normals;
        Ok(())
    }

    #[inline(always)]
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause) {
        self.sink.step(Step { block, clause, rapid, main: false, segment: Segment::Hold });
    }

    fn dummy(&mut self) {
        let State { tool, lead, .. } = &mut *self.state;
        PathEnd { tool, sink: self.sink, block: self.block, rapid: self.rapid }.corner_moves(lead);
        lead.count = 0;
    }

    #[inline(always)]
    fn follow(&mut self, clause: Clause) {
        let (_, next) = self.state.meeting();
        let arc = next.arc.as_ref().filter(|_| matches!(self.piece, Piece::Arc));
        let mut tool = self.state.tool;
        let mut path = PathEnd { tool: &mut tool, sink: self.sink, block: self.block, rapid: self.rapid };
        path.own_move(arc, self.end, arc.is_some_and(|arc| arc.full), clause);
        self.state.tool = tool;
    }

    #[inline(always)]
    fn begin(&mut self, begin: Begin, side: Side) {
        match begin {
            Begin::Junction => {}
            Begin::StartUp => {
                self.make(side);
                self.state.radius = self.state.radius_in_force;
                self.state.lead.count = 0;
            }
            Begin::Settled => {
                self.make(side);
                let (_, element) = self.state.meeting();
                self.state.lead = line_in(element, self.state.radius, self.state.tool);
                self.state.lead_on_normal = true;
            }
        }
        self.state.second_pending = !self.state.second_pending;
    }
}

/// The move to the normal of an arc whose junction was settled without it, unless the tool stands there. [TRC-LOOK-05]
fn line_in(element: &Element, radius: f64, tool: Vector) -> Moves {
    let normal = element.start_vector(radius);
    let away = sign(magnitude(normal - tool), element.scale + radius + magnitude(tool)) != Ordering::Equal;
    if element.arc.is_some() && away {
        Moves::to(clause::TRC_LOOK_05, normal)
    } else {
        Moves::none(clause::TRC_LOOK_05)
    }
}
