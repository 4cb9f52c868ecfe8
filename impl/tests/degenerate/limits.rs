//! Limits that a profile sets, met exactly; and contact points of a small tool, missed by little.

use proptest::prelude::*;
use radcomp_spec::parameters::*;
use radcomp_spec::{AlarmKind, Block, Centre, Compensation, Direction, Movement, Segment, Side, clause};

use crate::common::{SEED_MILL, run};
use crate::frame::{LEFT, corner, frame, millimetres, near, right};

const fn thousandths(numerator: u32) -> Ratio {
    Ratio { numerator, denominator: 1000 }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn limit_angles(frame in frame()) {
        // cos α = 0.6, [TRC-CORNER-13], and M = (10, 5) in units of half the radius.
        let rest = [frame.line(-6, -8)];
        let clause = |limit| {
            let by = Parameters { outer_corner: OuterCorner::LimitAngle, corner_limit_cosine: limit, ..*SEED_MILL };
            corner(&frame.run(frame.length(5), &by, &rest).0)
        };
        prop_assert_eq!(clause(thousandths(600)).0, clause::TRC_CORNER_13);
        prop_assert!(near(clause(thousandths(600)).1, frame.point(10, 5)));
        prop_assert_eq!(clause(thousandths(599)).0, clause::TRC_CORNER_10);
        // At right angles the limit 0 is met exactly.
        let square = Parameters { outer_corner: OuterCorner::LimitAngle, ..*SEED_MILL };
        let corner_of = |rest| corner(&frame.run(frame.length(5), &square, &[rest]).0).0;
        prop_assert_eq!(corner_of(frame.line(0, -10)), clause::TRC_CORNER_06);
        prop_assert_eq!(corner_of(frame.line(-1, -100)), clause::TRC_CORNER_10);
        prop_assert_eq!(corner_of(frame.line(-10, 0)), clause::TRC_CORNER_10);
    }

    #[test]
    fn smallest_corners(frame in frame()) {
        let clause = |cosine| {
            let smallest = Parameters { cancel: Cancel::TypeB, smallest_corner_cosine: thousandths(cosine), ..*SEED_MILL };
            let cancel = Block { compensation: Some(Compensation::Off), ..frame.line(-6, -8) };
            corner(&frame.run(frame.length(5), &smallest, &[cancel]).0).0
        };
        prop_assert_eq!(clause(600), clause::TRC_CANCEL_05);
        prop_assert_eq!(clause(599), clause::TRC_CANCEL_01);
    }

    #[test]
    fn straight_bands(frame in frame()) {
        for (y, other) in [(7, clause::TRC_CORNER_03), (-7, clause::TRC_CORNER_06)] {
            let clause = |numerator| {
                let straight = Ratio { numerator, denominator: 10_000 };
                let straight = Parameters { straight_band_cosine: straight, ..*SEED_MILL };
                corner(&frame.run(frame.length(5), &straight, &[frame.line(24, y)]).0).0
            };
            prop_assert_eq!(clause(9600), clause::TRC_CORNER_16);
            prop_assert_eq!(clause(9601), other);
        }
    }

    #[test]
    fn radii_that_are_equal(frame in frame()) {
        let point = Parameters { equal_radius: EqualRadius::DegeneratePoint, ..*SEED_MILL };
        let arc = frame.arc((0, 20), (0, 10), LEFT);
        let runs = |more: i64| frame.run(frame.length(10) + more, &point, std::slice::from_ref(&arc));
        let (steps, alarm) = runs(0);
        prop_assert_eq!(alarm, None);
        let own = steps.last().unwrap();
        let Segment::Line { end } = own.segment else { panic!("a straight move") };
        prop_assert!(near(end, frame.point(0, 10)));
        prop_assert_eq!(runs(1).1, Some(AlarmKind::RadiusTooSmall));
        let arc_move = runs(-1).0.pop().unwrap().segment;
        let is_arc = matches!(arc_move, Segment::Arc { .. });
        prop_assert!(is_arc);
    }

    #[test]
    fn entries_as_long_as_the_tool(frame in frame()) {
        // The start-up block of the frame runs over 10.
        let entry = Parameters { start_up: StartUp::EntryNormal, ..*SEED_MILL };
        prop_assert_eq!(frame.run(frame.length(10), &entry, &[]).1, Some(AlarmKind::EntryTooShort));
        prop_assert_eq!(frame.run(frame.length(10) - 1, &entry, &[]).1, None);
    }

    #[test]
    fn entries_that_turn_by_a_right_angle(frame in frame()) {
        // From (0, 0) about (-4, 3) to (1, 3), the tool inside.
        let entry = Parameters { start_up_arc: StartUpArc::MovedCentre, ..*SEED_MILL };
        let arc = |radius| {
            let arc = frame.arc((1, 3), (-4, 3), LEFT);
            let start = Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(radius), ..arc };
            run(&entry, &[frame.line(0, 0), start]).1.map(|alarm| alarm.kind)
        };
        // V = E - r·e with e = (1, 0), and S - V = (r - 1, -3): r = 1.
        prop_assert_eq!(arc(millimetres(frame.length(1))), Some(AlarmKind::NoEntryArc));
        prop_assert_eq!(arc(millimetres(frame.length(1) + 1)), Some(AlarmKind::NoEntryArc));
        prop_assert_eq!(arc(millimetres(frame.length(1) - 1)), None);
    }

    #[test]
    fn curves_that_touch_beyond_a_corner(frame in frame()) {
        // [TRC-CORNER-14]: about (8, 0), R' = 8 - r and h = r.
        let curve = Parameters { arc_extension: ArcExtension::Curve, ..*SEED_MILL };
        let arc = frame.arc((8, -8), (8, 0), LEFT);
        let runs = |more: i64| frame.run(frame.length(4) + more, &curve, std::slice::from_ref(&arc));
        let (steps, alarm) = runs(0);
        prop_assert_eq!((alarm, corner(&steps).0), (None, clause::TRC_CORNER_14));
        prop_assert!(near(corner(&steps).1, frame.point(8, 4)));
        prop_assert_eq!(runs(1).1, Some(AlarmKind::NoIntersection));
        prop_assert_eq!(corner(&runs(-1).0).0, clause::TRC_CORNER_14);
        // An exact reversal along an arc that the tool runs outside of: √(8² - 4²) beyond the point below.
        let back = frame.arc((-5, -5), (0, -5), LEFT);
        prop_assert_eq!(frame.run(frame.length(2), &curve, &[back]).1, Some(AlarmKind::NoIntersection));
        let back = frame.arc((-5, 5), (0, 5), Direction::Clockwise);
        let (steps, alarm) = frame.run(frame.length(8), &curve, &[back]);
        prop_assert_eq!((alarm, corner(&steps).0), (None, clause::TRC_CORNER_14));
        // R' = 13 and h = 8 - 5 = 3.
        let beyond = 160.0_f64.sqrt() * millimetres(frame.length(1));
        let from = frame.point(0, 8);
        let found = corner(&steps).1;
        let apart = ((found[0] - from[0]).powi(2) + (found[1] - from[1]).powi(2)).sqrt();
        prop_assert!((apart - beyond).abs() <= 1e-9 * (1.0 + from[0].abs().max(from[1].abs()) * 1e-3));
    }

    #[test]
    fn contacts_anywhere(frame in frame()) {
        let anywhere = Parameters { side_change: SideChange::Intersection, ..*SEED_MILL };
        // Straight on into an arc: two points equally near to P.
        let arc = right(frame.arc((5, 5), (0, 5), LEFT));
        let (steps, _) = frame.run(frame.length(1), &anywhere, &[arc]);
        prop_assert_eq!(corner(&steps).0, clause::TRC_SIDE_03);
        // tan(|φ|/2) = 1/3.
        let (steps, _) = frame.run(frame.length(1), &anywhere, &[right(frame.line(8, 6))]);
        prop_assert_eq!(corner(&steps).0, clause::TRC_SIDE_05);
        prop_assert!(near(corner(&steps).1, frame.point(3, 1)));
    }
}

/// A tool of 0.001 at (100, 50), where a millionth of a millimetre on a line of 10 mm moves the contact point by a ten
/// millionth of the radius: far less than coordinates of that size are rounded by, and told all the same.
#[test]
fn contacts_of_a_small_tool() {
    let line = |x: f64, y: f64| Block::moving(Movement::Line { end: [x, y] });
    let radius = 0.001;
    let start = Block { compensation: Some(Compensation::On(Side::Left)), radius: Some(radius), ..line(90.0, 50.0) };
    let clause_of = |block: Block<f64>| {
        let (steps, alarm) = run(&SEED_MILL, &[line(80.0, 50.0), start.clone(), line(100.0, 50.0), right(block)]);
        assert_eq!(alarm, None);
        corner(&steps).0
    };
    let (within, beyond) = (clause::TRC_SIDE_02, clause::TRC_SIDE_03);
    // Two lines at right angles: the contact is one radius beyond the first.
    assert_eq!(clause_of(line(100.0, 60.0)), within);
    assert_eq!(clause_of(line(100.0 - 1e-9, 60.0)), within);
    assert_eq!(clause_of(line(100.0 + 1e-9, 60.0)), beyond);
    // A line and an arc of about 10: with q = 10 + r/2 the limit is J = (q² - 10²) / 2q.
    let q = 10.0 + radius / 2.0;
    let limit = (q * q - 100.0) / (2.0 * q);
    let arc = |j: f64| {
        let centre = Centre::FromStart([-10.0, j]);
        Block::moving(Movement::Arc { end: [80.0, 50.0 + 2.0 * j], centre, direction: LEFT })
    };
    assert_eq!(clause_of(arc(limit + 1e-9)), beyond);
    assert_eq!(clause_of(arc(limit - 1e-9)), within);
}
