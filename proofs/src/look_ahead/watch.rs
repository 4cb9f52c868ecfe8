//! Stands in for the geometry: answers as it is told, and watches what it is asked to emit and in which order.

use radcomp_impl::geometry::{Begin, End, Event, Geometry, Kind, Meeting, Part, Toward};
use radcomp_spec::parameters::{PendingAtAlarm, StartUpLost};
use radcomp_spec::{Alarm, AlarmKind, Clause, Compensation, Parameters, Side, clause};

use crate::{Choice, reached};

/// What has been emitted, and what is owed.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    /// The block whose own steps come next.
    pub next: usize,
    /// The block read.
    pub read: usize,
    /// The pending element.
    pub pending: Option<Awaited>,
    /// A corner arc that waits for the next element, and its side. [TRC-VEC-03]
    pub corner: Option<(usize, Side)>,
    /// The rapid flag of block n, at bit n modulo 128: no more than a hundred blocks are ever owed.
    rapid: u128,
    /// A start-up without next element has no vector. [TRC-START-04]
    no_vector: bool,
    /// An alarm loses the pending element. [TRC-MODE-10]
    lost: bool,
    /// The side that the codes ask for. [TRC-MODE-02]
    pub asked: Option<Side>,
    /// What the block read has done so far.
    now: Now,
}

/// The pending element, as it was begun.
#[derive(Clone, Copy, Debug)]
pub(super) struct Awaited {
    pub block: usize,
    pub begin: Begin,
    side: Side,
    /// It is an entry move, a line or an arc.
    entry: Option<Kind>,
}

/// What one block has done.
#[derive(Clone, Copy, Debug, Default)]
struct Now {
    /// It is a corner arc to the next element.
    waits: bool,
    /// It is an arc.
    arc: bool,
    /// It is an element or a dummy block.
    meets: bool,
    /// The element before it has ended for the vector of this block.
    ended: bool,
    /// The side in force. [TRC-SIDE-07]
    side: Option<Side>,
    /// It is an entry move, a line or an arc.
    entry: Option<Kind>,
    /// The pending element has met an alarm of its own.
    reversed: bool,
    /// The moves of a block that is lost have been made, and nothing may follow.
    over: bool,
    /// A junction has been formed, and not ended at yet.
    formed: bool,
    /// The element before it has ended at a junction.
    joined: bool,
    /// The moves of that junction that come behind its first vector are owed.
    owed: bool,
}

/// The geometry.
pub(super) struct Answers<'a, C> {
    pub watch: &'a mut Watch,
    pub choice: &'a mut C,
}

impl Watch {
    pub fn new(parameters: &Parameters) -> Watch {
        let no_vector = parameters.start_up_lost == StartUpLost::NoVector;
        let lost = parameters.pending_at_alarm == PendingAtAlarm::Lost;
        let now = Now::default();
        Watch { next: 0, read: 0, pending: None, corner: None, rapid: 0, no_vector, lost, asked: None, now }
    }

    /// A block begins to be read.
    pub fn begin_block(&mut self, event: Event) {
        let bit = 1 << (self.read % 128);
        self.rapid = if event.rapid { self.rapid | bit } else { self.rapid & !bit };
        match event.code {
            Some(Compensation::On(side)) => self.asked = Some(side),
            Some(Compensation::Off) => self.asked = None,
            None => {}
        }
        let side = self.asked.map(|side| if event.swapped { side.other() } else { side });
        let waits = event.kind == Kind::CornerToNext;
        let meets = matches!(event.kind, Kind::Line | Kind::Arc | Kind::Dummy | Kind::HeldVector);
        self.now = Now { side, waits, meets, arc: event.kind == Kind::Arc, ..Now::default() };
    }

    pub fn rapid(&self, block: usize) -> bool {
        self.rapid >> (block % 128) & 1 == 1
    }

    /// All before the alarm's block has been handed on, and nothing of it or after it; where the element before is lost,
    /// all before that, and the moves of the junction before it.
    pub fn stopped(&self, alarm: Alarm) {
        assert!(alarm.block <= self.read, "an alarm is at a block that has been read");
        let waits = self.pending.map(|pending| pending.block).or(self.corner.map(|corner| corner.0));
        // A block with G40 ends the element before it.
        if self.lost && self.asked.is_some() && waits.is_some() {
            assert!(waits == Some(self.next), "an alarm loses the element before its block");
        } else {
            assert!(self.next == alarm.block, "an alarm stops before its block");
        }
        let owns = |pending: Awaited| matches!(pending.begin, Begin::Junction | Begin::Settled);
        assert!(
            !self.lost || self.asked.is_none() || self.now.over || !self.pending.is_some_and(owns),
            "the moves of a block that is lost are made"
        );
    }

    fn emit(&mut self, block: usize) {
        assert!(!self.now.over, "nothing follows a block that is lost");
        assert!(block == self.next, "blocks are handed on in order, none lost and none twice");
        self.next += 1;
    }

    /// A block has been read without an alarm.
    pub fn end_block(&mut self) {
        assert!(!self.now.owed, "behind a junction comes an element or its corner moves");
        if self.now.waits && self.next == self.read {
            assert!(self.now.ended, "a corner arc waits behind an element that ended for it");
            self.corner = self.now.side.map(|side| (self.read, side));
        }
        self.read += 1;
    }

    /// Nothing is owed but the block read.
    fn is_at_its_place(&self) -> bool {
        self.pending.is_none() && self.corner.is_none() && self.next == self.read
    }
}

impl Awaited {
    /// It is a start-up block of type A or B.
    fn starts_up(&self) -> bool {
        self.begin == Begin::StartUp && self.entry.is_none()
    }
}

impl<C: Choice> Geometry for Answers<'_, C> {
    type Junction = ();

    fn arc_fault(&mut self, side: Side, joins: bool) -> Option<AlarmKind> {
        assert!(Some(side) == self.watch.now.side, "the tool is on the side in force");
        assert!(joins == self.watch.pending.is_some(), "an arc joins the element that is pending");
        self.choice.flag().then_some(AlarmKind::RadiusTooSmall)
    }

    fn enter(&mut self, side: Side) -> Result<(), AlarmKind> {
        assert!(Some(side) == self.watch.now.side, "an entry move is on the side in force");
        assert!(self.watch.is_at_its_place(), "an entry move follows what has been settled");
        if self.choice.flag() {
            reached!(self.choice, "an entry move");
            self.watch.now.entry = Some(if self.watch.now.arc { Kind::Arc } else { Kind::Line });
            Ok(())
        } else {
            Err(AlarmKind::EntryTooShort)
        }
    }

    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<(), AlarmKind> {
        let pending = self.watch.pending.expect("a junction has an element before it");
        let (same, in_force) = (side == pending.side, Some(side) == self.watch.now.side);
        let follows_an_element = !pending.starts_up() && pending.begin != Begin::Shift;
        let right = match meeting {
            Meeting::StartUp => pending.starts_up(),
            Meeting::Shift => pending.begin == Begin::Shift,
            Meeting::Corner => follows_an_element && same,
            Meeting::SideChange => follows_an_element && !same,
            // A start-up block before a cancel block has no corner, of whatever type it is. [TRC-CANCEL-05]
            Meeting::Cancel | Meeting::CancelLine => pending.begin != Begin::StartUp && follows_an_element && same,
        };
        assert!(right, "elements meet as they were begun");
        assert!(
            in_force || matches!(meeting, Meeting::Cancel | Meeting::CancelLine),
            "an element is met on the side in force"
        );
        match meeting {
            Meeting::StartUp => reached!(self.choice, "a start-up"),
            Meeting::Shift => reached!(self.choice, "a start-up without movement"),
            Meeting::Corner => reached!(self.choice, "a corner"),
            Meeting::SideChange => reached!(self.choice, "a change of side"),
            Meeting::Cancel => reached!(self.choice, "a cancel of type B"),
            Meeting::CancelLine => reached!(self.choice, "a cancel with an imaginary line"),
        }
        self.watch.now.formed = self.choice.flag();
        if self.watch.now.formed { Ok(()) } else { Err(AlarmKind::NoIntersection) }
    }

    fn settle(&mut self, end: End<()>, part: Part) -> Result<(), Alarm> {
        let pending = self.watch.pending.take().expect("an element is pending");
        let starts = pending.starts_up();
        let right = match (pending.begin, pending.entry) {
            (Begin::StartUp, Some(Kind::Arc)) => Part::EntryArc,
            (Begin::StartUp | Begin::Shift, _) => Part::StartUp,
            (Begin::Junction | Begin::Settled, _) => Part::Contour,
        };
        assert!(part == right, "an element is settled as what it was begun");
        let formed = std::mem::take(&mut self.watch.now.formed);
        match end {
            End::Junction(()) => assert!(formed, "an element ends at the junction just formed"),
            End::Normal(_) => {
                assert!(!formed, "a junction just formed is ended at");
                // [TRC-START-08]
                assert!(pending.begin != Begin::Shift, "a start-up without movement ends at a junction or is none");
            }
            End::Programmed(_) => {
                reached!(self.choice, "a start-up without vector");
                assert!(starts && self.watch.no_vector, "a start-up block alone ends at its programmed end");
            }
            End::Vector(side, _) => {
                if pending.block == self.watch.read {
                    reached!(self.choice, "a vector of a move");
                }
                assert!(Some(side) == self.watch.now.side, "a vector is on the side in force in its block");
            }
            End::Held => {
                reached!(self.choice, "a held vector");
                assert!(pending.block == self.watch.read && !starts, "a block holds its own vector");
            }
        }
        let for_corner = [clause::TRC_VEC_02, clause::TRC_VEC_03].map(End::Normal).contains(&end);
        self.watch.now.ended = for_corner || matches!(end, End::Vector(..));
        if self.choice.flag() {
            (self.watch.now.joined, self.watch.now.owed) = (formed, formed);
            self.watch.emit(pending.block);
            Ok(())
        } else {
            reached!(self.choice, "an alarm at the pending block");
            self.watch.now.reversed = true;
            Err(Alarm { block: pending.block, kind: AlarmKind::ReversedLine })
        }
    }

    fn lose(&mut self) -> Result<(), Alarm> {
        reached!(self.choice, "corner moves of a block that is lost");
        assert!(self.watch.lost, "a block is lost where the parameter says so");
        let owner = self.watch.pending.map(|pending| pending.begin);
        let owns = owner.map_or(self.watch.now.reversed, |begin| matches!(begin, Begin::Junction | Begin::Settled));
        assert!(owns && !self.watch.now.over, "corner moves belong to the element that is lost");
        self.watch.now.over = true;
        Ok(())
    }

    fn hold(&mut self, block: usize, rapid: bool, _: Clause) {
        assert!(rapid == self.watch.rapid(block), "a block keeps its rate");
        if self.watch.corner.take_if(|corner| corner.0 == block).is_some() {
            reached!(self.choice, "a corner arc without a next element");
        } else if let Some(pending) = self.watch.pending.take() {
            reached!(self.choice, "a start-up without movement that is none");
            assert!(pending.begin == Begin::Shift && pending.block == block, "a block that moves is settled");
        } else if block < self.watch.read {
            reached!(self.choice, "a block held and handed on later");
        }
        self.watch.emit(block);
    }

    fn corner_moves(&mut self) {
        reached!(self.choice, "corner moves that the block read owns");
        assert!(self.watch.is_at_its_place(), "the corner moves of a block come at its place");
        assert!(self.watch.now.joined, "corner moves are of the junction just formed");
        self.watch.now.owed = false;
    }

    fn retreat(&mut self) {
        reached!(self.choice, "a cancel without movement");
        assert!(self.watch.pending.is_none(), "the element before has ended");
        self.watch.emit(self.watch.read);
    }

    fn come_back(&mut self, _: Clause) {
        reached!(self.choice, "a move of length zero that cancels");
        assert!(self.watch.asked.is_none(), "a move of length zero cancels where no side is asked for");
        assert!(self.watch.pending.is_none(), "the element before has ended");
        self.watch.emit(self.watch.read);
    }

    fn follow(&mut self, _: Clause) {
        assert!(self.watch.pending.is_none(), "the element before has ended");
        self.watch.emit(self.watch.read);
    }

    fn begin(&mut self, begin: Begin, side: Side) {
        assert!(self.watch.is_at_its_place(), "one element pends at a time");
        let Now { entry, joined, side: in_force, .. } = self.watch.now;
        assert!(Some(side) == in_force, "an element begins on the side in force");
        match begin {
            Begin::StartUp => {}
            Begin::Shift => assert!(entry.is_none(), "an entry move moves"),
            Begin::Junction => {
                assert!(joined && entry.is_none(), "the junction behind which an element begins is formed")
            }
            Begin::Settled => assert!(!joined && entry.is_none(), "no junction is formed twice"),
        }
        self.watch.now.owed = false;
        self.watch.pending = Some(Awaited { block: self.watch.read, begin, side, entry });
    }

    fn corner_arc(&mut self, block: usize, rapid: bool, toward: Toward, side: Side) {
        assert!(rapid == self.watch.rapid(block), "a block keeps its rate");
        assert!(self.watch.pending.is_none(), "the element before has ended");
        match toward {
            Toward::Vector => {
                reached!(self.choice, "a corner arc to a vector");
                assert!(block == self.watch.read && self.watch.now.ended, "a corner arc follows an element");
                assert!(Some(side) == self.watch.now.side, "a vector is on the side in force in its block");
            }
            Toward::Element => {
                reached!(self.choice, "a corner arc to the next element");
                assert!(self.watch.corner.take() == Some((block, side)), "a corner arc waits on its own side");
                assert!(self.watch.now.meets, "a corner arc waits for an element");
            }
        }
        self.watch.emit(block);
    }

    fn new_vector(&mut self, side: Side, settled: bool) {
        reached!(self.choice, "a new vector");
        assert!(self.watch.pending.is_none() && settled != self.watch.now.ended, "a new vector knows what it follows");
        assert!(Some(side) == self.watch.now.side, "a vector is on the side in force in its block");
        self.watch.emit(self.watch.read);
    }
}
