//! Contours put into the plane: turned, mirrored, run backwards, and scaled until every number is a whole number of
//! thousandths of a millimetre, or of millionths.

use rug::{Integer, Rational};

use super::choice::Choice;
use super::figure::{Figure, Shape, What};
use super::point::{Point, ratio};

/// How large a contour is. Most are of the size that machines reach; the others show a device whose own bound is made of a
/// product of two lengths instead of their sum, or of a length where a ratio belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Size {
    Common,
    /// In millimetres instead of thousandths of one, and no smaller than a sixteenth of the largest where its numbers allow
    /// that.
    Vast,
    /// In millionths of a millimetre.
    Fine,
}

impl Size {
    /// The least increment of a contour of this size, in thousandths of a millimetre.
    fn increment(self) -> Rational {
        match self {
            Size::Common => ratio(1, 1),
            Size::Vast => ratio(1000, 1),
            Size::Fine => ratio(1, 1000),
        }
    }
}

/// The largest extent of a contour, in increments.
const LARGEST: i64 = 400_000;
/// The smallest tool radius, in increments: one of them is small beside it.
const SMALLEST_TOOL: i64 = 100;

/// How far a contour is moved, in thousandths: most of them little, some of them where f64 has few bits left.
const SHIFTS: [i64; 8] = [0, 1_000, 40_000, 40_000, 200_000, 1_000_000, 10_000_000, 400_000_000];
/// So many of these are what machines reach. A fine contour is not moved farther: the band would not be small beside it.
const NEAR_SHIFTS: usize = 7;

/// Moves a contour anywhere and makes it one of some sizes. None when its numbers have no common scale of reasonable size.
pub(super) fn place(figure: Figure, sizes: &[Size], choice: &mut Choice) -> Option<Figure> {
    let size = if figure.to_scale { Size::Common } else { choice.pick(sizes) };
    let mut figure = if figure.reversible && choice.coin() { figure.reversed() } else { figure };
    let turn = if figure.to_scale { choice.quarter() } else { choice.direction() };
    if choice.coin() {
        figure.map(Point::mirrored, Point::mirrored, &Rational::from(1));
        figure.mirror_codes();
    }
    figure.map(|point| point.turned(&turn), |vector| vector.turned(&turn), &Rational::from(1));
    if choice.below(3) == 0 {
        figure.give_radii(choice);
    }
    if !figure.to_scale {
        let scale = scale(&figure, size, choice)?;
        figure.map(|point| point.times(&scale), Point::clone, &scale);
    }
    if !figure.numbers().all(|number| *number.denom() == 1) {
        return None;
    }
    let increment = size.increment();
    figure.map(|point| point.times(&increment), Point::clone, &increment);
    // By a millimetre an arc's end would lie off it.
    figure.increment = if figure.nudges_arc() { increment.min(ratio(1, 1)) } else { increment };
    let near = size == Size::Fine || sizes == [Size::Common];
    let far = choice.pick(if near { &SHIFTS[..NEAR_SHIFTS] } else { &SHIFTS });
    let shift = Point::new(choice.between(-far, far), choice.between(-far, far));
    figure.map(|point| point.plus(&shift), Point::clone, &Rational::from(1));
    Some(figure)
}

/// A multiple of the least scale that makes every number whole.
fn scale(figure: &Figure, size: Size, choice: &mut Choice) -> Option<Rational> {
    let least = figure.numbers().fold(Integer::from(1), |least, number| least.lcm(number.denom()));
    let extent = figure.numbers().fold(Rational::new(), |most, number| most.max(Rational::from(number.abs_ref())));
    let extent = (extent * &least).ceil();
    let most = (Rational::from(LARGEST) / extent.max(Rational::from(1))).floor();
    let most = most.numer().to_i64()?;
    let tool = Rational::from(&figure.tool * &least);
    let fewest = if tool > 0 { (Rational::from(SMALLEST_TOOL) / tool).ceil().numer().to_i64()?.max(1) } else { 1 };
    if fewest > most {
        return None;
    }
    // All sizes from the smallest to the largest, each order of magnitude as often as another.
    let mut times = if size == Size::Vast { fewest.max(most / 16) } else { fewest };
    while times < most && choice.below(4) != 0 {
        times = choice.between(times, times.saturating_mul(4).min(most));
    }
    Some(Rational::from(least * times))
}

/// The contour with its nudged number changed by so many thousandths of a millimetre toward a greater margin.
pub(super) fn neighbour(figure: &Figure, steps: &Rational) -> Figure {
    let mut moved = figure.clone();
    let toward = &figure.nudge.toward;
    let along_first = toward.a.clone().abs() >= toward.b.clone().abs();
    let component = if along_first { &toward.a } else { &toward.b };
    let by = if component.is_negative() { Rational::from(-steps) } else { steps.clone() };
    if let Some(number) = number(&mut moved, figure.nudge.what, along_first) {
        *number += by;
    }
    moved
}

/// A number of the contour; of a point the first or the second coordinate.
fn number(figure: &mut Figure, what: What, first: bool) -> Option<&mut Rational> {
    let point = match what {
        What::Tool => return Some(&mut figure.tool),
        What::Vertex(index) => figure.vertices.get_mut(index)?,
        What::Centre(index) | What::Word(index) => match &mut figure.moves.get_mut(index)?.shape {
            Shape::Line => return None,
            Shape::Arc { centre, .. } => centre,
            Shape::Radius { radius, .. } => return Some(radius),
        },
    };
    Some(if first { &mut point.a } else { &mut point.b })
}
