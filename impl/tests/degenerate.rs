//! Geometry that is degenerate in decimals, turned by Pythagorean angles and moved far from the origin: rounding to
//! f64 hides it, and the engine must find it all the same. A least increment beside it, the other case.

mod common;

use common::{SEED_MILL, run};
use proptest::prelude::*;
use radcomp_spec::parameters::*;
use radcomp_spec::{AlarmKind, Block, Centre, Clause, Compensation, Direction, Movement, Side, Step, clause};

/// A frame whose first axis has the direction of a Pythagorean triple; lengths are whole numbers of its hypotenuse,
/// coordinates whole numbers of thousandths of a millimetre.
#[derive(Clone, Copy, Debug)]
struct Frame {
    triple: (i64, i64, i64),
    scale: i64,
    origin: (i64, i64),
}

fn millimetres(thousandths: i64) -> f64 {
    // The quotient of two exact numbers is the decimal, rounded.
    thousandths as f64 / 1000.0
}

impl Frame {
    fn vector(&self, x: i64, y: i64) -> [f64; 2] {
        let (a, b, _) = self.triple;
        [millimetres((a * x - b * y) * self.scale), millimetres((b * x + a * y) * self.scale)]
    }

    fn point(&self, x: i64, y: i64) -> [f64; 2] {
        let (a, b, _) = self.triple;
        let at = ((a * x - b * y) * self.scale + self.origin.0, (b * x + a * y) * self.scale + self.origin.1);
        [millimetres(at.0), millimetres(at.1)]
    }

    /// Thousandths of a millimetre.
    fn length(&self, units: i64) -> i64 {
        units * self.triple.2 * self.scale
    }

    fn line(&self, x: i64, y: i64) -> Block<f64> {
        Block::moving(Movement::Line { end: self.point(x, y) })
    }

    fn arc(&self, end: (i64, i64), centre: (i64, i64), direction: Direction) -> Block<f64> {
        let centre = Centre::FromStart(self.vector(centre.0, centre.1));
        Block::moving(Movement::Arc { end: self.point(end.0, end.1), centre, direction })
    }

    /// A rapid move to (-40, 0), a start-up to (-30, 0) with the tool left and its radius, in thousandths.
    fn start(&self, radius: i64) -> Vec<Block<f64>> {
        let mut start_up = self.line(-30, 0);
        (start_up.compensation, start_up.radius) = (Some(Compensation::On(Side::Left)), Some(millimetres(radius)));
        vec![self.line(-40, 0), start_up]
    }

    /// The program that starts so, goes on to (0, 0), and then as told.
    fn run(&self, radius: i64, parameters: &Parameters, rest: &[Block<f64>]) -> (Vec<Step<f64>>, Option<AlarmKind>) {
        let mut blocks = self.start(radius);
        blocks.push(self.line(0, 0));
        blocks.extend_from_slice(rest);
        let (steps, alarm) = run(parameters, &blocks);
        (steps, alarm.map(|alarm| alarm.kind))
    }
}

fn right(mut block: Block<f64>) -> Block<f64> {
    block.compensation = Some(Compensation::On(Side::Right));
    block
}

fn frame() -> impl Strategy<Value = Frame> {
    let triples = vec![(1, 0, 1), (3, 4, 5), (-5, 12, 13), (-15, -8, 17), (20, -21, 29), (119, 120, 169)];
    let far = prop::sample::select(vec![0_i64, 1_000, 1_000_000, 100_000_000]);
    (prop::sample::select(triples), 1_i64..200, far, -1_000_i64..1_000, -1_000_i64..1_000).prop_map(
        |(triple, scale, far, x, y)| Frame { triple, scale, origin: (far * x / 1000 + x, far * y / 1000 + y) },
    )
}

/// The clause of the end of the line to (0, 0), and where it ends.
fn corner(steps: &[Step<f64>]) -> (Clause, [f64; 2]) {
    let step = steps.iter().find(|step| step.block == 2 && step.main).expect("the line has been run");
    match step.segment {
        radcomp_spec::Segment::Line { end } => (step.clause, end),
        _ => panic!("a line"),
    }
}

fn near(a: [f64; 2], b: [f64; 2]) -> bool {
    let size = a[0].abs().max(a[1].abs()).max(1.0);
    (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) <= 1e-12 * size
}

const LEFT: Direction = Direction::Counterclockwise;

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn tangent_junctions(frame in frame()) {
        let radius = frame.length(2);
        for rest in [frame.line(10, 0), frame.arc((10, 10), (0, 10), LEFT), frame.arc((0, 20), (0, 10), LEFT)] {
            let (steps, alarm) = frame.run(radius, &SEED_MILL, &[rest]);
            prop_assert_eq!(alarm, None);
            prop_assert_eq!(corner(&steps).0, clause::TRC_CORNER_02);
            prop_assert!(near(corner(&steps).1, frame.point(0, 2)));
        }
    }

    #[test]
    fn reversals_and_right_angles(frame in frame()) {
        let radius = frame.length(2);
        let cases = [
            (frame.line(-10, 0), clause::TRC_CORNER_09, (2, 2)),
            (frame.arc((0, -20), (0, -10), LEFT), clause::TRC_CORNER_09, (2, 2)),
            (frame.line(0, -10), clause::TRC_CORNER_06, (2, 2)),
            (frame.line(0, 10), clause::TRC_CORNER_03, (-2, 2)),
        ];
        for (rest, expected, (x, y)) in cases {
            let (steps, _) = frame.run(radius, &SEED_MILL, &[rest]);
            prop_assert_eq!(corner(&steps).0, expected);
            prop_assert!(near(corner(&steps).1, frame.point(x, y)));
        }
        let parameters = Parameters { reversal: Reversal::Alarm, ..SEED_MILL };
        prop_assert_eq!(frame.run(radius, &parameters, &[frame.line(-7, 0)]).1, Some(AlarmKind::Reversal));
    }

    #[test]
    fn fitting_tools(frame in frame()) {
        let arc = frame.arc((0, 20), (0, 10), LEFT);
        let fits = |less: i64| frame.run(frame.length(10) - less, &SEED_MILL, std::slice::from_ref(&arc)).1;
        prop_assert_eq!(fits(0), Some(AlarmKind::RadiusTooSmall));
        prop_assert_eq!(fits(1), None);
    }

    #[test]
    fn half_turns_with_r(frame in frame()) {
        for less in [0, 1] {
            let radius = millimetres(frame.length(10) - less);
            for radius in [radius, -radius] {
                let centre = Centre::Radius(radius);
                let arc = Block::moving(Movement::Arc { end: frame.point(0, 20), centre, direction: LEFT });
                let expected = if less == 0 { None } else { Some(AlarmKind::NoSuchArc) };
                let (steps, alarm) = frame.run(frame.length(2), &SEED_MILL, &[arc]);
                prop_assert_eq!(alarm, expected);
                prop_assert!(less > 0 || corner(&steps).0 == clause::TRC_CORNER_02);
            }
        }
    }

    #[test]
    fn touching_curves(frame in frame()) {
        // The offset circle of radius 2 touches the offset line, both 8 away from the program.
        let arc = frame.arc((-16, 12), (-8, 6), LEFT);
        let touch = |more: i64| frame.run(frame.length(8) + more, &SEED_MILL, std::slice::from_ref(&arc));
        let (steps, alarm) = touch(0);
        prop_assert_eq!(alarm, None);
        prop_assert_eq!(corner(&steps).0, clause::TRC_CORNER_04);
        prop_assert!(near(corner(&steps).1, frame.point(-8, 8)));
        prop_assert_eq!(touch(1).1, Some(AlarmKind::NoIntersection));
        prop_assert_eq!(touch(-1).1, None);
    }

    #[test]
    fn contact_at_the_limit(frame in frame()) {
        let (steps, alarm) = frame.run(frame.length(2), &SEED_MILL, &[right(frame.line(0, 20))]);
        prop_assert_eq!((alarm, corner(&steps).0), (None, clause::TRC_SIDE_02));
        prop_assert!(near(corner(&steps).1, frame.point(2, 2)));
        // A tangent full circle: two contact points equally near to P.
        let circle = right(frame.arc((0, 0), (0, 1), LEFT));
        let (steps, _) = frame.run(frame.length(4), &SEED_MILL, &[circle]);
        prop_assert_eq!(corner(&steps).0, clause::TRC_SIDE_03);
        // Parallel lines and concentric circles have none.
        let (steps, _) = frame.run(frame.length(4), &SEED_MILL, &[right(frame.line(-10, 0))]);
        prop_assert_eq!(corner(&steps).0, clause::TRC_SIDE_03);
    }

    #[test]
    fn grooves_as_wide_as_the_tool(frame in frame()) {
        let parameters = Parameters { reversed_path: ReversedPath::Alarm, ..SEED_MILL };
        let groove = [frame.line(0, 10), frame.line(-50, 10)];
        let alarm = |more: i64| frame.run(frame.length(5) + more, &parameters, &groove).1;
        prop_assert_eq!(alarm(0), None);
        prop_assert_eq!(alarm(-1), None);
        prop_assert_eq!(alarm(1), Some(AlarmKind::ReversedLine));
    }

    #[test]
    fn ends_of_arcs(frame in frame()) {
        let exact = Parameters { arc_end_tolerance: Ratio { numerator: 0, denominator: 1 }, ..SEED_MILL };
        let arc = |end| [frame.arc(end, (-8, 6), LEFT)];
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((-16, 12))).1, None);
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((2, 6))).1, None);
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((3, 6))).1, Some(AlarmKind::EndOffArc));
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((-8, 6))).1, Some(AlarmKind::CentreAtEnd));
    }

    #[test]
    fn line_in_of_no_length(frame in frame()) {
        let lost = Parameters { non_moving_allowed: Some(0), ..SEED_MILL };
        let rest = [Block::empty(), frame.arc((0, 20), (0, 10), LEFT)];
        let (steps, alarm) = frame.run(frame.length(2), &lost, &rest);
        prop_assert_eq!(alarm, None);
        prop_assert!(steps.iter().all(|step| step.clause != clause::TRC_LOOK_05));
    }
}
