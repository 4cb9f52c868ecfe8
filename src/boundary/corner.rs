//! Tangents and right angles: [TRC-CORNER-01], [TRC-CORNER-08], [TRC-SIDE-02], [TRC-LOOK-05], [TRC-ARC-07].

use radcomp_spec::Side;
use radcomp_spec::parameters::ArcExtension;
use rug::Rational;

use super::arm::{Arm, tool_for};
use super::asked::{asks_contacts, can_lose_look_ahead};
use super::choice::Choice;
use super::figure::{Figure, Nudge, Pause, What};
use super::point::Point;
use crate::generate::Reach;

/// Two elements that meet at the origin, the first along (1, 0).
pub(super) struct Corner {
    before: Arm,
    after: Arm,
    along: Point,
    onward: Point,
}

impl Corner {
    pub(super) fn new(before: Arm, after: Arm, onward: Point) -> Self {
        Corner { before, after, along: Point::new(1, 0), onward }
    }

    pub(super) fn figure(&self, family: &'static str, sides: [Side; 2], choice: &mut Choice) -> Figure {
        let figure = Figure::new(family, self.before.start(&self.along)).on(Some(sides[0]));
        let figure = self.before.arrive(figure, &self.along).on(Some(sides[1]));
        self.after.leave(figure, &self.onward).tool(tool_for(&[&self.before, &self.after], choice))
    }

    /// Nudges one of the elements, given the gradients of the margin for the two tangents.
    pub(super) fn nudged(&self, figure: Figure, gradients: [Point; 2], choice: &mut Choice) -> Figure {
        let (what, toward) =
            if choice.coin() { self.before.turning(0, &gradients[0]) } else { self.after.turning(1, &gradients[1]) };
        figure.nudge(what, toward)
    }

    /// Gradients of `cross(u1, u2)`.
    fn of_cross(&self) -> [Point; 2] {
        [self.onward.perp().opposite(), self.along.perp()]
    }

    /// Gradients of `dot(u1, u2)` for unit vectors, which only turn.
    pub(super) fn of_cosine(&self) -> [Point; 2] {
        let turning = |of: &Point, toward: &Point| toward.minus(&of.times(&of.dot(toward)));
        [turning(&self.along, &self.onward), turning(&self.onward, &self.along)]
    }

    /// Gradients of `dot(u1, u2)`.
    fn of_dot(&self) -> [Point; 2] {
        [self.onward.clone(), self.along.clone()]
    }
}

/// [TRC-CORNER-01] tangent joins and exact reversals; [TRC-SIDE-02] parallel lines at a change of side.
pub(super) fn turn(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    // Where turns up to an angle count as straight, a tangent join asks nothing more ([TRC-CORNER-16]).
    let reversal = choice.coin() || reach.parameters().straight_band_cosine.numerator > 0;
    let onward = Point::new(if reversal { -1 } else { 1 }, 0);
    if choice.below(4) == 0 && asks_contacts(reach) {
        let corner = Corner::new(Arm::line(choice), Arm::line(choice), onward);
        let family = if reversal { "side change on a reversal" } else { "side change straight on" };
        let figure = corner.figure(family, [Side::Left, Side::Right], choice);
        let mut figure = corner.nudged(figure, corner.of_cross(), choice);
        // The turn counts toward the side before the change, wherever the path begins.
        figure.odd = [false, true];
        return Some(figure);
    }
    let corner = Corner::new(Arm::any(choice), Arm::any(choice), onward);
    let family = match (corner.before.is_arc(), corner.after.is_arc(), reversal) {
        (false, false, false) => "lines in one direction",
        (false, true, false) => "line, then tangent arc",
        (true, false, false) => "arc, then tangent line",
        (true, true, false) => "tangent arcs",
        (false, false, true) => "line back",
        (false, true, true) => "line, then arc back",
        (true, false, true) => "arc, then line back",
        (true, true, true) => "arc, then arc back",
    };
    let figure = corner.figure(family, [Side::Left, Side::Left], choice);
    Some(corner.nudged(figure, corner.of_cross(), choice))
}

/// [TRC-CORNER-08] outer corners of exactly 90°.
pub(super) fn right_angle(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    // An arc that is extended by itself asks for no angle ([TRC-CORNER-14]).
    let lines = reach.parameters().arc_extension == ArcExtension::Curve;
    let arm = |choice: &mut Choice| if lines { Arm::line(choice) } else { Arm::any(choice) };
    let corner = Corner::new(arm(choice), arm(choice), Point::new(0, -1));
    let family = match (corner.before.is_arc(), corner.after.is_arc()) {
        (false, false) => "right angle of lines",
        (false, true) => "right angle of line and arc",
        (true, false) => "right angle of arc and line",
        (true, true) => "right angle of arcs",
    };
    let figure = corner.figure(family, [Side::Left, Side::Left], choice);
    Some(corner.nudged(figure, corner.of_dot(), choice))
}

/// [TRC-ARC-07] full circles between tangents. Whichever way the centre moves along the tangent, one of the corners
/// becomes an inner one: the margin is a distance and never negative. At an outer corner the tool passes the
/// circle's own normal anyway, so no other circle lies on the boundary.
pub(super) fn whole_turn(choice: &mut Choice) -> Option<Figure> {
    let circle = Arm::Arc { radius: choice.length(), sense: choice.sense(), sweep: Point::new(1, 0) };
    let (before, after) = (Arm::any(choice), Arm::any(choice));
    let along = Point::new(1, 0);
    let figure = Figure::new("full circle between tangents", before.start(&along));
    let figure = after.leave(circle.leave(before.arrive(figure, &along), &along), &along);
    Some(figure.tool(tool_for(&[&before, &circle, &after], choice)).nudge(What::Centre(1), along).one_sided())
}

/// [TRC-LOOK-05] arcs after a settled junction whose straight move is at right angles to the tangent or of no length:
/// tangent to the element before it, or its reversal; or half as far around the corner as the dummy block said.
pub(super) fn line_in(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    if reach.dummies() && (!can_lose_look_ahead(reach) || choice.coin()) {
        return half_of_dummy(choice);
    }
    let onward = Point::new(if choice.coin() { -1 } else { 1 }, 0);
    let corner = Corner::new(Arm::any(choice), Arm::arc(choice), onward);
    let figure = corner.figure("tangent arc after lost look-ahead", [Side::Left, Side::Left], choice);
    let Figure { nudge: Nudge { what, toward }, .. } = corner.nudged(figure.clone(), corner.of_cross(), choice);
    // (n2 - n1)·u2 = -σ·cross(u1, u2)
    Some(figure.after(Pause::Lost).nudge(what, toward.opposite()))
}

/// The vector is `r·n(u1) - r·tan(φ/2)·u1` with φ the turn to the dummy; it is at right angles to u2 when that turns
/// by φ/2.
fn half_of_dummy(choice: &mut Choice) -> Option<Figure> {
    let onward = choice.slant();
    let dummy = onward.turned(&onward);
    let corner = Corner::new(Arm::line(choice), Arm::arc(choice), onward.clone());
    let figure = corner.figure("arc half as far around as its dummy", [Side::Left, Side::Left], choice);
    // The tangent of φ/2 is the slope of u2; the margin is -V·u2.
    let slope = Rational::from(&onward.b / &onward.a);
    // On a line that is shorter than the vector the tool would run backwards.
    if Rational::from(&slope * &figure.tool) >= *corner.before.size() {
        return None;
    }
    let (what, toward) = corner.after.turning(1, &Point::new(slope, -1));
    let length = choice.length();
    Some(figure.after(Pause::Dummy(dummy.times(&length))).nudge(what, toward))
}
