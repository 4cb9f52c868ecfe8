//! Geometry that is degenerate in decimals, turned by Pythagorean angles and moved far from the origin: rounding to
//! f64 hides it, and the engine must find it all the same. A least increment beside it, the other case.

#[path = "../common/mod.rs"]
mod common;
mod frame;
mod limits;

use common::SEED_MILL;
use frame::{LEFT, corner, frame, millimetres, near, right};
use proptest::prelude::*;
use radcomp_spec::parameters::*;
use radcomp_spec::{AlarmKind, Block, Centre, Movement, clause};

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
        let parameters = Parameters { reversal: Reversal::Alarm, ..*SEED_MILL };
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
        let parameters = Parameters { reversed_path: ReversedPath::Alarm, ..*SEED_MILL };
        let groove = [frame.line(0, 10), frame.line(-50, 10)];
        let alarm = |more: i64| frame.run(frame.length(5) + more, &parameters, &groove).1;
        prop_assert_eq!(alarm(0), None);
        prop_assert_eq!(alarm(-1), None);
        prop_assert_eq!(alarm(1), Some(AlarmKind::ReversedLine));
    }

    #[test]
    fn ends_of_arcs(frame in frame()) {
        let exact = Parameters { arc_end_tolerance: Ratio { numerator: 0, denominator: 1 }, ..*SEED_MILL };
        let arc = |end| [frame.arc(end, (-8, 6), LEFT)];
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((-16, 12))).1, None);
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((2, 6))).1, None);
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((3, 6))).1, Some(AlarmKind::EndOffArc));
        prop_assert_eq!(frame.run(frame.length(1), &exact, &arc((-8, 6))).1, Some(AlarmKind::CentreAtEnd));
    }

    #[test]
    fn line_in_of_no_length(frame in frame()) {
        let lost = Parameters { non_moving_allowed: Some(0), ..*SEED_MILL };
        let rest = [Block::empty(), frame.arc((0, 20), (0, 10), LEFT)];
        let (steps, alarm) = frame.run(frame.length(2), &lost, &rest);
        prop_assert_eq!(alarm, None);
        prop_assert!(steps.iter().all(|step| step.clause != clause::TRC_LOOK_05));
    }
}
