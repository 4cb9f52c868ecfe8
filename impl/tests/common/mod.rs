//! What the tests share: a sink that keeps the steps, and the parameters of the built-in profile `seed-mill`.

#![allow(dead_code, reason = "each test uses its part of it")]

use radcomp_impl::{Engine, Sink};
use radcomp_spec::parameters::*;
use radcomp_spec::{Alarm, Block, Segment, Step};

/// Keeps the path.
#[derive(Default)]
pub struct Path(pub Vec<Step<f64>>);

impl Sink for Path {
    fn step(&mut self, step: Step<f64>) {
        self.0.push(step);
    }
}

/// The parameters of `seed-mill`.
pub const SEED_MILL: Parameters = Parameters {
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
