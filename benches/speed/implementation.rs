//! The implementation, its path taken and forgotten.

use std::hint::black_box;

use radcomp_impl::{Engine, Sink};
use radcomp_spec::{Block, Parameters, Step};

use crate::contour::Program;

/// Bytes of one engine, which is all that it ever holds.
pub fn size() -> usize {
    size_of::<Engine>()
}

/// Runs the program that goes once round; answers the number of path elements.
pub fn run(parameters: &Parameters, program: &Program<f64>) -> usize {
    feed(parameters, program.once())
}

/// Runs round until `blocks` blocks have been read; answers the number of path elements.
pub fn run_laps(parameters: &Parameters, program: &Program<f64>, blocks: usize) -> usize {
    feed(parameters, program.laps(blocks))
}

fn feed<'a>(parameters: &Parameters, blocks: impl Iterator<Item = &'a Block<f64>>) -> usize {
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
    fn step(&mut self, step: Step<f64>) {
        self.elements += 1;
        black_box(&step);
    }
}
