//! Interference of vectors over several blocks: a second stage behind the look-ahead, which compares the vectors of
//! several junctions before the blocks between them are handed on. [TRC-INT-01] to [TRC-INT-05]
//!
//! A row's blocks are held back in a ring, each with the vectors at its end, until what the profile reads of the row is
//! known. Where vectors are removed nothing is held back, and with `off` the stage is never called.

mod avoid;
mod compare;
mod held_back;
mod removal;

use radcomp_spec::parameters::{CornerOwner, Interference, InterferenceBlocks, InterferenceBoundary};
use radcomp_spec::{Alarm, AlarmKind, Parameters, Segment, Step, clause};

use crate::element::Element;
use crate::engine::Sink;
use crate::junction::Junction;
use crate::path::PathEnd;
use crate::plane::Vector;
pub(crate) use compare::Compared;
pub(crate) use held_back::{HeldBack, OwnMove, Point};
pub(crate) use removal::Removed;

/// A row of compensated blocks, as far as it has been read and is not handed on yet.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    mode: Interference,
    /// How many points ahead of a point its vectors are compared with. [TRC-INT-04]
    ahead: usize,
    /// Vectors that lead neither forward nor back interfere. [TRC-INT-02]
    inclusive: bool,
    /// Corner moves are the block's before them. [TRC-CORNER-12]
    previous: bool,
    /// The pending element belongs to the row.
    pub joined: bool,
    /// The vectors at the start of the first block held back.
    before: Point,
    /// Its corner moves are that block's own.
    owns_before: bool,
    /// The vectors at the start of that block interfere with none: what is looked at next is its end. [TRC-INT-05]
    started: bool,
    /// Where what has been handed on leaves the tool's centre.
    tool: Vector,
    /// The blocks held back: `count` of them from the place `first` on.
    blocks: [HeldBack; PLACES],
    first: usize,
    count: usize,
}

/// Places for blocks held back: with eight blocks read together there are seven.
const PLACES: usize = 7;

/// The element behind the last block of a row, with the junction at its start.
pub(crate) struct Next<'a> {
    pub element: &'a Element,
    pub junction: &'a mut Junction,
}

impl Row {
    /// No row, under these parameters.
    pub fn new(parameters: &Parameters) -> Row {
        Row {
            mode: parameters.interference,
            ahead: match parameters.interference_blocks {
                InterferenceBlocks::Three => 1,
                InterferenceBlocks::Four => 2,
                InterferenceBlocks::Five => 3,
                InterferenceBlocks::Six => 4,
                InterferenceBlocks::Seven => 5,
                InterferenceBlocks::Eight => 6,
            },
            inclusive: parameters.interference_boundary == InterferenceBoundary::Inclusive,
            previous: parameters.corner_owner == CornerOwner::Previous,
            joined: false,
            before: Point::one(clause::TRC_INT_01, Vector::zeros()),
            owns_before: false,
            started: false,
            tool: Vector::zeros(),
            blocks: core::array::from_fn(|_| HeldBack::unused()),
            first: 0,
            count: 0,
        }
    }

    /// Vectors are removed, and no block is held back. [TRC-INT-03]
    pub fn removes(&self) -> bool {
        self.mode == Interference::RemoveVectors
    }

    /// How many vectors are removed at the ends of a block; none can be when the outermost pair interferes. [TRC-INT-03]
    pub fn removed(&self, before: &Point, behind: &Point, compared: &Compared<'_>) -> Option<Removed> {
        removal::search(before, behind, compared, self.inclusive)
    }

    /// Where the tool's centre stands, if no block is held back.
    pub fn handed_on(&self) -> Option<Vector> {
        (self.count == 0).then_some(self.tool)
    }

    /// Blocks are held back.
    #[inline(always)]
    pub fn holds_back(&self) -> bool {
        self.count > 0
    }

    /// Holds a block without movement back behind the last block.
    pub fn hold(&mut self, rapid: bool) {
        let last = self.count.saturating_sub(1);
        self.block_mut(last).held.push(rapid);
    }

    /// Takes the next block of the row. The first of a row starts at one vector, where `tool` or the junction `start`
    /// leaves the tool's centre. [TRC-INT-01]
    pub fn take(&mut self, block: HeldBack, start: &Junction, tool: Vector) {
        if !self.joined {
            self.before = Point { junction: *start, one: Some(start.last().unwrap_or(tool)) };
            (self.owns_before, self.started, self.tool) = (true, false, tool);
        }
        let place = self.count;
        self.count = (self.count + 1).min(PLACES);
        *self.block_mut(place) = block;
    }

    /// Looks at each point of the row, of which enough is known, in order, and hands on what no comparison asks for any
    /// more; at the row's end, all of it. `next` is the element behind the last block, if it belongs to the row.
    ///
    /// # Errors
    /// [TRC-INT-04], [TRC-INT-05]: the alarm at a block that has been held back.
    pub fn advance<S: Sink>(&mut self, ends: bool, mut next: Option<Next<'_>>, sink: &mut S) -> Result<(), Alarm> {
        let avoids = self.mode == Interference::Avoid;
        loop {
            // The blocks behind the point that is looked at.
            let skipped = usize::from(avoids && self.started);
            let known = self.count.saturating_sub(skipped);
            if known == 0 && ends && self.count > 0 {
                self.hand_on(sink);
            }
            if known == 0 || known < self.ahead && !ends {
                return Ok(());
            }
            match (1..=known.min(self.ahead)).rev().find(|distance| self.interferes(skipped, *distance)) {
                None if avoids && skipped == 0 => self.started = true,
                None => self.hand_on(sink),
                Some(_) if skipped == 0 => return Err(interference(self.block(0))),
                Some(distance) => match self.meeting(distance, next.as_ref().map(|next| next.element)) {
                    Some(meeting) => self.leave_out(distance, meeting, next.as_mut(), sink),
                    None => {
                        self.hand_on(sink);
                        return Err(interference(self.block(0)));
                    }
                },
            }
        }
    }

    /// Whether a vector at the start of the block at this place interferes with one at the end of the block so many
    /// points farther. [TRC-INT-02], [TRC-INT-04]
    fn interferes(&self, place: usize, distance: usize) -> bool {
        let here = if place == 0 { self.before } else { self.block(place - 1).end() };
        let (near, far) = (self.block(place), self.block(place + distance - 1));
        let there = far.end();
        let compared = if distance == 1 {
            Compared::block(near)
        } else {
            Compared::Points { from: near.element.start, to: far.element.end, scale: near.element.scale }
        };
        here.vectors().any(|v| there.vectors().any(|w| compared.interfere(v, w, self.inclusive)))
    }

    /// Hands on the first block.
    fn hand_on<S: Sink>(&mut self, sink: &mut S) {
        let block = &self.blocks[self.first % PLACES];
        let mut path = PathEnd { tool: &mut self.tool, sink, block: block.element.block, rapid: block.element.rapid };
        if self.owns_before || !self.previous {
            path.corner_moves(&self.before.junction);
        }
        let arc = if block.own.straight { None } else { block.element.arc.as_ref() };
        path.own_move(arc, block.own.to, block.own.full, block.own.clause);
        if block.owns_behind {
            path.corner_moves(&block.behind);
        }
        block.emit_held(sink);
        self.before = block.end();
        self.owns_before = false;
        self.drop_first();
    }

    /// Ends the first block at the meeting point, leaves so many blocks behind it out, and starts what comes then there.
    /// [TRC-INT-05]
    fn leave_out<S: Sink>(&mut self, blocks: usize, meeting: Vector, next: Option<&mut Next<'_>>, sink: &mut S) {
        let clause = clause::TRC_INT_05;
        let last = self.block_mut(0);
        last.own = OwnMove { to: meeting, clause, full: false, straight: last.own.straight };
        last.owns_behind = false;
        self.hand_on(sink);
        for _ in 0..blocks {
            let block = self.block(0);
            let Element { block: index, rapid, .. } = block.element;
            sink.step(Step { block: index, clause, rapid, main: false, segment: Segment::Hold });
            block.emit_held(sink);
            self.drop_first();
        }
        self.before = Point::one(clause, meeting);
        self.started = false;
        if let Some(next) = next.filter(|_| self.count == 0) {
            next.junction.set(clause, meeting);
            next.junction.leave_normals();
        }
    }

    fn drop_first(&mut self) {
        self.first = (self.first + 1) % PLACES;
        self.count = self.count.saturating_sub(1);
    }

    /// The block at a place behind the first. The remainder tells the compiler that the place exists.
    fn block(&self, place: usize) -> &HeldBack {
        &self.blocks[(self.first + place) % PLACES]
    }

    fn block_mut(&mut self, place: usize) -> &mut HeldBack {
        &mut self.blocks[(self.first + place) % PLACES]
    }
}

/// The alarm at a block.
fn interference(block: &HeldBack) -> Alarm {
    Alarm { block: block.element.block, kind: AlarmKind::Interference }
}
