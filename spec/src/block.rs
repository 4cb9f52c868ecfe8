//! Blocks as the compensation sees them: modal codes resolved, coordinates absolute, in the plane.

/// A point or a vector in the plane `(a, b)` of [TRC-PLANE-01], in millimetres.
pub type Point<N> = [N; 2];

/// One block of a program, after modal codes, units and diameters have been resolved.
///
/// `N` is the number type: exact rationals for the model, `f64` for the implementation.
#[derive(Clone, Debug, PartialEq)]
pub struct Block<N> {
    /// What the block moves in the plane.
    pub movement: Movement<N>,
    /// The block moves at rapid traverse (G00).
    pub rapid: bool,
    /// A compensation code in this block (G40 to G44 after the activation table, [TRC-PLANE-05]).
    pub compensation: Option<Compensation>,
    /// The vector that I, J, K words give beside a compensation code, incremental ([TRC-START-10], [TRC-START-11],
    /// [TRC-VEC-06], [TRC-CANCEL-08]); not in an arc, whose centre words they are.
    pub vector: Option<Point<N>>,
    /// The radius, in millimetres, that a D or T word of this block puts in force.
    pub radius: Option<N>,
    /// M96, M97, G450 or G451 in this block ([TRC-CORNER-11]).
    pub corner: Option<crate::OuterCorner>,
    /// NORM or KONT in this block ([TRC-START-12]).
    pub approach: Option<crate::Approach>,
    /// A code that stops reading ahead, where the profile says that it breaks the look-ahead ([TRC-LOOK-08]).
    pub stops_look_ahead: bool,
    /// The alarm of a code in this block that the profile does not allow in mode, if the program is in mode there: the
    /// alarm is raised at this block ([TRC-MODE-08]).
    pub not_in_mode: Option<crate::AlarmKind>,
}

impl<N> Block<N> {
    /// A block without movement and without codes.
    pub const fn empty() -> Self {
        Block::moving(Movement::None)
    }

    /// A block that only moves.
    pub const fn moving(movement: Movement<N>) -> Self {
        Block {
            movement,
            rapid: false,
            compensation: None,
            vector: None,
            radius: None,
            corner: None,
            approach: None,
            stops_look_ahead: false,
            not_in_mode: None,
        }
    }
}

/// The movement of a block in the compensation plane.
#[derive(Clone, Debug, PartialEq)]
pub enum Movement<N> {
    /// No movement in the plane: dwell, auxiliary codes, a move along the normal axis ([TRC-LOOK-01]).
    None,
    /// A straight move to an absolute end point.
    Line {
        /// End point.
        end: Point<N>,
    },
    /// A circular move to an absolute end point.
    Arc {
        /// End point; equal to the start for a full circle ([TRC-ARC-07]).
        end: Point<N>,
        /// How the centre was programmed.
        centre: Centre<N>,
        /// G02 or G03.
        direction: Direction,
    },
    /// A dummy block: a direction without a movement ([TRC-DUMMY-01]).
    Dummy {
        /// The incremental vector that its I, J, K words give.
        vector: Point<N>,
    },
    /// G38 with a straight move to an absolute end point: the vector is held ([TRC-VEC-04]).
    HeldVector {
        /// End point.
        end: Point<N>,
    },
    /// G38 with I, J, K, and what counts as it: a new vector, without a movement of the program ([TRC-VEC-05]).
    NewVector {
        /// The incremental vector at right angles to which it stands; not zero.
        vector: Point<N>,
    },
    /// G39: an arc about the corner, without a movement of the program ([TRC-VEC-02], [TRC-VEC-03]).
    CornerArc {
        /// The incremental vector at right angles to which it ends, not zero; none: the next element decides.
        vector: Option<Point<N>>,
    },
}

/// How the centre of an arc was programmed ([TRC-ARC-01]).
#[derive(Clone, Debug, PartialEq)]
pub enum Centre<N> {
    /// I, J, K: the vector from the start point to the centre.
    FromStart(Point<N>),
    /// R: the radius; positive for the arc of at most a half turn, negative for the other one.
    Radius(N),
}

/// The sense of an arc, seen from the positive end of the plane's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// G02.
    Clockwise,
    /// G03.
    Counterclockwise,
}

/// The side of the programmed path on which the tool's centre runs ([TRC-PLANE-02]).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// Left of the direction of travel (G41).
    Left,
    /// Right of the direction of travel (G42).
    Right,
}

/// What a compensation code asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Compensation {
    /// G40.
    Off,
    /// G41, G42, or another code that the profile's activation table maps to a side.
    On(Side),
}

impl Direction {
    /// The other sense.
    pub const fn reversed(self) -> Self {
        match self {
            Direction::Clockwise => Direction::Counterclockwise,
            Direction::Counterclockwise => Direction::Clockwise,
        }
    }
}

impl Side {
    /// The other side.
    pub const fn other(self) -> Self {
        match self {
            Side::Left => Side::Right,
            Side::Right => Side::Left,
        }
    }
}
