//! Contours put into the plane: turned, mirrored, run backwards, and scaled until every number is a whole number of
//! thousandths of a millimetre.

use rug::{Integer, Rational};

use super::choice::Choice;
use super::figure::{Figure, What};
use super::point::Point;

/// The largest extent of a contour, in thousandths of a millimetre.
const LARGEST: i64 = 400_000;
/// The smallest tool radius, in thousandths: one least increment is small beside it.
const SMALLEST_TOOL: i64 = 100;

/// How far a contour is moved, in thousandths: most of them little, some of them where f64 has few bits left.
const SHIFTS: [i64; 8] = [0, 1_000, 40_000, 40_000, 40_000, 200_000, 1_000_000, 10_000_000];

/// Moves a contour anywhere. None when its numbers have no common scale of reasonable size.
pub(super) fn place(figure: Figure, choice: &mut Choice) -> Option<Figure> {
    let mut figure = if figure.reversible && choice.coin() { figure.reversed() } else { figure };
    let turn = if figure.to_scale { choice.quarter() } else { choice.direction() };
    if choice.coin() {
        figure.map(Point::mirrored, Point::mirrored, &Rational::from(1));
        figure.mirror_codes();
    }
    figure.map(|point| point.turned(&turn), |vector| vector.turned(&turn), &Rational::from(1));
    if !figure.to_scale {
        let scale = scale(&figure, choice)?;
        figure.map(|point| point.times(&scale), Point::clone, &scale);
    }
    let far = choice.pick(&SHIFTS);
    let shift = Point::new(choice.between(-far, far), choice.between(-far, far));
    figure.map(|point| point.plus(&shift), Point::clone, &Rational::from(1));
    Some(figure)
}

/// A multiple of the least scale that makes every number whole.
fn scale(figure: &Figure, choice: &mut Choice) -> Option<Rational> {
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
    let mut times = fewest;
    while times < most && choice.below(4) != 0 {
        times = choice.between(times, times.saturating_mul(4).min(most));
    }
    Some(Rational::from(least * times))
}

/// The contour with its nudged number changed by so many least increments toward a greater margin.
pub(super) fn neighbour(figure: &Figure, steps: i64) -> Figure {
    let mut moved = figure.clone();
    if steps == 0 {
        return moved;
    }
    let toward = &figure.nudge.toward;
    let by = |component: &Rational| Rational::from(if component.is_negative() { -steps } else { steps });
    let along_first = toward.a.clone().abs() >= toward.b.clone().abs();
    let step = |point: &mut Point| {
        if along_first { point.a += by(&toward.a) } else { point.b += by(&toward.b) }
    };
    match figure.nudge.what {
        What::Vertex(index) => moved.vertices.get_mut(index).map(step),
        What::Centre(index) => match moved.moves.get_mut(index).map(|each| &mut each.shape) {
            Some(super::figure::Shape::Arc { centre, .. }) => Some(step(centre)),
            _ => None,
        },
        What::Word(index) => match moved.moves.get_mut(index).map(|each| &mut each.shape) {
            Some(super::figure::Shape::Radius { radius, .. }) => Some(*radius += by(&toward.a)),
            _ => None,
        },
        What::Tool => Some(moved.tool += by(&toward.a)),
    };
    moved
}
