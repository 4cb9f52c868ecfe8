//! Contours as programs: approach, start-up, the contour, cancel.

use radcomp_spec::parameters::{Cancel, StartUp};
use radcomp_spec::{Block, Centre, Compensation, Movement};
use rug::Rational;

use super::arm::sign;
use super::figure::{Figure, Pause, Shape};
use super::point::{Point, root};
use crate::generate::Reach;

/// Where the tool comes from and goes to, from the contour's ends, in thousandths of a millimetre.
#[derive(Clone, Debug)]
pub(super) struct Ends {
    pub(super) approach: [i64; 2],
    pub(super) away: [i64; 2],
    /// The compensation code stands in a block of its own.
    pub(super) code_apart: bool,
}

/// The program of a contour in thousandths of a millimetre.
pub(super) fn program(figure: &Figure, ends: &Ends, reach: Reach) -> Vec<Block<Rational>> {
    let mut blocks = Vec::with_capacity(figure.moves.len() + 5);
    let (Some(first), Some(last)) = (figure.vertices.first(), figure.vertices.last()) else { return blocks };
    let from = |point: &Point, [a, b]: [i64; 2]| point.plus(&Point::new(a, b));
    // [TRC-START-07] longer than the tool radius, where that is asked.
    let long = |[a, b]: [i64; 2]| lengthened(Point::new(a, b), &figure.tool);
    // Where a start-up or cancel block makes a corner, it goes straight on, so that the corner asks nothing.
    let parameters = reach.parameters();
    let straight_in = parameters.start_up != StartUp::TypeA;
    let straight_out = parameters.cancel != Cancel::TypeA;
    let before = || straight_in.then(|| before(figure)).flatten();
    let after = || straight_out.then(|| after(figure)).flatten();
    let approach = figure.approach.clone().or_else(before).unwrap_or_else(|| match straight_in {
        true => first.plus(&long(ends.approach)),
        false => from(first, ends.approach),
    });
    let away = figure.away.clone().or_else(after).unwrap_or_else(|| from(last, ends.away));
    let mut side = figure.moves.first().and_then(|each| each.side);
    blocks.push(Block { rapid: true, ..line(&approach) });
    if let Some(side) = side {
        let codes = Block {
            compensation: Some(Compensation::On(side)),
            radius: Some(thousandth(&figure.tool)),
            ..Block::empty()
        };
        if ends.code_apart {
            blocks.push(codes);
            blocks.push(Block::moving(movement(&figure.entry, &approach, first)));
        } else {
            blocks.push(Block { movement: movement(&figure.entry, &approach, first), ..codes });
        }
    } else {
        blocks.push(line(first));
    }
    for (each, corner) in figure.moves.iter().zip(figure.vertices.windows(2)) {
        match &each.pause {
            Pause::None => {}
            Pause::Lost => blocks.extend(lost(&corner[0], reach)),
            Pause::Dummy(along) => blocks.push(Block::moving(Movement::Dummy { vector: millimetres(along) })),
        }
        let mut block = Block::moving(movement(&each.shape, &corner[0], &corner[1]));
        if each.side != side {
            block.compensation = each.side.map(Compensation::On);
            side = each.side;
        }
        blocks.push(block);
    }
    let compensation = side.map(|_| Compensation::Off);
    let vector = figure.imaginary.as_ref().map(|point| millimetres(&point.minus(last)));
    blocks.push(Block { compensation, vector, ..line(&away) });
    blocks
}

/// Whether a corner turns, but by no more than what counts as straight.
pub(super) fn has_straight_corner(figure: &Figure, reach: Reach) -> bool {
    let limit = reach.parameters().straight_band_cosine;
    let limit = Rational::from((limit.numerator, limit.denominator));
    let corners = figure.moves.windows(2).zip(figure.vertices.windows(3));
    !limit.is_zero()
        && corners.into_iter().any(|(moves, points)| {
            let first = heading(&moves[0].shape, &points[1], &points[0], &points[1]);
            let second = heading(&moves[1].shape, &points[1], &points[1], &points[2]);
            first.zip(second).is_some_and(|(first, second)| {
                let (cross, dot) = (first.cross(&second), first.dot(&second));
                let least = Rational::from(limit.square_ref()) * first.length_squared() * second.length_squared();
                !cross.is_zero() && dot > 0 && dot.square() >= least
            })
        })
}

/// A point from which a straight line, longer than the tool radius, leads into the first move without a turn.
fn before(figure: &Figure) -> Option<Point> {
    let (first, second) = (figure.vertices.first()?, figure.vertices.get(1)?);
    let along = heading(&figure.moves.first()?.shape, first, first, second)?;
    Some(first.minus(&lengthened(along, &figure.tool)))
}

/// A point to which the last move leads straight on.
fn after(figure: &Figure) -> Option<Point> {
    let [.., first, last] = &figure.vertices[..] else { return None };
    let along = heading(&figure.moves.last()?.shape, last, first, last)?;
    Some(last.plus(&lengthened(along, &figure.tool)))
}

/// A vector along a move at one of its ends; none for a move whose ends are one point.
fn heading(shape: &Shape, at: &Point, start: &Point, end: &Point) -> Option<Point> {
    let along = match shape {
        Shape::Line => end.minus(start),
        Shape::Arc { centre, sense } => at.minus(centre).perp().times(&sign(*sense)),
        Shape::Radius { radius, sense } => {
            // Twice the ray, exactly where the centre is rational, and else nearly enough to lead into it.
            let chord = end.minus(start);
            let least = if chord == Point::origin() { Rational::from(1) } else { chord.length_squared() };
            let height = Rational::from(radius.square_ref()) * 4 / least - 1;
            let left = if radius.is_positive() { sign(*sense) } else { -sign(*sense) };
            let across = chord.perp().times(&(root(&height).unwrap_or_default() * left));
            at.plus(at).minus(start).minus(end).minus(&across).perp().times(&sign(*sense))
        }
    };
    (along != Point::origin()).then_some(along)
}

/// A whole multiple of a vector that is longer than a radius.
fn lengthened(vector: Point, radius: &Rational) -> Point {
    let square = (Rational::from(radius.square_ref()) / vector.length_squared()).ceil();
    // Greater than the root of the square.
    let times = square.numer().clone().sqrt() + 1_u32;
    vector.times(&Rational::from(times))
}

/// Blocks that lose the look-ahead: one without movement more than is allowed; where any number is, one of the kind
/// that loses it at once, if there is one.
fn lost(at: &Point, reach: Reach) -> Vec<Block<Rational>> {
    match reach.non_moving_allowed() {
        Some(allowed) => (0..=allowed).map(|_| Block::empty()).collect(),
        None if reach.stops() => vec![Block { stops_look_ahead: true, ..Block::empty() }],
        None => vec![line(at)],
    }
}

fn movement(shape: &Shape, start: &Point, end: &Point) -> Movement<Rational> {
    let (centre, direction) = match shape {
        Shape::Line => return Movement::Line { end: millimetres(end) },
        Shape::Arc { centre, sense } => (Centre::FromStart(millimetres(&centre.minus(start))), *sense),
        Shape::Radius { radius, sense } => (Centre::Radius(thousandth(radius)), *sense),
    };
    Movement::Arc { end: millimetres(end), centre, direction }
}

fn line(end: &Point) -> Block<Rational> {
    Block::moving(Movement::Line { end: millimetres(end) })
}

fn millimetres(point: &Point) -> [Rational; 2] {
    [thousandth(&point.a), thousandth(&point.b)]
}

fn thousandth(value: &Rational) -> Rational {
    Rational::from(value / 1000)
}
