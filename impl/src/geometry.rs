//! What the look-ahead tells geometry, and what it asks of it: the words between [`crate::window`] and the numbers.

use radcomp_spec::{Alarm, AlarmKind, Clause, Compensation, Side};

/// The movement of a block, as far as the look-ahead tells them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A block without movement. [TRC-LOOK-01]
    Still,
    /// A dummy block whose vector is not zero. [TRC-DUMMY-01]
    Dummy,
    /// A straight move of non-zero length.
    Line,
    /// An arc that exists.
    Arc,
    /// G38 with a straight move of non-zero length: the vector is held. [TRC-VEC-04]
    HeldVector,
    /// G38 with I, J, K: a new vector. [TRC-VEC-05]
    NewVector,
    /// G39 with a direction: a corner arc. [TRC-VEC-02]
    CornerArc,
    /// G39 alone: a corner arc to the next element. [TRC-VEC-03]
    CornerToNext,
}

/// What a block tells the look-ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// Its movement.
    pub kind: Kind,
    /// Its compensation code.
    pub code: Option<Compensation>,
    /// It puts a radius of another magnitude in force than the one before.
    pub other_radius: bool,
    /// It moves at rapid rate.
    pub rapid: bool,
    /// The radius in force is negative: the sides are exchanged. [TRC-SIDE-07]
    pub swapped: bool,
    /// It is a straight move of length zero. [TRC-LOOK-07]
    pub zero_length: bool,
    /// It holds a code that stops reading ahead. [TRC-LOOK-08]
    pub stops: bool,
    /// The alarm of a code in it that is not for offset mode. [TRC-MODE-08]
    pub not_in_mode: Option<AlarmKind>,
    /// I, J, K stand beside its compensation code. [TRC-START-10], [TRC-START-11], [TRC-VEC-06], [TRC-CANCEL-08]
    pub vector: bool,
    /// It holds G38 or G39. [TRC-VEC-01]
    pub vector_code: bool,
}

impl Event {
    /// A block of this kind that tells nothing else.
    #[must_use]
    pub const fn of(kind: Kind) -> Event {
        Event {
            kind,
            code: None,
            other_radius: false,
            rapid: false,
            swapped: false,
            zero_length: false,
            stops: false,
            not_in_mode: None,
            vector: false,
            vector_code: matches!(kind, Kind::HeldVector | Kind::NewVector | Kind::CornerArc | Kind::CornerToNext),
        }
    }
}

/// How the pending element and the new one meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// Start-up of type A or B before an element. [TRC-START-02], [TRC-START-06]
    StartUp,
    /// Start-up without movement before an element. [TRC-START-08]
    Shift,
    /// A corner on one side.
    Corner,
    /// A change of side. [TRC-SIDE-02] to [TRC-SIDE-06]
    SideChange,
    /// Cancel of type B. [TRC-CANCEL-05]
    Cancel,
    /// Cancel with an imaginary line. [TRC-CANCEL-08]
    CancelLine,
}

/// Where the pending element ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End<J> {
    /// At the first vector of a formed junction.
    Junction(J),
    /// On the normal at its own end, by the clause.
    Normal(Clause),
    /// At its programmed end, by the clause.
    Programmed(Clause),
    /// At right angles to the vector of the block read, on this side, by the clause; an arc on its own normal.
    /// [TRC-START-10], [TRC-VEC-05], [TRC-VEC-06]
    Vector(Side, Clause),
    /// With the vector that it has at its start. [TRC-VEC-04]
    Held,
}

/// What an element is settled as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A start-up block, a straight entry move among them. [TRC-START-01], [TRC-START-07]
    StartUp,
    /// An arc as entry move. [TRC-START-09]
    EntryArc,
    /// An element of offset mode.
    Contour,
}

/// Where a corner arc leads. [TRC-VEC-02], [TRC-VEC-03]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toward {
    /// To the vector at right angles to that of the block read.
    Vector,
    /// To the normal of the element read.
    Element,
}

/// How a new element becomes the pending one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// As start-up block, from where the tool's centre stands. [TRC-START-01]
    StartUp,
    /// As start-up block without movement. [TRC-START-08]
    Shift,
    /// Behind the junction just formed.
    Junction,
    /// Behind a junction that was settled without it. [TRC-LOOK-04], [TRC-LOOK-05]
    Settled,
}

/// The answers of geometry, and the effects on the path, in the order in which they are called.
pub trait Geometry {
    /// A formed junction.
    type Junction;

    /// The alarm of the block read, an arc in which the tool does not fit on this side, or, if it `joins` the pending
    /// element, a full circle that its value does not fit. [TRC-ARC-05], [TRC-ARC-08], [TRC-MODE-11]
    fn arc_fault(&mut self, side: Side, joins: bool) -> Option<AlarmKind>;
    /// Makes the block read an entry move on this side; it is begun as start-up block next. [TRC-START-07],
    /// [TRC-START-09]
    ///
    /// # Errors
    /// An alarm at the block read.
    fn enter(&mut self, side: Side) -> Result<(), AlarmKind>;
    /// Forms the junction between the pending element and the element read, which is on this side.
    ///
    /// # Errors
    /// An alarm at the block read.
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<Self::Junction, AlarmKind>;
    /// Emits the pending element, or holds it back until more vectors are known. [TRC-INT-04]
    ///
    /// # Errors
    /// An alarm at the pending block, of which nothing is emitted then, or at one that has been held back.
    /// [TRC-WEDGE-02], [TRC-WEDGE-03], [TRC-INT-03] to [TRC-INT-05]
    fn settle(&mut self, end: End<Self::Junction>, part: Part) -> Result<(), Alarm>;
    /// Emits what is held back, and the moves of the junction before the pending element that it owns, when the element
    /// itself, which is no start-up block, is lost in an alarm. [TRC-MODE-10]
    ///
    /// # Errors
    /// An alarm at a block that has been held back.
    fn lose(&mut self) -> Result<(), Alarm>;
    /// Emits a block without movement.
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause);
    /// Emits the corner moves that the block read owns: a dummy block, or a cancel block of type B.
    fn corner_moves(&mut self);
    /// Emits the block read as a move to its programmed end.
    fn follow(&mut self, clause: Clause);
    /// Emits the block read as a straight move to the programmed point where it stands, or as a block without movement
    /// if the tool's centre stands there. [TRC-CANCEL-06]
    fn retreat(&mut self);
    /// Emits the block read, a move of length zero, as a straight move to the programmed point, even if the tool's centre
    /// stands there. [TRC-LOOK-07]
    fn come_back(&mut self, clause: Clause);
    /// Makes the element read, which is on this side, the pending one.
    fn begin(&mut self, begin: Begin, side: Side);
    /// Emits a corner arc on this side as a block's own move, behind the element that ended last: the block read's, or
    /// that of a block which waited for the element read. [TRC-VEC-02], [TRC-VEC-03]
    fn corner_arc(&mut self, block: usize, rapid: bool, toward: Toward, side: Side);
    /// Emits the move of the block read to the vector that it gives on this side: one that replaces the vector of a junction
    /// `settled` before it has the radius in force, another that of the element before. [TRC-VEC-05]
    fn new_vector(&mut self, side: Side, settled: bool);
}
