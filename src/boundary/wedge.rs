//! Tools that exactly fit: [TRC-WEDGE-01], [TRC-WEDGE-02], [TRC-WEDGE-03].

use radcomp_spec::Direction::{Clockwise, Counterclockwise};
use rug::Rational;

use super::arm::{sign, swept};
use super::choice::{Choice, unit};
use super::figure::{Figure, What};
use super::point::Point;

/// [TRC-WEDGE-02] the offset of a line between two inner corners, or between one and the start-up or cancel, has no
/// length: `L = r·(tan(φ1/2) + tan(φ2/2))`.
pub(super) fn line_forward(choice: &mut Choice) -> Option<Figure> {
    let (t1, t2) = (choice.any_half_angle(), choice.any_half_angle());
    let tool = choice.length() * choice.part();
    let right_angles = choice.below(3) == 0;
    let (t1, t2) = if right_angles { (Rational::from(1), Rational::from(1)) } else { (t1, t2) };
    let long = |tangent: &Rational, choice: &mut Choice| Rational::from(&tool * tangent) + choice.length();
    let onward = unit(&t2).times(&long(&t2, choice));
    if choice.below(3) == 0 {
        // The start's shift changes the length, and the angle too.
        let steep: Rational = (Rational::from(t2.square_ref()) + 1) / Rational::from(&t2 * 2);
        let start = Point::new(-(t2 * &tool), 0);
        let nudged = choice.coin();
        let figure = Figure::new("line as short as its corner", start).tool(tool).line(Point::origin()).line(onward);
        return Some(if nudged { figure.nudge(What::Vertex(0), Point::new(-1, -steep)) } else { figure });
    }
    let length = Rational::from(&t1 + &t2) * &tool;
    let into = unit(&t1).mirrored();
    let start = Point::new(-length.clone(), 0);
    let first = start.minus(&into.times(&long(&t1, choice)));
    let family = if right_angles { "groove as wide as the tool" } else { "slanted groove as wide as the tool" };
    let nudged = choice.coin();
    let figure = Figure::new(family, first).tool(tool).line(start).line(Point::origin()).line(onward);
    Some(if nudged { figure.nudge(What::Vertex(0), into.perp().opposite()) } else { figure })
}

/// [TRC-WEDGE-03] a groove of width 2·a with an arc for its ground. The tool's start and end on the offset circle are one
/// point when r = a; the tool's sweep differs from the programmed one by exactly a half turn when
/// `r = R·(a + b) / (R ∓ b)`, with b the centre's depth below the ground's ends or height above them.
pub(super) fn arc_forward(choice: &mut Choice) -> Option<Figure> {
    let radius = choice.length();
    let slant = choice.slant().times(&radius);
    let (a, b) = (slant.a, slant.b);
    let sense = choice.sense();
    let fits = choice.coin();
    let tool = if fits {
        a.clone()
    } else {
        let under = &b * sign(sense) + &radius;
        Rational::from(&a + &b) * &radius / under
    };
    if sense == Counterclockwise && tool >= radius {
        return None;
    }
    let height: Rational = Rational::from(&tool + &radius) * 2 + choice.length();
    let depth = b * sign(sense);
    let width = Rational::from(&a * 2);
    let family = match (fits, sense) {
        (true, Clockwise) => "bulging groove as wide as the tool",
        (true, Counterclockwise) => "round groove as wide as the tool",
        (false, _) => "sweeps half a turn apart",
    };
    let figure = Figure::new(family, Point::new(0, height.clone())).tool(tool).line(Point::origin());
    let figure = figure.arc(Point::new(width.clone(), 0), Point::new(a, depth), sense).line(Point::new(width, height));
    Some(figure.nudge(What::Tool, Point::new(if fits { -1 } else { 1 }, 0)))
}

/// [TRC-WEDGE-01] inner corners whose vector is exactly five radii long, the limit of every built-in profile.
///
/// No corner with a line is. The vector would lie at `V = -√24·r·u1 + r·n(u1)`. Between two lines the half-angle would have
/// the tangent √24 and so the angle the tangent -2·√24/23, but the tangent between two decimal vectors is rational. An
/// arc with its centre at (x, y) from the corner, along u1 and n(u1), passes V when
/// `12·r = -√24·x + y ± √(x² + y²)`; with d the line's decimal vector, `x·|d|` and `y·|d|` are rational, and then only x = 0
/// solves it, the tangent, which is no inner corner.
///
/// So two arcs: with `V = 5·r·w` and unit vectors w and c, the circle with its centre in direction c passes V when
/// `R·(5·w·c ± 1) = 12·r`.
pub(super) fn near_corner(choice: &mut Choice) -> Option<Figure> {
    const MOST_DRAWS: usize = 100;
    (0..MOST_DRAWS).find_map(|_| far_intersection(choice))
}

fn far_intersection(choice: &mut Choice) -> Option<Figure> {
    const LIMIT: u32 = 5;
    let tool = Rational::from(1);
    let toward = choice.of_fives();
    let vector = toward.times(&Rational::from(LIMIT));
    let circle = |sense, choice: &mut Choice| {
        let outward = -sign(sense);
        let along = choice.of_fives();
        let under = toward.dot(&along) * LIMIT + &outward;
        let radius = (under > 0).then(|| Rational::from(12) / under)?;
        let offset_radius = Rational::from(&radius + &outward);
        let ray = vector.minus(&along.times(&radius));
        (offset_radius > 0).then(|| (along.times(&radius), ray.times(&offset_radius.recip()), outward))
    };
    let (s1, s2) =
        choice.pick(&[(Clockwise, Clockwise), (Counterclockwise, Clockwise), (Counterclockwise, Counterclockwise)]);
    let ((c1, ray1, out1), (c2, ray2, out2)) = (circle(s1, choice)?, circle(s2, choice)?);
    // [TRC-CORNER-01] at the corner, [TRC-CORNER-04] at the vector: the path turns to the left.
    let senses = sign(s1) * sign(s2);
    if c1.cross(&c2) * &senses <= 0 || ray1.cross(&ray2) * senses <= 0 {
        return None;
    }
    let start = c1.plus(&swept(&c1.opposite(), &choice.sweep(), s1.reversed()));
    let end = c2.plus(&swept(&c2.opposite(), &choice.sweep(), s2));
    // The vector moves by v for each unit of r: ray1·v = ±1 and ray2·v = ±1.
    let spread = ray1.cross(&ray2);
    let moved = ray2.perp().opposite().times(&out1).plus(&ray1.perp().times(&out2)).times(&spread.clone().recip());
    let slope = Rational::from(LIMIT) - toward.dot(&moved);
    // Near a point where the margin is greatest both neighbours would lie below it.
    if slope.clone().abs() < 1 || spread.clone().abs() * 4 < 1 {
        return None;
    }
    let figure =
        Figure::new("far intersection of arcs", start).tool(tool).arc(Point::origin(), c1, s1).arc(end, c2, s2);
    Some(figure.nudge(What::Tool, Point::new(if slope > 0 { 1 } else { -1 }, 0)))
}
