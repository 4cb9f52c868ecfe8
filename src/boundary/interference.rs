//! Vectors that interfere only just, and blocks that can only just be left out: [TRC-INT-02], [TRC-INT-05]. Slots and
//! grooves into which the tool exactly fits stand with the wedges.

use radcomp_spec::Direction;
use radcomp_spec::Direction::{Clockwise, Counterclockwise};
use rug::Rational;

use super::arm::{sign, swept};
use super::choice::{Choice, unit};
use super::figure::{Figure, What};
use super::point::Point;

/// A length beside which the corners' vectors are short.
fn long(tool: &Rational, tangent: &Rational, choice: &mut Choice) -> Rational {
    Rational::from(tangent + 3) * tool * 3 + choice.length()
}

/// [TRC-INT-02] a groove exactly as wide as the tool. Its walls are parallel, and as high as each other or of heights that
/// differ by far, so that vectors farther apart than those of its ground do not interfere before those do.
pub(super) fn groove(choice: &mut Choice) -> Option<Figure> {
    let tool = choice.length() * choice.part();
    let width = Rational::from(&tool * 2);
    let first = Rational::from(&tool * 4) + choice.length();
    let second = if choice.coin() { first.clone() } else { Rational::from(&first + &tool) };
    let figure = Figure::new("groove as wide as the tool", Point::new(0, first)).tool(tool.clone());
    Some(figure.line(Point::origin()).line(Point::new(width.clone(), 0)).line(Point::new(width, second)))
}

/// [TRC-INT-02] a triangle that closes: its first and its last corner are one point.
pub(super) fn apart(choice: &mut Choice) -> Option<Figure> {
    let unit = choice.length();
    let (across, up) = (Rational::from(&unit * 4), Rational::from(&unit * 3));
    let tool = choice.part() * unit / 2;
    let figure = Figure::new("triangle that closes", Point::origin()).tool(tool).one_sided();
    let figure = figure.line(Point::new(across.clone(), 0)).line(Point::new(across, up)).line(Point::origin());
    let mut figure = figure.nudge(What::Vertex(3), choice.quarter());
    figure.reversible = false;
    Some(figure)
}

/// [TRC-INT-05] a notch whose short ground is left out and whose flanks stand at a right angle.
pub(super) fn turn(choice: &mut Choice) -> Option<Figure> {
    let first = choice.half_angle();
    if first == 1 {
        return None;
    }
    let second: Rational = Rational::from(1 - &first) / Rational::from(1 + &first);
    let tool = choice.length();
    let ground = Rational::from(&first + &second) * &tool * choice.part();
    let (before, after) = (long(&tool, &first, choice), long(&tool, &second, choice));
    let corner = unit(&first).times(&ground);
    let end = corner.plus(&Point::new(0, after));
    let figure = Figure::new("notch with flanks at a right angle", Point::new(-before, 0)).tool(tool);
    let mut figure = figure.line(Point::origin()).line(corner).line(end).nudge(What::Vertex(3), Point::new(1, 0));
    figure.reversible = false;
    Some(figure)
}

/// A line along the first axis to the origin, and a short one that runs back and up from there, to be left out: its
/// vectors interfere, because `L < r·(t - 1)` with t the half-angle tangent of the first corner.
struct Step {
    figure: Figure,
    tangent: Rational,
    /// Along the short line, and where it ends.
    back: Point,
    corner: Point,
}

impl Step {
    fn new(family: &'static str, choice: &mut Choice) -> Option<Step> {
        let tangent = choice.half_angle().recip();
        if tangent == 1 {
            return None;
        }
        let tool = choice.length();
        let short = Rational::from(&tangent - 1) * &tool * choice.part();
        let back = unit(&tangent);
        let corner = back.times(&short);
        let start = Point::new(-long(&tool, &tangent, choice), 0);
        let mut figure = Figure::new(family, start).tool(tool).line(Point::origin()).line(corner.clone());
        figure.reversible = false;
        Some(Step { figure, tangent, back, corner })
    }

    /// The step with an arc behind it that starts along a unit vector; none where the corner before that is not squared
    /// off, and where the vectors at the end of the arc might interfere as well.
    fn with_arc(self, along: &Point, centre: Point, sense: Direction, choice: &mut Choice) -> Option<Figure> {
        if self.back.cross(along) >= 0 || self.back.dot(along) >= 0 {
            return None;
        }
        let end = centre.plus(&swept(&self.corner.minus(&centre), &choice.short_sweep(), sense));
        let tool = &self.figure.tool;
        let radius = along.perp().dot(&centre.minus(&self.corner)) * sign(sense);
        // To the left of the travel: toward the centre of a counter-clockwise arc.
        let normal = end.minus(&centre).times(&(-sign(sense) * tool / radius));
        let vector = Point::new(-Rational::from(&self.tangent * tool), tool.clone());
        let forward = end.dot(&end.plus(&normal).minus(&vector));
        (forward > 0).then(|| self.figure.arc(end, centre, sense))
    }
}

/// [TRC-INT-05] a step between two parallel lines.
pub(super) fn parallel(choice: &mut Choice) -> Option<Figure> {
    let step = Step::new("step between parallel lines", choice)?;
    let onward = long(&step.figure.tool, &step.tangent, choice);
    let end = step.corner.plus(&Point::new(onward, 0));
    Some(step.figure.line(end).nudge(What::Vertex(3), Point::new(0, 1)))
}

/// [TRC-INT-05] a step before an arc, the tool inside it, whose offset circle touches the offset line of the first block:
/// `R = y / (1 - a)`, the arc starting at a height of y along (a, b).
pub(super) fn meets(choice: &mut Choice) -> Option<Figure> {
    let step = Step::new("step before an arc that touches the line", choice)?;
    let along = slanted(choice);
    let radius = &step.corner.b / Rational::from(1 - &along.a);
    if radius <= step.figure.tool {
        return None;
    }
    let centre = step.corner.plus(&along.perp().times(&radius));
    // R' - |y - r| = R - y of the centre.
    let grow = along.perp().minus(&Point::new(0, 1));
    let mut figure = step.with_arc(&along, centre, Counterclockwise, choice)?;
    figure.reversible = true;
    Some(figure.nudge(What::Centre(2), grow))
}

/// [TRC-INT-05] a step before an arc, the tool outside it, whose offset circle crosses the offset line of the first
/// block at two points as far from that block's end.
pub(super) fn nearer(choice: &mut Choice) -> Option<Figure> {
    let step = Step::new("step before an arc about the line's end", choice)?;
    let along = slanted(choice);
    if along.b <= 0 {
        return None;
    }
    let radius: Rational = -step.corner.a.clone() / &along.b;
    let centre = step.corner.plus(&along.perp().times(&radius).opposite());
    let figure = step.with_arc(&along, centre, Clockwise, choice)?;
    Some(figure.nudge(What::Centre(2), Point::new(1, 0)))
}

/// A direction less than a right angle from the first axis.
fn slanted(choice: &mut Choice) -> Point {
    let slant = choice.slant();
    if choice.coin() { slant } else { slant.mirrored() }
}
