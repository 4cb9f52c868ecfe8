//! What the tests share: a sink that keeps the steps, and the parameters of the built-in profile `seed-mill`.

#![allow(dead_code, reason = "each test uses its part of it")]

use std::sync::LazyLock;

use radcomp_impl::{Engine, Sink};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Block, Parameters, Segment, Step};

/// Keeps the path.
#[derive(Default)]
pub struct Path(pub Vec<Step<f64>>);

impl Sink for Path {
    fn step(&mut self, step: Step<f64>) {
        self.0.push(step);
    }
}

/// The parameters of `seed-mill`.
pub static SEED_MILL: LazyLock<Parameters> =
    LazyLock::new(|| Profile::builtin("seed-mill").expect("built in").parameters);

/// The path of a program, and the alarm that ended it.
pub fn run(parameters: &Parameters, blocks: &[Block<f64>]) -> (Vec<Step<f64>>, Option<Alarm>) {
    let (mut engine, mut path) = (Engine::new(parameters), Path::default());
    for block in blocks {
        if let Err(alarm) = engine.push(block, &mut path) {
            let steps = path.0.len();
            assert_eq!(engine.push(block, &mut path), Err(alarm));
            assert_eq!(engine.finish(&mut path), Err(alarm));
            assert_eq!(path.0.len(), steps, "nothing is emitted after an alarm");
            return (path.0, Some(alarm));
        }
    }
    let alarm = engine.finish(&mut path).err();
    (path.0, alarm)
}

/// A step as the worked examples write it, without its numbers, and its numbers.
pub fn write(step: &Step<f64>) -> (String, Vec<f64>) {
    let numbered = step.block + 1;
    match &step.segment {
        Segment::Line { end } => (format!("{numbered} line {}", step.clause), end.to_vec()),
        Segment::Arc { end, centre, direction, full } => {
            let direction = match direction {
                radcomp_spec::Direction::Clockwise => "cw",
                radcomp_spec::Direction::Counterclockwise => "ccw",
            };
            let full = if *full { " full" } else { "" };
            (format!("{numbered} arc {direction}{full} {}", step.clause), [*end, *centre].concat())
        }
        Segment::Hold => (format!("{numbered} hold {}", step.clause), Vec::new()),
    }
}
