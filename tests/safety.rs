//! The safety verdict: hand cases, the exact model's paths, the peer, and speed.

#[path = "safety/exact.rs"]
mod exact;
#[path = "safety/hand.rs"]
mod hand;
#[path = "safety/peer.rs"]
mod peer;
#[path = "safety/samples.rs"]
mod samples;
#[path = "safety/shapes.rs"]
mod shapes;
#[path = "safety/speed.rs"]
mod speed;

use radcomp::gcode::{Tools, read};
use radcomp::safety::{Contour, SafetyVerdict, check};
use radcomp_model::run;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters, Segment, Step};
use rug::Rational;

/// The mill that the tests run on.
fn mill() -> Profile {
    Profile::builtin("seed-mill").unwrap()
}

/// The blocks of a program, the radius of offset 1 in thousandths.
fn blocks(text: &str, radius: u32) -> Vec<Block<Rational>> {
    let tools = Tools::empty().with_radius(1, Rational::from((radius, 1000)));
    let program = read("test.nc", text.as_bytes(), &mill(), &tools).unwrap();
    program.blocks.into_iter().map(|each| each.block).collect()
}

/// The exact model's path, rounded.
fn model_path(parameters: &Parameters, blocks: &[Block<Rational>]) -> Vec<Step<f64>> {
    let outcome = run(parameters, blocks);
    assert_eq!(outcome.alarm, None);
    radcomp::device::Answer::from(&outcome).steps
}

/// A path of lines: each block and end point.
fn lines(path: &[(usize, [f64; 2])]) -> Vec<Step<f64>> {
    let step = |&(block, end): &(usize, [f64; 2])| Step {
        block,
        clause: radcomp_spec::clause::TRC_MODE_01,
        rapid: false,
        main: true,
        segment: Segment::Line { end },
    };
    path.iter().map(step).collect()
}

/// The verdict on the exact model's path of a program.
fn verdict_of(text: &str, radius: u32, budget: f64) -> SafetyVerdict {
    let blocks = blocks(text, radius);
    check(&Contour::of(&blocks), &model_path(&mill().parameters, &blocks), budget)
}
