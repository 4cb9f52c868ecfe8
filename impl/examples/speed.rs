//! Nanoseconds a block: `cargo run --release -p radcomp-impl --example speed`.

use std::hint::black_box;
use std::time::Instant;

use radcomp_impl::{Engine, Sink};
use radcomp_spec::parameters::*;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Segment, Side, Step};

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

const PARAMETERS: Parameters = Parameters {
    start_up: StartUp::TypeA,
    start_up_lost: StartUpLost::Normal,
    cancel: Cancel::TypeA,
    outer_corner: OuterCorner::Intersection,
    reversal: Reversal::Outer,
    side_change: SideChange::IntersectionWithin,
    side_change_after_start_up: SideChangeAfterStartUp::Alarm,
    non_moving_allowed: Some(2),
    corner_owner: CornerOwner::Next,
    reversed_path: ReversedPath::Advisory,
    arc_end_tolerance: Ratio { numerator: 1, denominator: 100 },
    far_intersection: Ratio { numerator: 5, denominator: 1 },
    start_up_b: StartUpB::ViaNormal,
    start_up_without_movement: StartUpWithoutMovement::None,
    start_up_arc: StartUpArc::Alarm,
    cancel_without_movement: CancelWithoutMovement::None,
    corner_limit_cosine: NONE,
    arc_extension: ArcExtension::Tangent,
    smallest_corner_cosine: NONE,
    straight_band_cosine: NONE,
    arc_on_rapid: ArcOnRapid::Arc,
    small_vector_limit: NONE,
    same_code: SameCode::Ordinary,
    negative_radius: NegativeRadius::Alarm,
    equal_radius: EqualRadius::Alarm,
    zero_length_move: ZeroLengthMove::NoMovement,
    pending_at_alarm: PendingAtAlarm::Ended,
    side_code_vector: SideCodeVector::Refused,
    cancel_vector: CancelVector::Refused,
    offset_change: OffsetChange::Alarm,
};

const NONE: Ratio = Ratio { numerator: 0, denominator: 1 };

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
    let alarm = Parameters { reversed_path: ReversedPath::Alarm, ..PARAMETERS };
    measure("lines", &program(false), &PARAMETERS);
    measure("lines, reversed paths looked for", &program(false), &alarm);
    measure("arcs", &program(true), &PARAMETERS);
    measure("arcs, reversed paths looked for", &program(true), &alarm);
}
