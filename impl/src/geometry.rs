//! What the look-ahead tells geometry, and what it asks of it: the words between [`crate::window`] and the numbers.

use radcomp_spec::{AlarmKind, Clause, Compensation, Side};

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
}

/// What a block tells the look-ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// Its movement.
    pub kind: Kind,
    /// Its compensation code.
    pub code: Option<Compensation>,
    /// It puts another radius in force than the one before.
    pub other_radius: bool,
    /// It moves at rapid rate.
    pub rapid: bool,
}

/// How the pending element and the new one meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meeting {
    /// Start-up before an element. [TRC-START-02]
    StartUp,
    /// A corner on one side.
    Corner,
    /// A change of side. [TRC-SIDE-02], [TRC-SIDE-03]
    SideChange,
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
}

/// How a new element becomes the pending one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// As start-up block, from where the tool's centre stands. [TRC-START-01]
    StartUp,
    /// Behind the junction just formed.
    Junction,
    /// Behind a junction that was settled without it. [TRC-LOOK-04], [TRC-LOOK-05]
    Settled,
}

/// The answers of geometry, and the effects on the path, in the order in which they are called.
pub trait Geometry {
    /// A formed junction.
    type Junction;

    /// Whether the tool, on this side, fits the arc of the block read. [TRC-ARC-05]
    fn tool_fits(&mut self, side: Side) -> bool;
    /// Forms the junction between the pending element and the element read, which is on this side.
    ///
    /// # Errors
    /// An alarm at the block read.
    fn junction(&mut self, meeting: Meeting, side: Side) -> Result<Self::Junction, AlarmKind>;
    /// Emits the pending element; `start_up` when it is the start-up block.
    ///
    /// # Errors
    /// An alarm at the pending block, of which nothing is emitted then.
    fn settle(&mut self, end: End<Self::Junction>, start_up: bool) -> Result<(), AlarmKind>;
    /// Emits a block without movement.
    fn hold(&mut self, block: usize, rapid: bool, clause: Clause);
    /// Emits the corner moves that the dummy block read owns.
    fn dummy(&mut self);
    /// Emits the block read as a move to its programmed end.
    fn follow(&mut self, clause: Clause);
    /// Makes the element read, which is on this side, the pending one.
    fn begin(&mut self, begin: Begin, side: Side);
}
