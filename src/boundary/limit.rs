//! Angles and lengths that the profile sets: [TRC-CORNER-13], [TRC-CORNER-15], [TRC-CORNER-16], [TRC-CORNER-18].

use radcomp_spec::Side;
use radcomp_spec::parameters::{Cancel, StartUp};
use rug::Rational;

use super::arm::Arm;
use super::asked::{angle, thousandths};
use super::choice::{Choice, unit};
use super::corner::Corner;
use super::figure::{Figure, What};
use super::point::{Point, ratio};
use crate::generate::Reach;

/// [TRC-CORNER-13] an outer corner of exactly the limit angle, at which it is formed by intersection.
pub(super) fn limit_angle(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let limit = reach.parameters().corner_limit_cosine;
    let limit = if limit.numerator == 0 { Point::new(0, 1) } else { angle(limit)? };
    let corner = Corner::new(Arm::any(choice), Arm::any(choice), limit.opposite());
    let figure = corner.figure("corner of the limit angle", [Side::Left, Side::Left], choice);
    Some(corner.nudged(figure, corner.of_cosine(), choice))
}

/// [TRC-CORNER-16] a turn, to either side, that only just counts as straight.
pub(super) fn straight_band(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let limit = angle(reach.parameters().straight_band_cosine)?;
    let onward = if choice.coin() { limit } else { limit.mirrored() };
    let corner = Corner::new(Arm::any(choice), Arm::any(choice), onward);
    let figure = corner.figure("turn that only just counts as straight", [Side::Left, Side::Left], choice);
    Some(corner.nudged(figure, corner.of_cosine(), choice))
}

/// [TRC-CORNER-15] the smallest corner of type B, after the start-up block or before the cancel block.
pub(super) fn smallest_corner(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let parameters = reach.parameters();
    let at_start = parameters.start_up == StartUp::TypeB;
    let at_start = at_start && (parameters.cancel != Cancel::TypeB || choice.coin());
    let onward = angle(parameters.smallest_corner_cosine)?.opposite();
    let (along, tool) = (Point::new(1, 0), choice.length() * choice.part());
    let (first, second) = (choice.length(), choice.length());
    let corner = Corner::new(Arm::line(choice), Arm::line(choice), onward.clone());
    let [before, after] = corner.of_cosine();
    let mut figure = if at_start {
        let mut figure = Figure::new("smallest corner after start-up", Point::origin()).tool(tool);
        figure.approach = Some(along.times(&first).opposite());
        figure.line(onward.times(&second)).nudge(What::Vertex(1), after)
    } else {
        let start = along.times(&first).opposite();
        let mut figure = Figure::new("smallest corner before cancel", start).tool(tool).line(Point::origin());
        figure.away = Some(onward.times(&second));
        figure.nudge(What::Vertex(0), before.opposite())
    };
    figure.reversible = false;
    Some(figure)
}

/// The longest line behind a corner, in thousandths of a millimetre.
const MOST: i64 = 800_000_000;

/// [TRC-CORNER-18] two vectors of a corner that differ by exactly the limit in one coordinate, and by no more in the
/// other. The corner stands along the axes, whose coordinates count.
pub(super) fn small_vector(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let limit = Rational::from(thousandths(reach.parameters().small_vector_limit)?);
    let one = Rational::from(1);
    let arc_first = choice.coin();
    let (onward, most) = if arc_first {
        // Its normal, and the corner r·tan(φ/2) farther: at times of a tool so large that it is the limit by so small an
        // angle.
        let slight = ratio(1, choice.pick(&[1000, 10_000]));
        let tangent = if choice.below(3) == 0 { slight } else { choice.half_angle() };
        (unit(&tangent).mirrored(), tangent)
    } else {
        // The two points of a corner that is squared off.
        let slant = choice.slant();
        let first = (Rational::from(&one - &slant.b) - &slant.a).abs();
        let second = (Rational::from(&one + &slant.a) - &slant.b).abs();
        (slant.opposite(), first.max(second))
    };
    let tool = limit / most;
    let whole = Rational::from(onward.a.denom().clone().lcm(onward.b.denom()));
    // Neither of no length beside the vectors nor a kilometre long.
    let most = (Rational::from(MOST) / &whole).floor().numer().to_i64().unwrap_or(1).clamp(1, 2000);
    let second = whole * choice.between(1, most);
    let first = Rational::from(choice.between(20, 4000));
    let before = match arc_first {
        true => Arm::Arc { radius: Rational::from(&first + &tool), sense: choice.sense(), sweep: Point::new(0, 1) },
        false => Arm::Line { length: first },
    };
    let corner = Corner::new(before, Arm::Line { length: second }, onward);
    let family = if arc_first { "normal and corner one limit apart" } else { "two corner points one limit apart" };
    let mut figure = corner.figure(family, [Side::Left, Side::Left], choice).tool(tool);
    figure.to_scale = true;
    figure.reversible = false;
    Some(figure.nudge(What::Tool, Point::new(1, 0)))
}
