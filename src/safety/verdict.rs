//! What the safety verdict says.

/// The verdict on one path. See [`crate::safety`] for the definitions.
#[derive(Clone, Debug, PartialEq)]
pub struct SafetyVerdict {
    /// The path in offset mode.
    pub path: Finding,
    /// The moves of start-up blocks, which the program, not the control, leads to the contour.
    pub start_up: Finding,
    /// The moves of cancel blocks.
    pub cancel: Finding,
    /// The longest part of the contour that was left uncut although the tool has room there.
    pub uncut: Option<Uncut>,
    /// Moves that were not judged, since they lead the tool over the point where the side changes.
    pub crossings: usize,
}

impl SafetyVerdict {
    /// Whether the path in offset mode is proved not to gouge.
    pub fn is_safe(&self) -> bool {
        matches!(self.path, Finding::Safe { .. })
    }

    /// The worst gouge of the path in offset mode, if it is proved to gouge.
    pub fn gouge(&self) -> Option<&Gouge> {
        match &self.path {
            Finding::Gouges(gouge) => Some(gouge),
            _ => None,
        }
    }
}

/// What is proved of some moves.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// No point of these moves lets the tool enter the part by more than the budget.
    Safe {
        /// Proved upper bound of the depth, in millimetres; below 0 if the tool keeps clear, and `-∞` without moves.
        at_most: f64,
    },
    /// The tool enters the part by more than the budget: the worst place.
    Gouges(Gouge),
    /// Neither is proved: the depth lies between the two ends, and the budget too.
    Undecided(Gouge),
    /// The path holds a number that is not finite or beyond 10¹² mm, first in this block.
    OutOfRange {
        /// Index of the block.
        block: usize,
    },
}

/// The place where the tool enters the part deepest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gouge {
    /// Proved bounds of the greatest depth, in millimetres: at least and at most.
    pub depth: (f64, f64),
    /// Where the tool's centre stands, to within rounding.
    pub centre: [f64; 2],
    /// The nearest point of the contour, to within rounding.
    pub contour: [f64; 2],
    /// Index of the block of the path element.
    pub path_block: usize,
    /// Index of the block of the contour element.
    pub contour_block: usize,
}

/// A part of a contour element that no position of the tool reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncut {
    /// Its length along the element, in millimetres.
    pub length: f64,
    /// Where it starts, in the direction of travel.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// Index of the block of the contour element.
    pub contour_block: usize,
    /// How far the tool kept from its middle at least, beyond its radius, in millimetres.
    pub thickness: f64,
}
