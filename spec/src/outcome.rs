//! What compensation answers: path steps, alarms, advisories.

use crate::block::{Direction, Point};
use crate::clause::{self, Clause};

/// One element of the path of the tool's centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Step<N> {
    /// Index of the block, from 0, that the element belongs to ([TRC-CORNER-12]).
    pub block: usize,
    /// The clause that made the element's end point.
    pub clause: Clause,
    /// The element is traversed at rapid rate.
    pub rapid: bool,
    /// The element is the block's own move, not a corner move added to it.
    pub main: bool,
    /// Its geometry; it begins where the element before it ended.
    pub segment: Segment<N>,
}

/// The geometry of a path element.
#[derive(Clone, Debug, PartialEq)]
pub enum Segment<N> {
    /// A straight move.
    Line {
        /// End point of the tool's centre.
        end: Point<N>,
    },
    /// A circular move. The distances of start and end from the centre may differ by the arc end tolerance
    /// ([TRC-ARC-04]).
    Arc {
        /// End point of the tool's centre.
        end: Point<N>,
        /// Centre.
        centre: Point<N>,
        /// Sense.
        direction: Direction,
        /// A whole turn, start and end being one point ([TRC-ARC-07]).
        full: bool,
    },
    /// A block without movement in the plane is executed here.
    Hold,
}

impl<N> Step<N> {
    /// The same step in other numbers.
    pub fn map<M>(&self, number: impl Fn(&N) -> M) -> Step<M> {
        let point = |[a, b]: &Point<N>| [number(a), number(b)];
        let segment = match &self.segment {
            Segment::Hold => Segment::Hold,
            Segment::Line { end } => Segment::Line { end: point(end) },
            Segment::Arc { end, centre, direction, full } => {
                Segment::Arc { end: point(end), centre: point(centre), direction: *direction, full: *full }
            }
        };
        Step { block: self.block, clause: self.clause, rapid: self.rapid, main: self.main, segment }
    }
}

/// A fault of the program that ends the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Alarm {
    /// Index of the block, from 0, that the alarm is raised at.
    pub block: usize,
    /// What is wrong.
    pub kind: AlarmKind,
}

macro_rules! kinds {
    ($(#[$meta:meta])* $type:ident { $($(#[$doc:meta])* $name:ident = $id:literal, $clause:ident, $text:literal;)* }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum $type {
            $($(#[$doc])* #[doc = concat!("; ", $text, ".")] $name,)*
        }

        impl $type {
            /// Every kind.
            pub const ALL: &[$type] = &[$($type::$name),*];

            /// The name used in files and reports.
            pub const fn id(self) -> &'static str {
                match self { $($type::$name => $id,)* }
            }

            /// The clause that defines it.
            pub const fn clause(self) -> Clause {
                match self { $($type::$name => clause::$clause,)* }
            }

            /// The sentence shown to a person.
            pub const fn text(self) -> &'static str {
                match self { $($type::$name => $text,)* }
            }
        }
    };
}

kinds! {
    /// The alarms.
    AlarmKind {
        /// [TRC-START-03]
        ArcAtStartUp = "arc-at-start-up", TRC_START_03, "compensation starts with an arc: start-up needs a straight move";
        /// [TRC-CANCEL-04]
        ArcAtCancel = "arc-at-cancel", TRC_CANCEL_04, "compensation is cancelled on an arc: cancel needs a straight move";
        /// [TRC-CORNER-05]
        NoIntersection = "no-intersection", TRC_CORNER_05, "the offset contours of this block and the block before do not meet";
        /// [TRC-CORNER-09]
        Reversal = "reversal", TRC_CORNER_09, "the path turns back on itself";
        /// [TRC-SIDE-01]
        SideChangeForbidden = "side-change-forbidden", TRC_SIDE_01, "the side may not change without G40 between";
        /// [TRC-SIDE-04]
        SideChangeAfterStartUp = "side-change-after-start-up", TRC_SIDE_04, "the side may not change in the block after start-up";
        /// [TRC-MODE-03]
        OffsetChangedInMode = "offset-changed-in-mode", TRC_MODE_03, "the offset changes while compensation is in force";
        /// [TRC-ARC-02]
        CentreAtEnd = "centre-at-end", TRC_ARC_02, "the centre of the arc is its start or its end";
        /// [TRC-ARC-03]
        EndOffArc = "end-off-arc", TRC_ARC_03, "the end of the arc does not lie on it";
        /// [TRC-ARC-05]
        RadiusTooSmall = "radius-too-small", TRC_ARC_05, "the tool does not fit inside the arc";
        /// [TRC-ARC-06]
        NoSuchArc = "no-such-arc", TRC_ARC_06, "no single arc of this radius joins start and end";
        /// [TRC-WEDGE-02]
        ReversedLine = "reversed-line", TRC_WEDGE_02, "the tool would run this line backwards: the contour is narrower than the tool";
        /// [TRC-WEDGE-03]
        ReversedArc = "reversed-arc", TRC_WEDGE_03, "the tool would run this arc backwards: the contour is narrower than the tool";
        /// [TRC-START-07]
        EntryTooShort = "entry-too-short", TRC_START_07, "the entry move is not longer than the tool radius";
        /// [TRC-START-09]
        NoEntryArc = "no-entry-arc", TRC_START_09, "no arc leads from the start of the entry to its compensated end";
        /// [TRC-MODE-05]
        SameCode = "same-code", TRC_MODE_05, "compensation is on already";
        /// [TRC-MODE-08]
        PlaneChangeInMode = "plane-change-in-mode", TRC_MODE_08, "the plane changes while compensation is in force";
        /// [TRC-MODE-08]
        ReferenceReturnInMode = "reference-return-in-mode", TRC_MODE_08, "a reference return while compensation is in force";
        /// [TRC-MODE-08]
        MachineCoordinatesInMode = "machine-coordinates-in-mode", TRC_MODE_08, "machine coordinates while compensation is in force";
        /// [TRC-MODE-08]
        SetCoordinatesInMode = "set-coordinates-in-mode", TRC_MODE_08, "the coordinate system is set while compensation is in force";
        /// [TRC-MODE-08]
        ToolChangeInMode = "tool-change-in-mode", TRC_MODE_08, "a tool change while compensation is in force";
        /// [TRC-MODE-08]
        CannedCycleInMode = "canned-cycle-in-mode", TRC_MODE_08, "a canned cycle while compensation is in force";
        /// [TRC-VEC-01]
        VectorCodeOutsideMode = "vector-code-outside-mode", TRC_VEC_01, "a code for vectors stands outside compensation";
        /// [TRC-INT-03], [TRC-INT-04], [TRC-INT-05]
        Interference = "interference", TRC_INT_04, "vectors of several blocks would lead the tool backwards";
        /// [TRC-MODE-07]
        OutOfRange = "out-of-range", TRC_MODE_07, "a number in this block is not finite, beyond a million metres, or a negative radius that is not allowed";
    }
}

/// A warning to the programmer that does not stop the tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Advisory<N> {
    /// Index of the block, from 0, that it concerns.
    pub block: usize,
    /// What it warns of.
    pub kind: AdvisoryKind,
    /// How much, in millimetres; the clause says of what.
    pub amount: N,
}

kinds! {
    /// The advisories.
    AdvisoryKind {
        /// [TRC-WEDGE-01]
        FarIntersection = "far-intersection", TRC_WEDGE_01, "the intersection lies far from the corner";
        /// [TRC-WEDGE-02]
        ReversedLine = "reversed-line", TRC_WEDGE_02, "the tool runs this line backwards: the contour is narrower than the tool";
        /// [TRC-WEDGE-03]
        ReversedArc = "reversed-arc", TRC_WEDGE_03, "the tool runs this arc backwards: the contour is narrower than the tool";
        /// [TRC-LOOK-06]
        LostLookAhead = "lost-look-ahead", TRC_LOOK_06, "look-ahead was lost before this corner";
        /// [TRC-LOOK-05]
        LineInBackwards = "line-in-backwards", TRC_LOOK_05, "the tool moves back to the start of this arc and cuts into the contour before it";
        /// [TRC-DUMMY-03]
        DummyMismatch = "dummy-mismatch", TRC_DUMMY_03, "the dummy block does not point along the move that follows it";
    }
}
