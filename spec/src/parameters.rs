//! The choices that the rules leave to a profile, enumerated.

macro_rules! choices {
    ($($(#[$doc:meta])* $type:ident { $($(#[$vdoc:meta])* $variant:ident = $id:literal,)* })*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
            pub enum $type { $($(#[$vdoc])* $variant,)* }

            impl $type {
                /// Every value, as written in profiles.
                pub const VALUES: &[(&str, $type)] = &[$(($id, $type::$variant)),*];

                /// The name written in profiles.
                pub const fn id(self) -> &'static str {
                    match self { $($type::$variant => $id,)* }
                }
            }
        )*
    };
}

choices! {
    /// The vector that start-up ends on.
    StartUp {
        /// At right angles to the next block, one straight move ([TRC-START-02]).
        TypeA = "type-a",
    }
    /// Start-up whose next element is not found within the look-ahead ([TRC-START-04]).
    StartUpLost {
        /// The block ends on its own normal.
        Normal = "normal",
        /// The block ends at its programmed end; the next moving block starts up.
        NoVector = "no-vector",
    }
    /// How compensation ends.
    Cancel {
        /// From the normal of the block before ([TRC-CANCEL-01]).
        TypeA = "type-a",
    }
    /// How an outer corner is rounded.
    OuterCorner {
        /// By intersection, squared off when acute ([TRC-CORNER-06], [TRC-CORNER-08]); M97.
        Intersection = "intersection",
        /// By an arc about the corner ([TRC-CORNER-10]); M96.
        Arc = "arc",
    }
    /// Whether M96 and M97 choose the outer corner ([TRC-CORNER-11]).
    CornerCodes {
        /// They do not: an error of the program.
        None = "none",
        /// They do.
        M96M97 = "m96-m97",
    }
    /// An exact reversal of direction ([TRC-CORNER-09]).
    Reversal {
        /// An outer corner with α = 0.
        Outer = "outer",
        /// An alarm.
        Alarm = "alarm",
    }
    /// A change of side in mode.
    SideChange {
        /// The contact point if it lies on both offset elements extended by the radius ([TRC-SIDE-02]), else the
        /// two normals ([TRC-SIDE-03]).
        IntersectionWithin = "intersection-within",
        /// Always the two normals.
        TwoNormals = "two-normals",
        /// An alarm.
        Forbidden = "forbidden",
    }
    /// A change of side in the block after start-up ([TRC-SIDE-04]).
    SideChangeAfterStartUp {
        /// An alarm.
        Alarm = "alarm",
        /// Allowed.
        Allowed = "allowed",
    }
    /// The block that a corner's moves belong to ([TRC-CORNER-12]).
    CornerOwner {
        /// The block before the corner.
        Previous = "previous",
        /// The block after the corner.
        Next = "next",
    }
    /// A tool path that runs backwards along its block ([TRC-WEDGE-02], [TRC-WEDGE-03]).
    ReversedPath {
        /// Executed, with an advisory.
        Advisory = "advisory",
        /// An alarm at the block.
        Alarm = "alarm",
    }
    /// Whether I, J, K without axis words form a dummy block ([TRC-DUMMY-01]).
    Dummy {
        /// They do not: an error.
        None = "none",
        /// They do.
        Ijk = "ijk",
    }
    /// X words, or the I word of a dummy block, as radius or diameter ([TRC-PLANE-03], [TRC-DUMMY-05]).
    Measure {
        /// A radius value.
        Radius = "radius",
        /// A diameter value, halved before geometry.
        Diameter = "diameter",
    }
    /// The plane in force when a program starts ([TRC-PLANE-01]).
    Plane {
        /// G17: (X, Y).
        Xy = "xy",
        /// G18: (Z, X).
        Zx = "zx",
        /// G19: (Y, Z).
        Yz = "yz",
    }
    /// What a code of the activation table means ([TRC-PLANE-05]).
    Activation {
        /// Compensation off.
        Cancel = "cancel",
        /// Tool left of the path.
        Left = "left",
        /// Tool right of the path.
        Right = "right",
        /// The control has the code, its source does not say what it means: a user's own profile must declare it.
        Undeclared = "undeclared",
        /// The control does not have the code for compensation.
        Absent = "absent",
    }
}

/// A non-negative rational limit, exactly as a profile writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ratio {
    /// Numerator.
    pub numerator: u32,
    /// Denominator, positive.
    pub denominator: u32,
}

/// The most blocks without movement that a profile may allow between two moves.
pub const MOST_NON_MOVING: u8 = 8;

/// The parameters that the compensation itself reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// Start-up vector.
    pub start_up: StartUp,
    /// Start-up without a next element.
    pub start_up_lost: StartUpLost,
    /// Cancel vector.
    pub cancel: Cancel,
    /// Outer corner in force when a program starts.
    pub outer_corner: OuterCorner,
    /// Exact reversal.
    pub reversal: Reversal,
    /// Side change in mode.
    pub side_change: SideChange,
    /// Side change after start-up.
    pub side_change_after_start_up: SideChangeAfterStartUp,
    /// Blocks without movement allowed between two moves, at most [`MOST_NON_MOVING`].
    pub non_moving_allowed: u8,
    /// Owner of corner moves.
    pub corner_owner: CornerOwner,
    /// Reaction to a reversed path.
    pub reversed_path: ReversedPath,
    /// Allowed difference of an arc's two radii, in millimetres.
    pub arc_end_tolerance: Ratio,
    /// An intersection farther from its corner than this many radii is advised.
    pub far_intersection: Ratio,
}
