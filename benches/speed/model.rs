//! The exact model: every sign exact, and of every coordinate of the path an enclosure of 100 bits.

use std::hint::black_box;

use radcomp_model::number::Real;
use radcomp_model::{Engine, Sink};
use radcomp_spec::block::Point;
use radcomp_spec::{Block, Parameters, Segment, Step};
use rug::Rational;

use crate::contour::Program;

/// Bits that each coordinate is enclosed to.
const BITS: u32 = 100;

/// Runs the program that goes once round; answers the number of path elements.
pub fn run(parameters: &Parameters, program: &Program<Rational>) -> usize {
    feed(parameters, program.once())
}

/// Runs round until `blocks` blocks have been read; answers the number of path elements.
pub fn run_laps(parameters: &Parameters, program: &Program<Rational>, blocks: usize) -> usize {
    feed(parameters, program.laps(blocks))
}

fn feed<'a>(parameters: &Parameters, blocks: impl Iterator<Item = &'a Block<Rational>>) -> usize {
    let mut engine = Engine::new(parameters);
    let mut listener = Listener { elements: 0 };
    for block in blocks {
        engine.push(block, &mut listener).expect("the contour raises no alarm");
    }
    engine.finish(&mut listener).expect("the contour raises no alarm");
    listener.elements
}

struct Listener {
    elements: usize,
}

impl Sink for Listener {
    fn step(&mut self, step: Step<Real>) {
        self.elements += 1;
        match &step.segment {
            Segment::Line { end } => enclose(end),
            Segment::Arc { end, centre, .. } => {
                enclose(end);
                enclose(centre);
            }
            Segment::Hold => {}
        }
    }
}

fn enclose(point: &Point<Real>) {
    for coordinate in point {
        black_box(coordinate.enclosure(BITS));
    }
}
