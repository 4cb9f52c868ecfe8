//! Entry moves: [TRC-START-07], [TRC-START-09].

use radcomp_spec::Direction::Counterclockwise;
use radcomp_spec::parameters::StartUp;
use rug::Rational;

use super::choice::Choice;
use super::figure::{Figure, Shape};
use super::point::Point;
use crate::generate::Reach;

/// [TRC-START-07] an entry move exactly as long as the tool radius; [TRC-START-09] an arc whose chord is.
pub(super) fn entry_length(choice: &mut Choice, reach: Reach) -> Option<Figure> {
    let lines = reach.parameters().start_up == StartUp::EntryNormal;
    if reach.starts_on_arcs() && (!lines || choice.coin()) {
        return Some(chord_as_long(choice));
    }
    let tool = choice.length();
    let end = choice.direction().times(&choice.length());
    let mut figure = Figure::new("entry as long as the radius", Point::origin()).tool(tool.clone()).line(end);
    figure.approach = Some(choice.direction().times(&tool));
    figure.reversible = false;
    Some(figure)
}

/// A quarter or a half turn or less with a rational chord, the tool outside it.
fn chord_as_long(choice: &mut Choice) -> Figure {
    // Half the angle of the arc: the chord is 2·R·sin.
    let half = choice.slant();
    let radius = choice.length();
    let tool = Rational::from(&radius * 2) * &half.b;
    let centre = Point::new(0, -radius.clone());
    let to_start = Point::new(0, radius).turned(&half).turned(&half);
    let mut figure = Figure::new("entry arc with a chord as long as the radius", Point::origin()).tool(tool);
    figure.approach = Some(centre.plus(&to_start));
    figure.entry = Shape::Arc { centre, sense: radcomp_spec::Direction::Clockwise };
    figure.reversible = false;
    figure.line(Point::new(choice.length(), 0))
}

/// [TRC-START-09] an arc with the tool inside it, its start at right angles beside its compensated end:
/// `r = R·(1 - cos θ)`, θ being the angle from start to end. Outside an arc no start lies there.
pub(super) fn entry_arc(choice: &mut Choice) -> Option<Figure> {
    let (turn, radius) = (choice.slant(), choice.length());
    let tool = Rational::from(1 - &turn.a) * &radius;
    let centre = Point::new(-radius.clone(), 0);
    // Over the angle, or over the rest of the circle.
    let from = if choice.coin() { turn.mirrored() } else { turn };
    let mut figure = Figure::new("entry arc beside its end", Point::origin()).tool(tool);
    figure.approach = Some(centre.plus(&from.times(&radius)));
    figure.entry = Shape::Arc { centre, sense: Counterclockwise };
    figure.reversible = false;
    Some(figure.line(Point::new(0, choice.length())))
}
