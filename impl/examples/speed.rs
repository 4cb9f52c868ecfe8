//! Nanoseconds a block: `cargo run --release -p radcomp-impl --example speed`.

use std::hint::black_box;
use std::sync::LazyLock;
use std::time::Instant;

use radcomp_impl::{Engine, Sink};
use radcomp_spec::parameters::ReversedPath;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Parameters, Segment, Side, Step};

#[derive(Default)]
struct Sum(f64, usize);

impl Sink for Sum {
    #[inline]
    fn step(&mut self, step: Step<f64>) {
        self.1 += 1;
        if let Segment::Line { end } | Segment::Arc { end, .. } = step.segment {
            self.0 += end[0] - end[1];
        }
    }
}

static PARAMETERS: LazyLock<Parameters> = LazyLock::new(|| Profile::builtin("seed-mill").expect("built in").parameters);

/// Corners to both sides, of all kinds.
fn program(with_arcs: bool) -> Vec<Block<f64>> {
    let mut start = Block::moving(Movement::Line { end: [5.0, 0.0] });
    (start.compensation, start.radius) = (Some(Compensation::On(Side::Left)), Some(1.0));
    let mut blocks = vec![start];
    let mut at = [5.0, 0.0];
    for index in 0..20_000_u32 {
        let angle = f64::from(index % 17) * 0.37 + f64::from(index % 3) * 0.5;
        let length = 10.0 + f64::from(index % 5);
        let end = [at[0] + length * angle.cos(), at[1] + length * angle.sin()];
        blocks.push(Block::moving(if with_arcs {
            let direction = if index % 2 == 0 { Direction::Clockwise } else { Direction::Counterclockwise };
            let height = 3.0 + f64::from(index % 7);
            let across = if index % 3 == 0 { height } else { -height };
            let half = [(end[0] - at[0]) / 2.0, (end[1] - at[1]) / 2.0];
            let centre = [half[0] - half[1] * across / length, half[1] + half[0] * across / length];
            Movement::Arc { end, centre: Centre::FromStart(centre), direction }
        } else {
            Movement::Line { end }
        }));
        at = end;
    }
    blocks
}

fn measure(name: &str, blocks: &[Block<f64>], parameters: &Parameters) {
    let mut best = f64::INFINITY;
    let mut sum = Sum::default();
    for _ in 0..200 {
        sum = Sum::default();
        let mut engine = Engine::new(parameters);
        let before = Instant::now();
        for block in black_box(blocks) {
            if let Err(alarm) = engine.push(block, &mut sum) {
                println!("{alarm:?}");
                break;
            }
        }
        best = best.min(before.elapsed().as_nanos() as f64 / blocks.len() as f64);
        black_box(&sum);
    }
    println!("{name}: {best:.1} ns a block, {} steps of {} blocks", sum.1, blocks.len());
}

fn main() {
    println!("Engine: {} bytes", size_of::<Engine>());
    let alarm = Parameters { reversed_path: ReversedPath::Alarm, ..*PARAMETERS };
    measure("lines", &program(false), &PARAMETERS);
    measure("lines, reversed paths looked for", &program(false), &alarm);
    measure("arcs", &program(true), &PARAMETERS);
    measure("arcs, reversed paths looked for", &program(true), &alarm);
}
