//! Boundary synthesis: for every decision, programs that lie exactly on it.
//!
//! The coordinates are plain decimals: directions are Pythagorean, half-angle tangents rational, arcs tangent or
//! concentric, tools fit exactly. A contour is made in rational numbers of any unit, turned, mirrored, run backwards, its
//! arcs written with R now and then, and scaled until every number is a whole number of thousandths of a millimetre. Its
//! neighbours have one point or one radius of the contour moved by one least increment, 0.001 mm, to either side.
//!
//! Two more neighbours have it moved by the least power of ten that is 64 bands of `binary64` and moves the margin out of
//! the band (`beside.rs`). A device that compares
//! with a tolerance of its own takes their decisions as it takes the one on the boundary, which is wrong on one side. Some
//! of the contours that have them are a thousand times as large or as small, in whole millimetres or millionths: a tolerance
//! that is made of a product of two lengths instead of their sum is the right one at no size but one.
//!
//! One seed gives the same programs on every machine, each triple independent of the others.
//!
//! Some boundaries have no such programs, or only one side:
//!
//! * a margin that is a distance is positive to either side of zero: `moves`, `centre-distance`, `centres-apart`,
//!   `whole-turn` and `interference-apart`;
//! * `whole-turn`: only circles tangent to both neighbours lie on it, at an outer corner the tool passes the circle's own
//!   normal whatever the angle;
//! * `offsets-meet` and `contact-exists`: a line and an arc with the tool outside it, and two arcs with the tool outside
//!   or inside both, touch from inside at tangents and cusps alone, where the two radii and the distance of the centres grow
//!   together: the margin is zero at every tool radius and turns negative at none;
//! * `near-corner`: at a limit of five radii no corner with a line lies on it, because √24 is no ratio of decimals
//!   (`wedge.rs` proves it); two arcs do;
//! * `end-on-arc`, `centre-distance` and `chord-fits`: a tolerance that is no whole number of thousandths has no programs
//!   in whole thousandths (`asked.rs`);
//! * `smallest-corner`, `limit-angle` and `straight-band`: where √(1 - L²) is irrational, no two decimal vectors stand at
//!   an angle of cosine L (`asked.rs`), as with the limits of the built-in profiles but 90°;
//! * `right-angle` asks nothing where outer corners are no intersections, `line-in-forward` where nothing loses the
//!   look-ahead, and the contacts of a change of side where there is no such change;
//! * `imaginary-line-met`: where it stands before the contour, at start-up, generated programs alone come to it;
//! * `arc-interference` where more than three blocks are read together: vectors farther apart may interfere first;
//! * `interference-apart`: three lines close where five blocks are read together, an arc and a line with four; generated
//!   programs alone do that;
//! * `entry-arc`: with the tool outside an arc no start lies on it;
//! * `nearer-contact` with a line asks for a tool of at least four times the arc's radius.

mod arm;
mod asked;
mod beside;
mod choice;
mod contact;
mod corner;
mod entry;
mod figure;
mod interference;
mod limit;
mod meet;
mod place;
mod point;
mod program;
mod wedge;
mod words;

use radcomp_spec::{Block, DecisionKind};
use rug::Rational;

use crate::generate::Reach;
pub use asked::is_asked;
use choice::Choice;
use figure::Figure;
use place::Size;
use program::Ends;

/// A program exactly on a decision, between its two neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple {
    /// The decision.
    pub kind: DecisionKind,
    /// The family of contours, for reports.
    pub family: &'static str,
    /// Whether the margin has two signs. A margin that is a distance is positive to either side of zero.
    pub two_sided: bool,
    /// One least increment toward a smaller margin, on the decision, and one toward a greater margin.
    pub programs: [Vec<Block<Rational>>; 3],
    /// As near to the decision as the band of `binary64` allows, toward a smaller and a greater margin: with more decimals
    /// than a control's increment has. None unless asked for, and where f64 has hardly a digit left for δ, as where the path
    /// leads kilometres off beside a reversal or an entry arc of no curvature.
    pub beside: Option<[Vec<Block<Rational>>; 2]>,
}

impl Triple {
    /// What the programs are called in reports, in their order.
    pub const NAMES: [&'static str; 3] = ["-1", "0", "+1"];
    /// What the programs beside it are called.
    pub const BESIDE: [&'static str; 2] = ["-ε", "+ε"];
}

/// How often a contour is drawn until one can be written in thousandths of a millimetre.
const MOST_DRAWS: usize = 400;

/// The triple with this number for a decision, in the sequence of a seed: the program in the middle takes the decision
/// with margin zero. None for a decision that [`is_asked`] rules out, and if no contour was found within a bounded number
/// of draws.
pub fn triples(kind: DecisionKind, seed: u64, number: u64, reach: Reach) -> Option<Triple> {
    drawn(kind, seed, number, reach, false)
}

/// The same triple, with the programs beside it, which takes two runs of the model.
pub fn with_beside(kind: DecisionKind, seed: u64, number: u64, reach: Reach) -> Option<Triple> {
    drawn(kind, seed, number, reach, true)
}

fn drawn(kind: DecisionKind, seed: u64, number: u64, reach: Reach, with_beside: bool) -> Option<Triple> {
    if !is_asked(kind, reach) {
        return None;
    }
    let mut choice = Choice::new(seed, kind as u64, number);
    let sizes = sizes(with_beside, reach);
    let figure = (0..MOST_DRAWS).find_map(|_| {
        let figure = figure(kind, &mut choice, reach)?;
        // A corner that counts as straight is not formed, whatever it was to decide ([TRC-CORNER-16]).
        let formed = kind == DecisionKind::StraightBand || !program::has_straight_corner(&figure, reach);
        formed.then(|| place::place(figure, sizes, &mut choice)).flatten()
    })?;
    let mut off = || [choice.between(-8, 8) * 1000 + 500, choice.between(-8, 8) * 1000 + 500];
    let ends = Ends { approach: off(), away: off(), code_apart: choice.below(3) == 0 };
    let at = |steps: Rational| program::program(&place::neighbour(&figure, &steps), &ends, reach);
    let programs = [-1, 0, 1].map(|steps| at(Rational::from(steps) * &figure.increment));
    let beside = with_beside.then(|| beside::beside(kind, &programs[1], at, &figure.increment, reach)).flatten();
    Some(Triple { kind, family: figure.family, two_sided: figure.two_sided, programs, beside })
}

/// The sizes of contours: without the programs beside them, those that machines reach; and where the profile's own lengths
/// leave a contour as it is, fine ones.
fn sizes(with_beside: bool, reach: Reach) -> &'static [Size] {
    let parameters = reach.parameters();
    let lengths = parameters.centre_tolerance.numerator > 0 || parameters.small_vector_limit.numerator > 0;
    match (with_beside, lengths) {
        (false, _) => &[Size::Common],
        (true, true) => &[Size::Common, Size::Common, Size::Common, Size::Vast],
        (true, false) => &[Size::Common, Size::Common, Size::Common, Size::Vast, Size::Fine],
    }
}

/// The first `count_per_kind` triples of every decision, with the programs beside them.
pub fn all(seed: u64, count_per_kind: u64, reach: Reach) -> impl Iterator<Item = Triple> {
    DecisionKind::ALL
        .iter()
        .flat_map(move |kind| (0..count_per_kind).filter_map(move |number| with_beside(*kind, seed, number, reach)))
}

fn figure(kind: DecisionKind, choice: &mut Choice, reach: Reach) -> Option<Figure> {
    match kind {
        DecisionKind::Moves => words::moves(choice),
        DecisionKind::CentreDistance => words::centre_distance(choice, reach),
        DecisionKind::ChordFits => words::chord_fits(choice, reach),
        DecisionKind::HalfTurn => words::half_turn(choice),
        DecisionKind::EndOnArc => words::end_on_arc(choice, reach),
        DecisionKind::WholeTurn => corner::whole_turn(choice),
        DecisionKind::ToolFitsArc => words::tool_fits(choice),
        DecisionKind::CentresApart => contact::centres_apart(choice),
        DecisionKind::Turn => corner::turn(choice, reach),
        DecisionKind::RightAngle => corner::right_angle(choice, reach),
        DecisionKind::OffsetsMeet => meet::offsets_meet(choice),
        DecisionKind::ContactExists => meet::contact_exists(choice),
        DecisionKind::ContactWithin => contact::contact_within(choice),
        DecisionKind::NearerContact => contact::nearer_contact(choice),
        DecisionKind::EntryLength => entry::entry_length(choice, reach),
        DecisionKind::EntryArc => entry::entry_arc(choice),
        DecisionKind::ImaginaryLineMet => meet::imaginary_line_met(choice),
        DecisionKind::SmallestCorner => limit::smallest_corner(choice, reach),
        DecisionKind::LimitAngle => limit::limit_angle(choice, reach),
        DecisionKind::ExtensionsMeet => meet::extensions_meet(choice),
        DecisionKind::StraightBand => limit::straight_band(choice, reach),
        DecisionKind::SmallVector => limit::small_vector(choice, reach),
        DecisionKind::LineInterference if asked::compares_far_vectors(reach) => interference::groove(choice),
        DecisionKind::LineForward | DecisionKind::LineInterference => wedge::line_forward(choice),
        DecisionKind::ArcForward | DecisionKind::ArcInterference => wedge::arc_forward(choice),
        DecisionKind::InterferenceApart => interference::apart(choice),
        DecisionKind::AvoidanceTurn => interference::turn(choice),
        DecisionKind::AvoidanceParallel => interference::parallel(choice),
        DecisionKind::AvoidanceMeets => interference::meets(choice),
        DecisionKind::NearerAvoidance => interference::nearer(choice),
        DecisionKind::LineInForward => corner::line_in(choice, reach),
        DecisionKind::NearCorner => wedge::near_corner(choice),
    }
}
