//! Offset curves that touch: [TRC-CORNER-05], [TRC-CORNER-14], [TRC-SIDE-02].
//!
//! An offset line touches an offset circle only when the tool runs inside the arc: outside it the radius grows as fast
//! as the distance, and the curves touch at tangents alone, where no corner asks. Two offset circles touch from
//! outside with the tool inside both arcs, from inside with it inside one and outside the other; with the tool outside
//! both, again only at tangents.

use radcomp_spec::Direction::{Clockwise, Counterclockwise};
use radcomp_spec::{Direction, Side};
use rug::Rational;

use super::arm::swept;
use super::choice::Choice;
use super::figure::{Figure, What};
use super::point::Point;

/// [TRC-CORNER-05] inner corners.
pub(super) fn offsets_meet(choice: &mut Choice) -> Option<Figure> {
    touching(choice, Side::Left, false)
}

/// [TRC-CORNER-14] outer corners, the curves extended.
pub(super) fn extensions_meet(choice: &mut Choice) -> Option<Figure> {
    touching(choice, Side::Left, true)
}

/// [TRC-SIDE-02] the same curves at a change of side, the second element run the other way.
pub(super) fn contact_exists(choice: &mut Choice) -> Option<Figure> {
    touching(choice, Side::Right, false)
}

fn touching(choice: &mut Choice, side: Side, outer: bool) -> Option<Figure> {
    match choice.below(3) {
        0 => line_and_arc(choice, side, outer),
        1 => arcs(choice, side, outer, true),
        _ => arcs(choice, side, outer, false),
    }
}

/// The sense of a second arc that stands to its tool as this sense would under G41.
fn seen_from(side: Side, sense: Direction) -> Direction {
    match side {
        Side::Left => sense,
        Side::Right => sense.reversed(),
    }
}

/// The line y = r and the circle of radius R - r about (∓a, b) touch when r = (R + b) / 2.
fn line_and_arc(choice: &mut Choice, side: Side, outer: bool) -> Option<Figure> {
    let radius = choice.length();
    let slant = choice.slant();
    let centre = if outer { slant } else { slant.perp() }.times(&radius);
    let centre = if choice.coin() { centre } else { centre.mirrored() };
    let tool = Rational::from(&radius + &centre.b) / 2;
    let sense = seen_from(side, Counterclockwise);
    let end = centre.plus(&swept(&centre.opposite(), &choice.sweep(), sense));
    let start = Point::new(-(choice.length() + Rational::from(&radius * 2)), 0);
    let figure = Figure::new("offset line touches offset circle", start).tool(tool).line(Point::origin());
    // R' - |b - r| = R + b - 2·r
    let grow = Point::new(centre.a.clone(), Rational::from(&centre.b + &radius));
    let figure = figure.on(Some(side)).arc(end, centre, sense);
    Some(if choice.coin() { figure } else { figure.nudge(What::Centre(1), grow) })
}

/// Circles about (-x1, 0) and (x2, 0) through (0, ±1), scaled.
fn arcs(choice: &mut Choice, side: Side, outer: bool, from_outside: bool) -> Option<Figure> {
    // x = (1/t - t)/2 and R = (1/t + t)/2 with t the half-angle tangent: R² = x² + 1.
    let mut leg = || -> (Rational, Rational) {
        let tangent = choice.any_half_angle();
        let inverse = Rational::from(tangent.recip_ref());
        (Rational::from(&inverse - &tangent) / 2, Rational::from(&inverse + &tangent) / 2)
    };
    let ((x1, r1), (x2, r2)) = (leg(), leg());
    let apart = Rational::from(&x1 + &x2);
    if apart <= 0 {
        return None;
    }
    let (second, tool, y) = if from_outside {
        (Counterclockwise, (Rational::from(&r1 + &r2) - &apart) / 2, 1)
    } else {
        (Clockwise, (Rational::from(&apart + &r1) - &r2) / 2, -1)
    };
    let second = seen_from(side, second);
    let corner = Point::new(0, if outer { -y } else { y });
    let (c1, c2) = (Point::new(-x1, 0), Point::new(x2, 0));
    let start = c1.plus(&swept(&corner.minus(&c1), &choice.sweep(), Clockwise));
    let end = c2.plus(&swept(&corner.minus(&c2), &choice.sweep(), second));
    let family = if from_outside { "offset circles touch from outside" } else { "offset circles touch from inside" };
    let ray = c2.minus(&corner).times(&r2.recip());
    let grow = ray.minus(&Point::new(1, 0));
    let grow = if from_outside { grow } else { grow.opposite() };
    let figure = Figure::new(family, start).tool(tool).arc(corner, c1, Counterclockwise);
    let figure = figure.on(Some(side)).arc(end, c2, second);
    Some(if choice.coin() { figure } else { figure.nudge(What::Centre(1), grow) })
}

/// [TRC-CANCEL-08] an arc with the tool inside it, and an imaginary line whose offset touches its offset circle. With the
/// centre above the corner and e the direction of the line, the centre stands `R·e_a - r` from that offset, which is
/// `-(R - r)` at `r = R·(1 + e_a) / 2`; with `+(R - r)` the line would be a tangent of the arc.
pub(super) fn imaginary_line_met(choice: &mut Choice) -> Option<Figure> {
    let (turn, radius) = (choice.slant(), choice.length());
    let sign = |choice: &mut Choice| Rational::from(if choice.coin() { 1 } else { -1 });
    let along = Point::new(turn.a * sign(choice), turn.b * sign(choice));
    let tool = Rational::from(&along.a + 1) * &radius / 2;
    let (start, centre) = (Point::new(-radius.clone(), radius.clone()), Point::new(0, radius.clone()));
    let figure = Figure::new("imaginary line that touches the offset of an arc", start).tool(tool);
    let mut figure = figure.arc(Point::origin(), centre, Direction::Counterclockwise);
    figure.imaginary = Some(along.times(&radius));
    figure.reversible = false;
    Some(figure)
}
