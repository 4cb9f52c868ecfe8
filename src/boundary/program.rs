//! Contours as programs: approach, start-up, the contour, cancel.

use radcomp_spec::{Block, Centre, Compensation, Movement};
use rug::Rational;

use super::figure::{Figure, Pause, Shape};
use super::point::Point;
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
    let approach = figure.approach.clone().unwrap_or_else(|| from(first, ends.approach));
    let away = figure.away.clone().unwrap_or_else(|| from(last, ends.away));
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
            blocks.push(line(first));
        } else {
            blocks.push(Block { movement: line(first).movement, ..codes });
        }
    } else {
        blocks.push(line(first));
    }
    for (each, corner) in figure.moves.iter().zip(figure.vertices.windows(2)) {
        match &each.pause {
            Pause::None => {}
            Pause::Lost => blocks.extend((0..=reach.non_moving_allowed).map(|_| Block::empty())),
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
    blocks.push(Block { compensation, ..line(&away) });
    blocks
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
