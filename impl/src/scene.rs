//! The geometry behind the look-ahead: the pending element, the path's end, and the emission of steps.

use core::cmp::Ordering;

use radcomp_spec::parameters::{CornerOwner, ReversedPath};
use radcomp_spec::{AlarmKind, Clause, Parameters, Segment, Side, Step, clause};

use crate::arc_form::Arc;
use crate::element::{Element, tool_fits};
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
    /// The pending element, when the look-ahead has one.
    pending: Element,
    /// The corner moves at its start that it owns. They are part of its block, which an alarm may keep from moving.
    lead: Moves,
    /// Its own move starts on its own normal. [TRC-ARC-07]
    lead_on_normal: bool,
    /// The element read, while its junction is formed.
    next: Element,
}

impl State {
    /// The state at the start of a program.
    pub fn new(parameters: &Parameters) -> State {
        let tolerance = parameters.arc_end_tolerance;
        let zero = Vector::new(0.0, 0.0);
        let nothing = Element::dummy(zero, Vector::new(1.0, 0.0), Side::Left, 0);
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
            pending: nothing,
            lead: Moves::none(clause::TRC_MODE_01),
            lead_on_normal: false,
            next: nothing,
        }
    }
}

/// The movement of the block read, as its element needs it.
#[derive(Clone, Copy)]
pub(crate) enum Piece {
    /// To the block's end, or nowhere.
    Straight,
    /// Along the vector.
    Dummy(Vector),
    /// The arc to the block's end.
    Arc(Arc),
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
    #[inline(always)]
    fn element(&self, side: Side) -> Element {
        let start = self.state.position;
        match self.piece {
            Piece::Straight => Element::line(start, self.end, side, self.block, self.rapid),
            Piece::Dummy(vector) => Element::dummy(start, vector, side, self.block),
            Piece::Arc(arc) => Element::arc(start, self.end, arc, side, self.block, self.rapid),
        }
    }

    /// Emits corner moves of the block. Moves of no length are not made. [TRC-CORNER-12]
    #[inline(always)]
    fn corner_moves(&mut self, moves: &Moves, block: usize, rapid: bool) {
        for point in moves.points() {
            if *point == self.state.tool {
                continue;
            }
            let end = (*point).into();
            let segment = match moves.round {
                None => Segment::Line { end },
                Some(direction) => Segment::Arc { end, centre: moves.centre.into(), direction, full: false },
            };
            self.sink.step(Step { block, clause: moves.clause, rapid, main: false, segment });
            self.state.tool = *point;
        }
    }

    #[inline(always)]
    fn own_move(&mut self, arc: Option<&Arc>, to: Vector, full: bool, step: (usize, bool, Clause)) {
        let (block, rapid, clause) = step;
        let segment = match arc {
            None => Segment::Line { end: to.into() },
            Some(arc) => Segment::Arc { end: to.into(), centre: arc.centre.into(), direction: arc.direction(), full },
        };
        self.sink.step(Step { block, clause, rapid, main: true, segment });
        self.state.tool = to;
    }
}

impl<S: Sink> Geometry for Scene<'_, S> {
    type Junction = Junction;

    #[inline(always)]
    fn tool_fits(&mut self, side: Side) -> bool {
        match &self.piece {
            Piece::Arc(arc) => tool_fits(arc, side, self.state.radius),
            Piece::Straight | Piece::Dummy(_) => true,
        }
    }

    #[inline(always)]
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<Junction, AlarmKind> {
        self.state.next = self.element(side);
        let State { pending, next, radius, rules, .. } = &*self.state;
        let junction = match meeting {
            // [TRC-START-02]
            Meeting::StartUp => Junction::at(clause::TRC_START_02, next.start_vector(*radius), true),
            Meeting::Corner => junction::corner(pending, next, *radius, *rules)?,
            Meeting::SideChange => junction::change_of_side(pending, next, *radius, *rules),
        };
        if junction.is_finite() { Ok(junction) } else { Err(AlarmKind::OutOfRange) }
    }

    #[inline(always)]
    fn settle(&mut self, end: End<Junction>, start_up: bool) -> Result<(), AlarmKind> {
        let pending = self.state.pending;
        let junction = match end {
            End::Junction(junction) => junction,
            End::Normal(clause) => Junction::at(clause, pending.end_vector(self.state.radius), true),
            End::Programmed(clause) => Junction::at(clause, pending.end, true),
        };
        let to = junction.first;
        if !is_finite(to) {
            return Err(AlarmKind::OutOfRange);
        }
        let lead = self.state.lead;
        let arc = pending.arc.as_ref();
        let full = arc.is_some_and(|arc| arc.full) && self.state.lead_on_normal && junction.on_normals;
        if self.state.reversed == ReversedPath::Alarm && !start_up {
            let from = lead.last().unwrap_or(self.state.tool);
            if let Some(kind) = wedge::reversed(&pending, from, to, full) {
                return Err(kind);
            }
        }
        self.corner_moves(&lead, pending.block, pending.rapid);
        self.own_move(arc, to, full, (pending.block, pending.rapid, junction.moves.clause));
        self.state.lead.count = 0;
        self.state.lead_on_normal = junction.on_normals;
        match self.state.owner {
            CornerOwner::Next => self.state.lead = junction.moves,
            CornerOwner::Previous => self.corner_moves(&junction.moves, pending.block, pending.rapid),
        }
        Ok(())
    }

    #[inline(always)]
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause) {
        self.sink.step(Step { block, clause, rapid, main: false, segment: Segment::Hold });
    }

    fn dummy(&mut self) {
        let lead = self.state.lead;
        self.corner_moves(&lead, self.block, self.rapid);
        self.state.lead.count = 0;
    }

    #[inline(always)]
    fn follow(&mut self, clause: Clause) {
        let (to, step) = (self.end, (self.block, self.rapid, clause));
        match self.piece {
            Piece::Straight | Piece::Dummy(_) => self.own_move(None, to, false, step),
            Piece::Arc(arc) => self.own_move(Some(&arc), to, arc.full, step),
        }
    }

    #[inline(always)]
    fn begin(&mut self, begin: Begin, side: Side) {
        match begin {
            Begin::Junction => self.state.pending = self.state.next,
            Begin::StartUp => {
                self.state.radius = self.state.radius_in_force;
                self.state.pending = self.element(side);
                self.state.lead.count = 0;
            }
            Begin::Settled => {
                let element = self.element(side);
                self.state.lead = line_in(&element, self.state.radius, self.state.tool);
                self.state.lead_on_normal = true;
                self.state.pending = element;
            }
        }
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
