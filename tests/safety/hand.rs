//! Cases worked by hand.

use radcomp::safety::{Contour, Finding, Gouge, check};

use super::{blocks, lines, verdict_of};

const STRAIGHT: &str = "G00 X-9 Y9\nG41 D1 G01 X0 Y0 F100\nX100\nG40 Y50";

/// The gouge of a path of lines along a program, which must be proved to within a nanometre.
fn gouge(text: &str, radius: u32, path: &[(usize, [f64; 2])]) -> Gouge {
    let verdict = check(&Contour::of(&blocks(text, radius)), &lines(path), 1e-6);
    let gouge = *verdict.gouge().unwrap_or_else(|| panic!("{verdict:?}"));
    assert!(gouge.depth.0 <= gouge.depth.1 && gouge.depth.1 - gouge.depth.0 < 1e-6 * gouge.depth.1, "{gouge:?}");
    gouge
}

fn assert_near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 2e-6, "{value} is not {expected}");
}

#[test]
fn a_parallel_path_is_safe() {
    let contour = Contour::of(&blocks(STRAIGHT, 5000));
    let verdict = check(&contour, &lines(&[(1, [0.0, 5.0]), (2, [100.0, 5.0]), (3, [100.0, 50.0])]), 1e-9);
    assert!(matches!(verdict.path, Finding::Safe { at_most } if at_most.abs() < 1e-12), "{verdict:?}");
    assert_eq!(verdict.uncut, None);
}

#[test]
fn a_tilted_path_gouges_at_its_end() {
    let gouge = gouge(STRAIGHT, 5000, &[(1, [0.0, 5.0]), (2, [100.0, 4.7])]);
    assert_near(gouge.depth.0, 0.3);
    assert_eq!((gouge.path_block, gouge.contour_block), (2, 2));
    assert_near(gouge.contour[0], 100.0);
    assert_near(gouge.centre[1], 4.7);
}

#[test]
fn the_wrong_side_is_two_radii_deep() {
    assert_near(gouge(STRAIGHT, 5000, &[(1, [0.0, -5.0]), (2, [100.0, -5.0])]).depth.0, 10.0);
}

#[test]
fn far_on_the_wrong_side_is_deeper() {
    let gouge = gouge(STRAIGHT, 5000, &[(1, [0.0, 5.0]), (2, [50.0, -40.0]), (2, [100.0, 5.0])]);
    assert_near(gouge.depth.0, 45.0);
    assert_near(gouge.contour[0], 50.0);
}

/// An end of an open contour says nothing of what lies beyond it.
#[test]
fn beyond_the_end_there_is_no_material() {
    let contour = Contour::of(&blocks(STRAIGHT, 5000));
    let path = lines(&[(1, [0.0, 5.0]), (2, [105.0, 5.0]), (2, [105.0, -20.0])]);
    assert!(check(&contour, &path, 1e-9).is_safe());
}

/// Ending the block before an inner corner on its normal cuts into the next one by r·(1 - cos φ); the wall is 100 long.
#[test]
fn an_inner_corner_without_its_intersection() {
    for (end, cosine) in [("X100 Y100", 0.0), ("X160 Y80", 0.6), ("X180 Y60", 0.8), ("X20 Y60", -0.8)] {
        let text = format!("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F100\nX100\n{end}\nG40 X0 Y100");
        let [x, y]: [f64; 2] = match end {
            "X100 Y100" => [100.0, 100.0],
            "X160 Y80" => [160.0, 80.0],
            "X180 Y60" => [180.0, 60.0],
            _ => [20.0, 60.0],
        };
        let along = [(x - 100.0) / 100.0, y / 100.0];
        let end = [x - 5.0 * along[1], y + 5.0 * along[0]];
        let gouge = gouge(&text, 5000, &[(1, [0.0, 5.0]), (2, [100.0, 5.0]), (2, end)]);
        // Where the next wall leans over by more than a right angle the centre comes to stand behind it.
        assert_near(gouge.depth.0, 5.0 * (1.0 - cosine));
    }
}

/// [TRC-LOOK-03]: three dwells where two are allowed, and the exact model's own path.
#[test]
fn lost_look_ahead_gouges_by_its_advisory() {
    let verdict =
        verdict_of("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX20\nG04 P1\nG04 P1\nG04 P1\nX44 Y32\nG40 X0", 5000, 1e-9);
    let gouge = verdict.gouge().unwrap();
    assert_near(gouge.depth.0, 5.0 * 0.4);
    assert_eq!(gouge.contour_block, 6);
}

/// The tool is wider than the groove: on its ground it comes 1 mm too near to either wall.
#[test]
fn a_groove_narrower_than_the_tool() {
    let verdict = verdict_of("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX20\nY-20\nX24\nY0\nX40\nG40 Y9", 3000, 1e-9);
    let gouge = verdict.gouge().unwrap_or_else(|| panic!("{verdict:?}"));
    assert!(gouge.depth.0 >= 2.0 - 1e-6, "{gouge:?}");
}

#[test]
fn a_groove_as_wide_as_the_tool_is_safe() {
    let verdict = verdict_of("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX20\nY-20\nX24\nY0\nX40\nG40 Y9", 2000, 1e-9);
    assert!(verdict.is_safe() && verdict.uncut.is_none(), "{verdict:?}");
}

/// A tool that fits and passes by leaves the groove uncut: both walls and the ground.
#[test]
fn a_groove_that_was_passed_by_is_left_uncut() {
    let contour = Contour::of(&blocks("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX20\nY-20\nX30\nY0\nX50\nG40 Y9", 3000));
    let verdict = check(&contour, &lines(&[(1, [0.0, 3.0]), (2, [50.0, 3.0]), (7, [50.0, 9.0])]), 1e-6);
    assert!(verdict.is_safe(), "{verdict:?}");
    let uncut = verdict.uncut.unwrap();
    // The tool reaches its own height down the walls, and has no room in the last 3 mm above the ground.
    assert_near(uncut.length, 17.0);
    assert_eq!(uncut.contour_block, 3);
    assert!((uncut.from[1]).abs() < 0.01 && (uncut.to[1] + 17.0).abs() < 0.01, "{uncut:?}");
}

/// A tool too wide for the groove passes over it, and nothing is left that it could have cut.
#[test]
fn what_the_tool_cannot_enter_is_not_uncut() {
    let contour = Contour::of(&blocks("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX20\nY-20\nX24\nY0\nX50\nG40 Y9", 3000));
    let verdict = check(&contour, &lines(&[(1, [0.0, 3.0]), (2, [50.0, 3.0]), (7, [50.0, 9.0])]), 1e-6);
    assert!(verdict.is_safe() && verdict.uncut.is_none(), "{verdict:?}");
}

/// Straight on with a change of side: the crossing is the program's, and is counted, not judged.
#[test]
fn a_change_of_side_crosses() {
    let verdict = verdict_of("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX50\nG42 X100\nG40 Y-9", 3000, 1e-9);
    assert!(verdict.is_safe(), "{verdict:?}");
    assert_eq!(verdict.crossings, 1);
}

/// A tool that does not change sides gouges the new stretch.
#[test]
fn a_change_of_side_that_is_not_made_gouges() {
    let path = [(1, [0.0, 3.0]), (2, [50.0, 3.0]), (3, [100.0, 3.0])];
    assert_near(gouge("G00 X-9 Y9\nG41 D1 G01 X0 Y0 F1\nX50\nG42 X100\nG40 Y-9", 3000, &path).depth.0, 6.0);
}

/// A start-up through the part is the program's doing, and is reported apart.
#[test]
fn a_start_up_from_behind_is_reported_apart() {
    let verdict = verdict_of("G00 X50 Y-50\nG41 D1 G01 X0 Y0 F1\nX100\nG40 Y50", 3000, 1e-9);
    assert!(verdict.is_safe(), "{verdict:?}");
    assert!(matches!(verdict.start_up, Finding::Gouges(gouge) if gouge.path_block == 1), "{verdict:?}");
    assert!(matches!(verdict.cancel, Finding::Safe { .. }));
}

/// The contour's last block runs on past the point where it began.
#[test]
fn running_on_past_the_start_is_no_gouge() {
    let verdict = verdict_of(include_str!("../../examples/first.nc"), 5000, 1e-9);
    assert!(verdict.is_safe(), "{verdict:?}");
}

/// Arcs lead to the contour and away from it.
#[test]
fn leads_are_no_contour() {
    let text = "G00 X-60 Y60\nG41 D1 G01 X-30 Y60 F1\nG03 X0 Y30 I30 J0\nG01 X50\nY-30\nX-50\nY30\nX0\n\
                G03 X30 Y60 I0 J30\nG01 G40 X60";
    let verdict = verdict_of(text, 5000, 1e-9);
    assert!(verdict.is_safe() && verdict.uncut.is_none(), "{verdict:?}");
}

/// [TRC-ARC-07] a full circle from the inside: the path is a circle of 25 mm.
#[test]
fn a_full_circle() {
    let text = "G00 X5 Y0\nG41 D1 G01 X30 Y0 F1\nG03 X30 Y0 I-30 J0\nG40 G01 X5";
    let verdict = verdict_of(text, 5000, 1e-9);
    assert!(verdict.is_safe() && verdict.uncut.is_none(), "{verdict:?}");
}

#[test]
fn numbers_that_are_none_are_out_of_range() {
    let contour = Contour::of(&blocks(STRAIGHT, 5000));
    let verdict = check(&contour, &lines(&[(1, [0.0, 5.0]), (2, [f64::NAN, 5.0])]), 1e-9);
    assert_eq!(verdict.path, Finding::OutOfRange { block: 2 });
}
