//! The form of arcs: `spec/clauses/09-arc.md`.

use core::cmp::Ordering;

use radcomp_spec::parameters::{EqualRadius, Parameters};
use radcomp_spec::{AlarmKind, Centre, DecisionKind, Direction, Side};
use rug::Rational;

use super::mode;
use crate::decision::Judgement;
use crate::element::{Element, Shape, tool_inside};
use crate::geometry::{Vector, larger, smaller};
use crate::number::Real;

/// What an arc block says.
pub(crate) struct Words {
    end: Vector,
    centre: Place,
    sense: Direction,
}

/// How it gives the centre.
enum Place {
    FromStart(Vector),
    Radius(Real),
}

impl Words {
    pub(crate) fn read(
        end: &[Rational; 2],
        centre: &Centre<Rational>,
        sense: Direction,
        number: fn(&Rational) -> Real,
    ) -> Self {
        let centre = match centre {
            Centre::FromStart(vector) => Place::FromStart(Vector::read(vector, number)),
            Centre::Radius(radius) => Place::Radius(number(radius)),
        };
        Words { end: Vector::read(end, number), centre, sense }
    }
}

/// The arc that a block programs, or the alarm of its form.
pub(crate) fn programmed(
    start: &Vector,
    words: Words,
    parameters: &Parameters,
    judgement: &mut Judgement<'_>,
) -> Result<Element, AlarmKind> {
    let Words { end, centre, sense } = words;
    let chord = end.minus(start);
    let (centre, start_radius, end_radius) = match centre {
        Place::Radius(word) => {
            let (centre, radius) = from_radius(start, &chord, &word, sense, parameters, judgement)?;
            (centre, radius.clone(), radius)
        }
        Place::FromStart(vector) => {
            let centre = start.plus(&vector);
            let (to_start, to_end) = (start.minus(&centre), end.minus(&centre));
            let (at_start, at_end) = (to_start.length_squared(), to_end.length_squared());
            let start_radius = at_start.sqrt_or_zero();
            let end_radius = if at_start == at_end { start_radius.clone() } else { at_end.sqrt_or_zero() };
            (centre, start_radius, end_radius)
        }
    };
    // [TRC-ARC-02]
    let apart = smaller(start_radius.clone(), end_radius.clone()) - mode::ratio(parameters.centre_tolerance);
    if judgement.decide(DecisionKind::CentreDistance, &apart, apart.clone()) != Ordering::Greater {
        return Err(AlarmKind::CentreAtEnd);
    }
    // [TRC-ARC-03]
    let spare = mode::ratio(parameters.arc_end_tolerance) - (&start_radius - &end_radius).abs();
    if judgement.decide(DecisionKind::EndOnArc, &spare, spare.clone()) == Ordering::Less {
        return Err(AlarmKind::EndOffArc);
    }
    // [TRC-ARC-07]
    let full = chord.is_zero();
    Ok(Element {
        start: start.clone(),
        end,
        shape: Shape::Arc { centre, sense, start_radius, end_radius, full, entry: None },
    })
}

/// Centre and radius of an arc with R: [TRC-ARC-01] `m + s·√(R² - q²/4)·perp(w)`, and [TRC-ARC-06].
fn from_radius(
    start: &Vector,
    chord: &Vector,
    word: &Real,
    sense: Direction,
    parameters: &Parameters,
    judgement: &mut Judgement<'_>,
) -> Result<(Vector, Real), AlarmKind> {
    let half = Real::one().checked_div(&Real::integer(2)).unwrap_or_else(Real::zero);
    let chord_squared = chord.length_squared();
    let length = chord_squared.sqrt_or_zero();
    if judgement.decide(DecisionKind::Moves, &chord_squared, length.clone()) != Ordering::Greater {
        return Err(AlarmKind::NoSuchArc);
    }
    let (radius, half_chord) = (word.abs(), &length * &half);
    let half_chord_squared = &chord_squared * &half.square();
    let longest = &radius + mode::ratio(parameters.chord_tolerance);
    let margin = &longest - &half_chord;
    if judgement.decide(DecisionKind::ChordFits, &(longest.square() - &half_chord_squared), margin) == Ordering::Less {
        return Err(AlarmKind::NoSuchArc);
    }
    let height_squared = radius.square() - &half_chord_squared;
    let middle = start.along(chord, &half);
    // Without a tolerance no half chord that is longer comes here.
    if parameters.chord_tolerance.numerator > 0
        && judgement.decide(DecisionKind::HalfTurn, &height_squared, &radius - &half_chord) == Ordering::Less
    {
        return Ok((middle, half_chord));
    }
    // √(R² - q²/4) / q, so that the chord need not be made a unit vector.
    let height = height_squared.checked_div(&chord_squared).map_or_else(Real::zero, |ratio| ratio.sqrt_or_zero());
    let left = (word.sign() != Ordering::Less) == (sense == Direction::Counterclockwise);
    let height = if left { height } else { -height };
    Ok((middle.along(&chord.perp(), &height), radius))
}

/// [TRC-ARC-07] whether the tool runs a full circle whole: it starts and ends at the circle's own normal.
pub(crate) fn whole_turn(
    element: &Element,
    side: Side,
    radius: &Real,
    (start, end): (&Vector, &Vector),
    judgement: &mut Judgement<'_>,
) -> bool {
    let Shape::Arc { full: true, .. } = element.shape else { return false };
    let from_normal = |at: &Vector, normal: Vector| at.minus(&normal).length();
    let off = larger(
        &from_normal(start, element.first_arm().normal(side, radius)),
        &from_normal(end, element.last_arm().normal(side, radius)),
    );
    judgement.decide(DecisionKind::WholeTurn, &off, off.clone()) == Ordering::Equal
}

/// How an arc takes the tool on its inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fit {
    /// There is room, or the element is not such an arc.
    Ordinary,
    /// The tool stands at the arc's centre while the arc is run ([TRC-ARC-08]).
    Point,
}

/// [TRC-ARC-05], [TRC-ARC-08]
pub(crate) fn tool_fits(
    element: &Element,
    side: Side,
    radius: &Real,
    equal: EqualRadius,
    judgement: &mut Judgement<'_>,
) -> Result<Fit, AlarmKind> {
    let Shape::Arc { sense, start_radius, end_radius, .. } = &element.shape else { return Ok(Fit::Ordinary) };
    if !tool_inside(*sense, side) {
        return Ok(Fit::Ordinary);
    }
    let spare = smaller(start_radius.clone(), end_radius.clone()) - radius;
    match judgement.decide(DecisionKind::ToolFitsArc, &spare, spare.clone()) {
        Ordering::Greater => Ok(Fit::Ordinary),
        Ordering::Equal if equal == EqualRadius::DegeneratePoint && start_radius == end_radius => Ok(Fit::Point),
        _ => Err(AlarmKind::RadiusTooSmall),
    }
}
