//! Decisions in words.

use core::cmp::Ordering::{Equal, Greater, Less};

use radcomp_model::Decision;
use radcomp_spec::DecisionKind;

/// What is known of a corner beside its decisions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Corner {
    /// The angle by which the path turns, in degrees, for the words only.
    pub turn: Option<f64>,
    /// The side changes there, so that the turn does not tell inner from outer corners ([TRC-SIDE-01]).
    pub side_change: bool,
    /// It is decided already that the two tangents are parallel.
    pub parallel: bool,
}

/// What a decision says, for a person; none for one that only says that all is as it should be.
pub fn in_words(decision: &Decision, corner: Corner) -> Option<String> {
    let by = corner.turn.map_or(String::new(), |turn| format!(" by {}", angle(turn.abs())));
    let words = match (decision.kind, decision.exact) {
        (DecisionKind::Moves, Equal) => "no length: the block does not move".to_owned(),
        (DecisionKind::Moves, _) => return None,
        (DecisionKind::CentreDistance, Greater) => return None,
        (DecisionKind::CentreDistance, _) => "the centre of the arc counts as its start or its end".to_owned(),
        (DecisionKind::ChordFits, Greater) => return None,
        (DecisionKind::ChordFits, Equal) => "half the chord is the longest that R lets pass: a half turn".to_owned(),
        (DecisionKind::ChordFits, Less) => "R is too small for half the chord: there is no such arc".to_owned(),
        (DecisionKind::HalfTurn, Less) => "R is a little less than half the chord: a half turn".to_owned(),
        (DecisionKind::HalfTurn, _) => return None,
        (DecisionKind::EndOnArc, Greater) => return None,
        (DecisionKind::EndOnArc, Equal) => "the two radii differ by exactly the tolerance".to_owned(),
        (DecisionKind::EndOnArc, Less) => "the two radii differ by more than the tolerance".to_owned(),
        (DecisionKind::WholeTurn, Equal) => "the tool runs the full circle whole".to_owned(),
        (DecisionKind::WholeTurn, _) => "the tool does not start and end at the full circle's own normal".to_owned(),
        (DecisionKind::ToolFitsArc, Greater) => "the tool fits inside the arc".to_owned(),
        (DecisionKind::ToolFitsArc, _) => "the tool does not fit inside the arc".to_owned(),
        (DecisionKind::CentresApart, Greater) => return None,
        (DecisionKind::CentresApart, _) => "the two arcs have one centre: their offsets do not meet".to_owned(),
        (DecisionKind::Turn, Equal) if corner.side_change => {
            "the two lines are parallel: no point touches both".to_owned()
        }
        // The decision on the right angle, which follows, tells which way.
        (DecisionKind::Turn, Equal) => return None,
        (DecisionKind::Turn, _) if corner.side_change => format!("the path turns{by} where the side changes"),
        (DecisionKind::Turn, Greater) => format!("inner corner: the path turns{by} to the tool's side"),
        (DecisionKind::Turn, Less) => format!("outer corner: the path turns{by} away from the tool's side"),
        (DecisionKind::RightAngle, Greater) if corner.parallel => "tangent: the path goes straight on".to_owned(),
        (DecisionKind::RightAngle, _) if corner.parallel => "straight back: an exact reversal".to_owned(),
        (DecisionKind::RightAngle, Greater) => "it turns by less than 90°".to_owned(),
        (DecisionKind::RightAngle, Equal) => "it turns by exactly 90°, so the corner counts as obtuse".to_owned(),
        (DecisionKind::RightAngle, Less) => "it turns by more than 90°: an acute corner".to_owned(),
        (DecisionKind::OffsetsMeet, Greater) => "the two offset contours cross".to_owned(),
        (DecisionKind::OffsetsMeet, Equal) => "the two offset contours touch in one point".to_owned(),
        (DecisionKind::OffsetsMeet, Less) => "the two offset contours do not meet".to_owned(),
        (DecisionKind::ContactExists, Greater) => "the offset contours of the two sides cross".to_owned(),
        (DecisionKind::ContactExists, Equal) => "the offset contours of the two sides touch".to_owned(),
        (DecisionKind::ContactExists, Less) => "the offset contours of the two sides do not meet".to_owned(),
        (DecisionKind::ContactWithin, Less) => {
            "their common point lies farther than a radius from the block".to_owned()
        }
        (DecisionKind::ContactWithin, _) => "their common point lies within a radius of the block".to_owned(),
        (DecisionKind::NearerContact, Equal) => "both common points are equally near: neither counts".to_owned(),
        (DecisionKind::NearerContact, _) => "of two common points the nearer one counts".to_owned(),
        (DecisionKind::EntryLength, Greater) => return None,
        (DecisionKind::EntryLength, Equal) => "the entry move is exactly as long as the tool radius".to_owned(),
        (DecisionKind::EntryLength, Less) => "the entry move is shorter than the tool radius".to_owned(),
        (DecisionKind::EntryArc, Greater) => return None,
        (DecisionKind::EntryArc, _) => "no arc leads from the entry's start to its end".to_owned(),
        (DecisionKind::ImaginaryLineMet, Greater) => "the offset contour crosses that of the imaginary line".to_owned(),
        (DecisionKind::ImaginaryLineMet, Equal) => "the offset contour touches that of the imaginary line".to_owned(),
        (DecisionKind::ImaginaryLineMet, Less) => {
            "the offset contour does not reach that of the imaginary line".to_owned()
        }
        (DecisionKind::SmallestCorner, Less) => "it is below the smallest corner: a single vector".to_owned(),
        (DecisionKind::SmallestCorner, _) => "it is not below the smallest corner".to_owned(),
        (DecisionKind::LimitAngle, Less) => "it is below the limit angle: an arc".to_owned(),
        (DecisionKind::LimitAngle, _) => "it is not below the limit angle: an intersection".to_owned(),
        (DecisionKind::ExtensionsMeet, Greater) => "the two extended offset contours cross".to_owned(),
        (DecisionKind::ExtensionsMeet, Equal) => "the two extended offset contours touch in one point".to_owned(),
        (DecisionKind::ExtensionsMeet, Less) => "the two extended offset contours do not meet".to_owned(),
        (DecisionKind::StraightBand, Less) => "it turns by more than what counts as straight".to_owned(),
        (DecisionKind::StraightBand, _) => "it counts as straight".to_owned(),
        (DecisionKind::SmallVector, Greater) => "the vector is kept".to_owned(),
        (DecisionKind::SmallVector, _) => "the vector differs too little from the one before: it is dropped".to_owned(),
        (DecisionKind::LineForward, Greater) => return None,
        (DecisionKind::LineForward, Equal) => "the tool's centre stands still along this line".to_owned(),
        (DecisionKind::LineForward, Less) => "the tool's centre would run this line backwards".to_owned(),
        (DecisionKind::ArcForward, Less) => "the tool's centre would run this arc backwards".to_owned(),
        (DecisionKind::ArcForward, _) => return None,
        (DecisionKind::LineInForward, Less) => "the straight move to the arc's start runs against the arc".to_owned(),
        (DecisionKind::LineInForward, _) => return None,
        (DecisionKind::NearCorner, Less) => "the intersection lies far from the corner".to_owned(),
        (DecisionKind::NearCorner, _) => return None,
    };
    Some(words)
}

/// An angle in degrees, for the words only.
fn angle(degrees: f64) -> String {
    let rounded = (degrees * 1e4).round() / 1e4;
    // What is not quite a right angle does not pass for one.
    let nearly = rounded % 45.0 == 0.0 && (degrees - rounded).abs() > 1e-9;
    format!("{}{rounded}°", if nearly { "nearly " } else { "" })
}
