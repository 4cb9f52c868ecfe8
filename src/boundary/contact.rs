//! Contact points of a side change: [TRC-SIDE-02], and concentric arcs there.

use radcomp_spec::Direction::{Clockwise, Counterclockwise};
use radcomp_spec::Side;
use rug::Rational;

use super::arm::{covers, sign, swept};
use super::choice::Choice;
use super::figure::{Figure, What};
use super::point::Point;

/// A contact point exactly one radius beyond an element.
pub(super) fn contact_within(choice: &mut Choice) -> Option<Figure> {
    const MOST_DRAWS: usize = 100;
    match choice.below(4) {
        0 => Some(lines_at_right_angles(choice)),
        1 => (0..MOST_DRAWS).find_map(|_| beyond_far_end(choice)),
        2 => (0..MOST_DRAWS).find_map(|_| line_and_arc(choice)),
        _ => (0..MOST_DRAWS).find_map(|_| beyond_arc(choice)),
    }
}

/// The contact point is `P ± r·(u1 + u2)`, r beyond the end of the first line or before the start of the second.
fn lines_at_right_angles(choice: &mut Choice) -> Figure {
    let onward = Point::new(0, choice.pick(&[-1, 1]));
    let start = Point::new(-choice.length(), 0);
    let end = onward.times(&choice.length());
    let figure = Figure::new("lines at right angles", start).tool(choice.length() * choice.part());
    let figure = figure.line(Point::origin()).on(Some(Side::Right)).line(end);
    // r - r·(1 + cos φ)/|sin φ|
    figure.nudge(What::Vertex(2), Point::new(-1, 0))
}

/// The line y = r meets the offset circle of the arc in (x, r), too far beyond its end at the origin, and in (-q, r), one
/// radius before its start: the circle about (c, y) has `c = (x - q)/2`, and with `k = x·q/(2·r)` the arc passes the
/// origin, the tool outside it, when `y = (k² - c²)/(2·k)`.
fn beyond_far_end(choice: &mut Choice) -> Option<Figure> {
    let tool = choice.length();
    let far = Rational::from(&tool * 2) + choice.length();
    // Between r and q, so that it is the nearer one.
    let near = Rational::from(&far - &tool) * choice.part() + &tool;
    let foot: Rational = Rational::from(&near - &far) / 2;
    let twice: Rational = Rational::from(&near * &far) / &tool;
    let half = Rational::from(&twice / 2);
    let height: Rational = (Rational::from(half.square_ref()) - Rational::from(foot.square_ref())) / twice;
    let centre = Point::new(foot, height);
    let ray = centre.opposite();
    let sweep = choice.sweep();
    let contact = Point::new(-far.clone(), tool.clone());
    if !covers(&ray, &sweep, Counterclockwise, &contact.minus(&centre)) {
        return None;
    }
    let end = centre.plus(&swept(&ray, &sweep, Counterclockwise));
    let start = Point::new(tool.clone() - far, 0);
    let figure = Figure::new("over the far end of a line", start).tool(tool).line(Point::origin());
    let figure = figure.on(Some(Side::Right)).arc(end, centre, Counterclockwise);
    Some(figure.nudge(What::Vertex(0), Point::new(-1, 0)))
}

/// The line y = r meets the arc's offset circle in (r, r) when r = 2·(c_a + c_b ± R).
fn line_and_arc(choice: &mut Choice) -> Option<Figure> {
    let radius = choice.length();
    let centre = choice.direction().times(&radius);
    let sense = choice.sense();
    // Right of a counter-clockwise arc the tool is outside.
    let tool: Rational = (Rational::from(&centre.a + &centre.b) + &radius * sign(sense)) * 2;
    let offset_radius = &tool * sign(sense) + &radius;
    let across = Rational::from(&tool - &centre.a);
    if tool <= 0 || offset_radius <= 0 || across == 0 {
        return None;
    }
    let contact = Point::new(tool.clone(), tool.clone());
    let ray = contact.minus(&centre).times(&offset_radius.recip());
    let grow = ray.plus(&centre.times(&radius.recip())).opposite();
    let grow = if across > 0 { grow } else { grow.opposite() };
    let sweep = choice.sweep();
    let end = centre.plus(&swept(&centre.opposite(), &sweep, sense));
    // Run backwards, the line is asked only if the point lies on the arc.
    let reversible = covers(&centre.opposite(), &sweep, sense, &contact.minus(&centre));
    let start = Point::new(-choice.length(), 0);
    let figure = Figure::new("line and arc", start).tool(tool).line(Point::origin());
    let mut figure = figure.on(Some(Side::Right)).arc(end, centre, sense).nudge(What::Centre(1), grow);
    figure.reversible = reversible;
    Some(figure)
}

/// The first arc has radius 1 about the origin and ends at (1, 0); the contact point lies on its offset circle beyond
/// the end, a chord of exactly r from its normal there. The second arc's radius follows from that.
fn beyond_arc(choice: &mut Choice) -> Option<Figure> {
    let (first, second) = (choice.sense(), choice.sense());
    // Half the angle beyond the end: 2·R'·sin = r.
    let half = choice.slant();
    let sine = Rational::from(&half.b * 2);
    let outward = -sign(first);
    let under = Rational::from(1) - Rational::from(&sine * &outward);
    if under <= 0 {
        return None;
    }
    let tool = sine / under;
    let offset_radius = Rational::from(&tool * &outward) + 1;
    let corner = Point::new(1, 0);
    let normal = corner.times(&offset_radius);
    let contact = swept(&normal, &half.turned(&half), first);
    // |K - C2| = R2 ± r with C2 = P + R2·w.
    let outward = sign(second);
    let along = choice.direction();
    let to_contact = contact.minus(&corner);
    let shift = Rational::from(&tool * &outward);
    let over = to_contact.length_squared() - Rational::from(tool.square_ref());
    let under = (to_contact.dot(&along) + &shift) * 2;
    if under == 0 {
        return None;
    }
    let radius = over / under;
    let second_offset = Rational::from(&radius + &shift);
    let centre = corner.plus(&along.times(&radius));
    let ray = contact.minus(&centre);
    let forward = swept(&contact, &Point::new(0, 1), first);
    let slope = ray.dot(&forward);
    // The other end of the first arc must be farther off than this one.
    let sweep = choice.short_sweep();
    let start = swept(&corner, &sweep, first.reversed());
    let from_start = contact.minus(&start.times(&offset_radius)).length_squared();
    let on_arc = covers(&start, &sweep, first, &contact);
    if radius <= 0 || second_offset <= 0 || slope == 0 || from_start <= Rational::from(tool.square_ref()) || on_arc {
        return None;
    }
    let grow = ray.times(&second_offset.recip()).plus(&along).opposite();
    let grow = if slope > 0 { grow } else { grow.opposite() };
    let (ray, sweep) = (corner.minus(&centre), choice.sweep());
    let end = centre.plus(&swept(&ray, &sweep, second));
    // Run backwards, the first arc is asked only if the point lies on the second.
    let reversible = covers(&ray, &sweep, second, &contact.minus(&centre));
    let figure = Figure::new("beyond an arc", start).tool(tool).arc(corner, Point::origin(), first);
    let mut figure = figure.on(Some(Side::Right)).arc(end, centre, second).nudge(What::Centre(1), grow);
    figure.reversible = reversible;
    Some(figure)
}

/// Two contact points that mirror each other in the line through the corner and the centres. A line counts both only
/// when r is at least four times the arc's radius: it then counts as `contact-within` too at exactly four.
pub(super) fn nearer_contact(choice: &mut Choice) -> Option<Figure> {
    // The first of two points is the one before the foot on a line, or the one on the right of the line of centres.
    let (mut figure, odd_in_a_mirror) =
        if choice.coin() { (line_and_circle(choice), false) } else { (circles(choice)?, true) };
    figure.odd = [odd_in_a_mirror, true];
    Some(figure)
}

/// A full circle that continues a line, the tool outside it; or an arc that runs around both contact points.
fn line_and_circle(choice: &mut Choice) -> Figure {
    let radius = choice.length();
    let tool = Rational::from(&radius * 4) + radius.clone() * choice.length() / 2;
    let centre = Point::new(0, radius.clone());
    let start = Point::new(-(Rational::from(&tool * 2) + choice.length()), 0);
    let full = choice.coin();
    let end = if full { Point::origin() } else { centre.plus(&choice.slant().times(&-radius)) };
    let family = if full { "line and full circle" } else { "line and arc around both contacts" };
    let figure = Figure::new(family, start).tool(tool).line(Point::origin()).on(Some(Side::Right));
    figure.arc(end, centre, Counterclockwise).nudge(What::Centre(1), Point::new(1, 0))
}

/// Two full circles, one tangent to the other at the corner.
fn circles(choice: &mut Choice) -> Option<Figure> {
    let (x, y) = (choice.length(), choice.length());
    let part = choice.part();
    // Signed heights of the centres, positive for counter-clockwise; (+, -) never meet.
    let (first, second, tool) = match choice.below(3) {
        0 if x > y => (x.clone(), y.clone(), (x - y) * part),
        1 if x > y => (-y.clone(), -x.clone(), (x - y) * part),
        2 => (-x.clone(), y, x * part),
        _ => return None,
    };
    let sense = |height: &Rational| if *height > 0 { Counterclockwise } else { Clockwise };
    let (s1, s2) = (sense(&first), sense(&second));
    let toward = Point::new(if first > 0 { 1 } else { -1 }, 0);
    let figure = Figure::new("two full circles", Point::origin()).tool(tool);
    let figure = figure.arc(Point::origin(), Point::new(0, first), s1).on(Some(Side::Right));
    Some(figure.arc(Point::origin(), Point::new(0, second), s2).nudge(What::Centre(1), toward))
}

/// [TRC-CORNER-05] concentric arcs: only a side change asks. The arc is run back, or run on.
pub(super) fn centres_apart(choice: &mut Choice) -> Option<Figure> {
    let (first, second) = (choice.sense(), choice.sense());
    let corner = choice.direction().times(&choice.length());
    let start = swept(&corner, &choice.sweep(), first.reversed());
    let end = if first != second && choice.coin() { start.clone() } else { swept(&corner, &choice.sweep(), second) };
    let tool = choice.length() * choice.part();
    let narrow = tool.clone() * &tool >= corner.length_squared();
    let inside = first == Counterclockwise || second == Clockwise;
    if narrow && inside {
        return None;
    }
    let family = if first == second { "arc run on" } else { "arc run back" };
    let figure = Figure::new(family, start).tool(tool).arc(corner, Point::origin(), first);
    let figure = figure.on(Some(Side::Right)).arc(end, Point::origin(), second);
    Some(figure.nudge(What::Centre(1), choice.quarter()).one_sided())
}
