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
        /// As type A at an inner corner, over the corner at an outer one ([TRC-START-06]).
        TypeB = "type-b",
        /// At right angles to the start-up block itself, then an ordinary corner ([TRC-START-07]).
        EntryNormal = "entry-normal",
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
        /// As type A at an inner corner, over the corner at an outer one ([TRC-CANCEL-05]).
        TypeB = "type-b",
    }
    /// How an outer corner is rounded.
    OuterCorner {
        /// By intersection, squared off when acute ([TRC-CORNER-06], [TRC-CORNER-08]); M97.
        Intersection = "intersection",
        /// By an arc about the corner ([TRC-CORNER-10]); M96, G450.
        Arc = "arc",
        /// By intersection down to a limit angle, by an arc below it ([TRC-CORNER-13]); G451.
        LimitAngle = "limit-angle",
    }
    /// Codes that choose start-up and cancel ([TRC-START-12]).
    ApproachCodes {
        /// The control has none.
        None = "none",
        /// NORM: type A. KONT: type B.
        NormKont = "norm-kont",
    }
    /// Start-up and cancel as a code chooses them ([TRC-START-12]).
    Approach {
        /// NORM: type A.
        Norm = "norm",
        /// KONT: type B.
        Kont = "kont",
    }
    /// Whether codes choose the outer corner ([TRC-CORNER-11]).
    CornerCodes {
        /// None do: they are errors of the program.
        None = "none",
        /// M96 an arc, M97 intersection.
        M96M97 = "m96-m97",
        /// G450 an arc, G451 intersection down to the limit angle.
        G450G451 = "g450-g451",
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
        /// The contact point wherever it lies ([TRC-SIDE-05]), else the two normals.
        Intersection = "intersection",
        /// Over the whole of the block with the new side ([TRC-SIDE-06]).
        Crossing = "crossing",
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
    /// Whether there are G38 and G39 ([TRC-VEC-01]).
    VectorCodes {
        /// They are errors of the program.
        None = "none",
        /// G38 holds a vector or gives a new one, G39 makes a corner arc.
        G38G39 = "g38-g39",
    }
    /// I, J, K beside G41 or G42.
    SideCodeVector {
        /// The program reader refuses them.
        Refused = "refused",
        /// The block ends at right angles to them ([TRC-START-10], [TRC-VEC-06]).
        RightAngles = "right-angles",
        /// An imaginary line before the contour, along which they point to the end of the start-up block
        /// ([TRC-START-11]).
        ImaginaryLine = "imaginary-line",
        /// The same line, given by a point of it, seen from that end ([TRC-START-11]).
        ImaginaryPoint = "imaginary-point",
    }
    /// I, J, K beside G40 ([TRC-CANCEL-08]).
    CancelVector {
        /// The program reader refuses them.
        Refused = "refused",
        /// An imaginary line behind the contour.
        ImaginaryLine = "imaginary-line",
    }
    /// A block that puts a radius of another magnitude in force in mode.
    OffsetChange {
        /// An alarm ([TRC-MODE-03]).
        Alarm = "alarm",
        /// Each block ends with its own value ([TRC-MODE-11]).
        EndOfBlock = "end-of-block",
    }
    /// What start-up and cancel of type B pass besides the corner ([TRC-START-06], [TRC-CANCEL-05]).
    StartUpB {
        /// The normal of the start-up or cancel block too.
        ViaNormal = "via-normal",
        /// The corner alone.
        Direct = "direct",
    }
    /// A start-up code in a block without movement ([TRC-START-08]).
    StartUpWithoutMovement {
        /// It acts on the next block that moves ([TRC-MODE-02]).
        None = "none",
        /// The tool moves to the normal of the next element at once; type C.
        Shift = "shift",
    }
    /// An arc as start-up block.
    StartUpArc {
        /// An alarm ([TRC-START-03]).
        Alarm = "alarm",
        /// Run about a moved centre ([TRC-START-09]).
        MovedCentre = "moved-centre",
    }
    /// G40 in a block without movement.
    CancelWithoutMovement {
        /// The next block that moves is the cancel block ([TRC-CANCEL-03]).
        None = "none",
        /// The tool moves to the programmed point at once; type C ([TRC-CANCEL-06]).
        Shift = "shift",
    }
    /// Offset number 0 ([TRC-CANCEL-07]).
    OffsetZero {
        /// Compensation is off while it is in force.
        Cancel = "cancel",
        /// The program reader refuses it while compensation is in force.
        Refused = "refused",
    }
    /// What stands for an arc beyond its end, at an outer corner formed by intersection.
    ArcExtension {
        /// Its tangent ([TRC-CORNER-06], [TRC-CORNER-07]).
        Tangent = "tangent",
        /// Its own circle ([TRC-CORNER-14]).
        Curve = "curve",
    }
    /// An outer corner by an arc that a rapid block owns ([TRC-CORNER-17]).
    ArcOnRapid {
        /// The arc.
        Arc = "arc",
        /// Its chord.
        Line = "line",
    }
    /// The code of the side in force, given again ([TRC-MODE-05]).
    SameCode {
        /// No effect.
        Ordinary = "ordinary",
        /// The block before ends on its normal.
        Normal = "normal",
        /// An alarm.
        Alarm = "alarm",
    }
    /// The block that waits for its end when an alarm is raised ([TRC-MODE-10]).
    PendingAtAlarm {
        /// It ends on its normal.
        Ended = "ended",
        /// It is lost.
        Lost = "lost",
    }
    /// A negative tool radius ([TRC-SIDE-07]).
    NegativeRadius {
        /// The sides are exchanged.
        SwapsSides = "swaps-sides",
        /// An alarm ([TRC-MODE-07]).
        Alarm = "alarm",
    }
    /// An arc with the tool inside and exactly its radius ([TRC-ARC-08]).
    EqualRadius {
        /// An alarm ([TRC-ARC-05]).
        Alarm = "alarm",
        /// The tool stands at the centre of the arc.
        DegeneratePoint = "degenerate-point",
    }
    /// A straight move of length zero in mode ([TRC-LOOK-07]).
    ZeroLengthMove {
        /// One of the blocks without movement.
        NoMovement = "no-movement",
        /// Look-ahead is lost there.
        BreaksLookAhead = "breaks-look-ahead",
        /// A block that moves where it starts or cancels, else one of the blocks without movement.
        StartsAndCancels = "starts-and-cancels",
    }
    /// What several blocks together are looked at for ([TRC-INT-01]).
    Interference {
        /// Nothing: [TRC-WEDGE-02] and [TRC-WEDGE-03] alone.
        Off = "off",
        /// Vectors of one block that interfere are removed in pairs ([TRC-INT-03]).
        RemoveVectors = "remove-vectors",
        /// Vectors of several blocks that interfere raise an alarm ([TRC-INT-04]).
        Alarm = "alarm",
        /// Blocks whose vectors interfere are left out ([TRC-INT-05]).
        Avoid = "avoid",
    }
    /// How many blocks that move are read together, the first and the last included ([TRC-INT-04]).
    InterferenceBlocks {
        /// Three.
        Three = "3",
        /// Four.
        Four = "4",
        /// Five.
        Five = "5",
        /// Six.
        Six = "6",
        /// Seven.
        Seven = "7",
        /// Eight.
        Eight = "8",
    }
    /// Whether vectors interfere that lead the tool neither forward nor back ([TRC-INT-02]).
    InterferenceBoundary {
        /// They do not.
        Strict = "strict",
        /// They do.
        Inclusive = "inclusive",
    }
    /// M00, M01, M02 and M30 in mode ([TRC-LOOK-08]).
    ReadAheadStop {
        /// Blocks without movement.
        NoMovement = "no-movement",
        /// Look-ahead is lost there.
        BreaksLookAhead = "breaks-look-ahead",
    }
    /// A code in mode ([TRC-MODE-08]).
    InMode {
        /// An alarm at its block.
        Alarm = "alarm",
        /// The program reader refuses it, by name.
        Unsupported = "unsupported",
    }
    /// A tool change in mode ([TRC-MODE-08]).
    ToolChange {
        /// A block without movement.
        NoMovement = "no-movement",
        /// An alarm at its block.
        Alarm = "alarm",
        /// The program reader refuses it, by name.
        Unsupported = "unsupported",
    }
    /// Where the imaginary tool tip stands, seen from the nose centre, in radii along the plane's axes ([TRC-TIP-01]).
    Tip {
        /// The centre itself.
        Centre = "0 0",
        /// The corner at greater a and b.
        PlusPlus = "+1 +1",
        /// The corner at smaller a and greater b.
        MinusPlus = "-1 +1",
        /// The corner at smaller a and b.
        MinusMinus = "-1 -1",
        /// The corner at greater a and smaller b.
        PlusMinus = "+1 -1",
        /// Beside the centre at greater a.
        Plus = "+1 0",
        /// Beside the centre at smaller a.
        Minus = "-1 0",
        /// Beside the centre at greater b.
        UpPlus = "0 +1",
        /// Beside the centre at smaller b.
        UpMinus = "0 -1",
        /// The control has no such orientation.
        Absent = "absent",
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
    /// Blocks without movement allowed between two moves, at most [`MOST_NON_MOVING`]; none: any number.
    pub non_moving_allowed: Option<u8>,
    /// Owner of corner moves.
    pub corner_owner: CornerOwner,
    /// Reaction to a reversed path.
    pub reversed_path: ReversedPath,
    /// Allowed difference of an arc's two radii, in millimetres.
    pub arc_end_tolerance: Ratio,
    /// An intersection farther from its corner than this many radii is advised.
    pub far_intersection: Ratio,
    /// What type B passes besides the corner.
    pub start_up_b: StartUpB,
    /// A start-up code in a block without movement.
    pub start_up_without_movement: StartUpWithoutMovement,
    /// An arc as start-up block.
    pub start_up_arc: StartUpArc,
    /// G40 in a block without movement.
    pub cancel_without_movement: CancelWithoutMovement,
    /// Cosine of the limit angle of outer corners by intersection, from 0 to 1.
    pub corner_limit_cosine: Ratio,
    /// What stands for an arc beyond its end.
    pub arc_extension: ArcExtension,
    /// Cosine of the angle below which type B passes a single vector; 0: no such angle.
    pub smallest_corner_cosine: Ratio,
    /// Cosine of the turn up to which a corner counts as straight; 0: no such turn.
    pub straight_band_cosine: Ratio,
    /// Corner arcs owned by rapid blocks.
    pub arc_on_rapid: ArcOnRapid,
    /// Vectors of one corner that differ by no more than this in each coordinate are one, in millimetres; 0: none are.
    pub small_vector_limit: Ratio,
    /// The same code again.
    pub same_code: SameCode,
    /// A negative tool radius.
    pub negative_radius: NegativeRadius,
    /// An arc whose radius is the tool's.
    pub equal_radius: EqualRadius,
    /// A straight move of length zero.
    pub zero_length_move: ZeroLengthMove,
    /// The block that waits for its end when an alarm is raised.
    pub pending_at_alarm: PendingAtAlarm,
    /// I, J, K beside G41 or G42.
    pub side_code_vector: SideCodeVector,
    /// I, J, K beside G40.
    pub cancel_vector: CancelVector,
    /// A change of the offset value in mode.
    pub offset_change: OffsetChange,
    /// By how much half a chord may exceed the radius of its arc, in millimetres.
    pub chord_tolerance: Ratio,
    /// How far from an end a centre counts as lying there, in millimetres.
    pub centre_tolerance: Ratio,
    /// What several blocks together are looked at for.
    pub interference: Interference,
    /// How many blocks that move are read together.
    pub interference_blocks: InterferenceBlocks,
    /// Whether vectors interfere that lead the tool neither forward nor back.
    pub interference_boundary: InterferenceBoundary,
}

impl Parameters {
    /// Start-up and cancel as NORM or KONT chooses them ([TRC-START-12]).
    pub fn approach(&mut self, approach: Approach) {
        (self.start_up, self.cancel) = match approach {
            Approach::Norm => (StartUp::TypeA, Cancel::TypeA),
            Approach::Kont => (StartUp::TypeB, Cancel::TypeB),
        };
    }
}
