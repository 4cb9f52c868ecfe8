//! Decisions on the numbers of one block: [TRC-LOOK-01], [TRC-ARC-02], [TRC-ARC-03], [TRC-ARC-05], [TRC-ARC-06].

use radcomp_spec::Side;
use rug::Rational;

use super::arm::{Arm, swept};
use super::asked::thousandths;
use super::choice::Choice;
use super::figure::{Figure, What};
use super::point::Point;
use crate::generate::Reach;

/// [TRC-LOOK-01] moves of no length: anywhere, and where they stand for the start-up, the cancel or an arc with R.
pub(super) fn moves(choice: &mut Choice) -> Option<Figure> {
    let side = choice.coin().then_some(Side::Left);
    let (first, second) = (choice.direction(), choice.direction());
    let (start, end) = (first.times(&choice.length()).opposite(), second.times(&choice.length()));
    let tool = choice.length() * choice.part();
    let origin = Point::origin;
    let toward = choice.quarter();
    let figure = |family| Figure::new(family, start.clone()).on(side).tool(tool.clone()).one_sided();
    let mut figure = match choice.below(5) {
        0 | 1 => figure("line of no length").line(origin()).line(origin()).line(end).nudge(What::Vertex(2), toward),
        2 => {
            let figure = figure("arc with R and a chord of no length").line(origin());
            figure.radius_arc(origin(), choice.length(), choice.sense()).line(end).nudge(What::Vertex(2), toward)
        }
        3 => {
            let mut figure = figure("first move of no length").line(end).nudge(What::Vertex(0), toward);
            figure.approach = Some(start.clone());
            figure
        }
        _ => {
            let mut figure = figure("last move of no length").line(end.clone()).nudge(What::Vertex(1), toward);
            figure.away = Some(end);
            figure
        }
    };
    figure.reversible = false;
    Some(figure)
}

/// [TRC-ARC-02] arcs whose centre is an end, or one tolerance from it. One least increment off, the two radii differ by
/// far, but for the arcs of a few least increments.
pub(super) fn centre_distance(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let tolerance = thousandths(reach.parameters().centre_tolerance)?;
    if tolerance > 0 {
        return Some(centre_near_an_end(tolerance, choice));
    }
    let side = choice.coin().then_some(Side::Left);
    let start = choice.of_fives().times(&Rational::from(choice.between(1, 3000) * 25)).opposite();
    let sense = choice.sense();
    let small = Point::new(choice.between(2, 8), 0);
    let far = choice.of_fives().times(&Rational::from(choice.between(1, 3000) * 25));
    // Beside the decision hardly a digit is left of the direction to the centre: a normal's end is no further off than that.
    let tool = Rational::from(choice.between(1, 400));
    let figure =
        |family| Figure::new(family, start.clone()).on(side).tool(tool.clone()).one_sided().line(Point::origin());
    let mut figure = match choice.below(4) {
        0 => figure("centre at the start").arc(far, Point::origin(), sense),
        1 => figure("centre at the end").arc(far.clone(), far, sense),
        2 => figure("centre at the start of a tiny arc").arc(small, Point::origin(), sense),
        _ => figure("full circle about its start").arc(Point::origin(), Point::origin(), sense),
    };
    figure = figure.nudge(What::Centre(1), choice.quarter());
    figure.to_scale = true;
    Some(figure)
}

/// [TRC-ARC-02] arcs whose radius is the tolerance.
fn centre_near_an_end(tolerance: i64, choice: &mut Choice) -> Figure {
    let side = choice.coin().then_some(Side::Left);
    let start = choice.of_fives().times(&Rational::from(choice.between(1, 3000) * 25)).opposite();
    let centre = choice.quarter().times(&Rational::from(tolerance));
    let end = centre.plus(&centre.perp());
    let tool = Rational::from(choice.between(1, 4000));
    let mut figure = Figure::new("arc whose radius is the tolerance", start).on(side).tool(tool).line(Point::origin());
    figure = figure.arc(end, centre.clone(), choice.sense());
    figure.to_scale = true;
    // Away from both ends alike: the end follows on the axis at right angles.
    figure.nudge(What::Centre(1), centre)
}

/// [TRC-ARC-06] half a chord that is one tolerance longer than R.
pub(super) fn chord_fits(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let tolerance = thousandths(reach.parameters().chord_tolerance)?;
    if tolerance == 0 {
        return half_turn(choice);
    }
    let radius = choice.between(1, 3000) * 25 - tolerance;
    if radius <= 0 {
        return None;
    }
    let along = choice.of_fives();
    let end = along.times(&Rational::from((radius + tolerance) * 2));
    let start = choice.of_fives().times(&Rational::from(choice.between(1, 3000) * 25)).opposite();
    let tool = Rational::from(choice.between(1, radius));
    let (word, grow) = if choice.coin() { (radius, 1) } else { (-radius, -1) };
    let side = choice.coin().then_some(Side::Left);
    let figure = Figure::new("half a chord longer than R by the tolerance", start).on(side).tool(tool);
    let mut figure = figure.line(Point::origin()).radius_arc(end, Rational::from(word), choice.sense());
    figure.to_scale = true;
    Some(figure.nudge(What::Word(1), Point::new(grow, 0)))
}

/// [TRC-ARC-06] half turns with R.
pub(super) fn half_turn(choice: &mut Choice) -> Option<Figure> {
    let radius = choice.length();
    let along = choice.direction();
    let end = along.times(&Rational::from(&radius * 2));
    let tool = choice.part() * &radius;
    let (word, grow) = if choice.coin() { (radius, 1) } else { (-radius, -1) };
    let side = choice.coin().then_some(Side::Left);
    let figure = Figure::new("half turn with R", Arm::line(choice).start(&choice.direction())).on(side).tool(tool);
    let figure = figure.line(Point::origin()).radius_arc(end, word, choice.sense());
    let figure = if choice.coin() { figure.line(Point::origin()) } else { figure };
    Some(if choice.coin() {
        figure.nudge(What::Word(1), Point::new(grow, 0))
    } else {
        figure.nudge(What::Vertex(1), along)
    })
}

/// [TRC-ARC-03] radii that differ by exactly the tolerance.
pub(super) fn end_on_arc(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    const RAYS: [(i64, i64, i64); 7] =
        [(1, 0, 1), (3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29), (33, 56, 65)];
    let (a, b, h) = choice.pick(&RAYS);
    let times = choice.between(400, 60_000) / h + 2;
    let (c, d, k) = choice.pick(&RAYS);
    let tolerance = thousandths(reach.parameters().arc_end_tolerance)?;
    // k·other = h·times ± tolerance, which has no answer for some pairs.
    let wanted = h * times + choice.pick(&[-tolerance, tolerance]);
    if wanted % k != 0 || wanted <= 0 {
        return None;
    }
    let other = wanted / k;
    let (from, to) = (Point::new(a * times, b * times), Point::new(c * other, d * other).turned(&choice.quarter()));
    let outward = if wanted > h * times { to.opposite() } else { to.clone() };
    let side = choice.coin().then_some(Side::Left);
    let tool = Rational::from(choice.between(1, h * times / 2));
    let start = from.plus(&choice.of_fives().times(&Rational::from(choice.between(1, 900) * 25)));
    let mut figure = Figure::new("radii one tolerance apart", start).on(side).tool(tool).line(from);
    figure = figure.arc(to.clone(), Point::origin(), choice.sense());
    if choice.coin() {
        figure = figure.line(to.times(&Rational::from(2)));
    }
    figure.to_scale = true;
    Some(figure.nudge(What::Vertex(2), outward))
}

/// [TRC-ARC-05] arcs of exactly the tool's radius with the tool on their inside.
pub(super) fn tool_fits(choice: &mut Choice) -> Option<Figure> {
    use radcomp_spec::Direction::Counterclockwise;
    let radius = choice.length();
    let before = Arm::any(choice);
    if before.is_arc() && *before.size() <= radius {
        return None;
    }
    let along = Point::new(1, 0);
    let start = before.start(&along);
    let end = |ray: Point, choice: &mut Choice| swept(&ray, &choice.sweep(), Counterclockwise);
    let figure = |family| before.arrive(Figure::new(family, start.clone()).tool(radius.clone()), &along);
    let figure = match choice.below(4) {
        0 => {
            let centre = Point::new(0, radius.clone());
            let end = centre.plus(&end(centre.opposite(), choice));
            figure("tangent arc as narrow as the tool").arc(end, centre, Counterclockwise)
        }
        1 => {
            let centre = choice.direction().times(&radius);
            let end = centre.plus(&end(centre.opposite(), choice));
            figure("arc as narrow as the tool").arc(end, centre, Counterclockwise)
        }
        2 => {
            let centre = choice.direction().times(&radius);
            figure("full circle as narrow as the tool").arc(Point::origin(), centre, Counterclockwise)
        }
        _ => {
            // A chord shorter than the diameter, so that a smaller R still has one.
            let end = choice.direction().times(&(Rational::from(&radius * 2) * choice.part()));
            let word = if choice.coin() { radius.clone() } else { -radius.clone() };
            let grow = if word > 0 { 1 } else { -1 };
            let figure = figure("arc with R as narrow as the tool").radius_arc(end, word, Counterclockwise);
            if choice.coin() { figure.nudge(What::Word(1), Point::new(grow, 0)) } else { figure }
        }
    };
    Some(figure)
}
