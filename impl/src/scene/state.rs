//! What lasts from block to block, but for the look-ahead.

use radcomp_spec::Parameters;
use radcomp_spec::parameters::{Interference, NegativeRadius, ReversedPath};

use super::places;
use crate::arc_form::Tolerances;
use crate::element::Element;
use crate::engine::MOST;
use crate::interference::Row;
use crate::junction::Junction;
use crate::plane::Vector;
use crate::rules::{Rules, value};

/// How elements are looked at when both their vectors are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Look {
    /// Not at all.
    No,
    /// Each by itself. [TRC-WEDGE-02], [TRC-WEDGE-03]
    Alone,
    /// In rows. [TRC-INT-01]
    InRows,
}

/// What lasts from block to block, but for the look-ahead.
#[derive(Clone, Debug)]
pub(crate) struct State {
    /// What the profile says of junctions, and the outer corner in force. [TRC-CORNER-11]
    pub rules: Rules,
    /// What the profile says of the form of arcs.
    pub tolerances: Tolerances,
    pub(super) look: Look,
    /// The least radius that is in range, in millimetres. [TRC-MODE-07], [TRC-SIDE-07]
    pub least_radius: f64,
    /// Programmed end of the last block.
    pub position: Vector,
    /// Where the tool's centre stands at the end of what has been emitted.
    pub(super) tool: Vector,
    /// Bounds the coordinates from which moves that hold a vector have carried the tool's centre, and their rounding with
    /// it; 0: none has since it stood on a vector of its own. [TRC-VEC-04]
    pub(super) carried: f64,
    /// The magnitude of the radius that the program has put in force.
    pub radius_in_force: f64,
    /// That radius is negative. [TRC-SIDE-07]
    pub swapped: bool,
    /// The direction (unit) of the start-up block's imaginary line; zero: there is none. [TRC-START-11]
    pub(super) imaginary: Vector,
    /// The pending element, when the look-ahead has one, and the element read: they change places instead of being
    /// copied.
    pub(super) elements: [Element; 2],
    /// The junction at the start of each element. The moves of it that the element owns are part of its block, which
    /// an alarm may keep from moving; where it owns none, the junction has none any more.
    pub(super) junctions: [Junction; 2],
    /// Which of them is the pending one, 0 or 1.
    pub(super) pending: usize,
    /// What is known of the row of elements that the pending one belongs to. [TRC-INT-01]
    pub(super) row: Row,
}

impl State {
    /// The state at the start of a program.
    pub fn new(parameters: &Parameters) -> State {
        let zero = Vector::new(0.0, 0.0);
        State {
            rules: Rules::new(parameters),
            tolerances: Tolerances {
                end: value(parameters.arc_end_tolerance),
                centre: value(parameters.centre_tolerance),
                chord: value(parameters.chord_tolerance),
            },
            look: match (parameters.interference, parameters.reversed_path) {
                (Interference::Off, ReversedPath::Alarm) => Look::Alone,
                (Interference::Off, ReversedPath::Advisory) => Look::No,
                _ => Look::InRows,
            },
            least_radius: if parameters.negative_radius == NegativeRadius::SwapsSides { -MOST } else { 0.0 },
            position: zero,
            tool: zero,
            carried: 0.0,
            radius_in_force: 0.0,
            swapped: false,
            imaginary: zero,
            elements: [Element::unused(); 2],
            junctions: [Junction::unused(); 2],
            pending: 0,
            row: Row::new(parameters),
        }
    }

    /// The element read. It is put there as soon as its form has been found sound.
    #[inline(always)]
    pub fn next(&mut self) -> &mut Element {
        let (_, next) = places(self.pending);
        &mut self.elements[next]
    }
}
