//! The exact model's paths are safe, and nothing that is moved toward the part is.

use proptest::prelude::*;
use radcomp::safety::{Contour, check};
use radcomp_spec::{OuterCorner, Segment, Step};

use super::shapes::{Dice, Shape, star};
use super::{blocks, mill, model_path};

/// A radius, in thousandths, with which a tool neither finds a wedge nor comes near two walls at once.
fn small_radius(shape: &Shape) -> u32 {
    let corners = shape.bulges();
    let count = corners.len();
    let mut room = f64::INFINITY;
    for (index, corner) in corners.iter().enumerate() {
        for (other, start) in corners.iter().enumerate() {
            let end = corners[(other + 1) % count];
            if other != index && (other + 1) % count != index {
                let w = [end[0] - start[0], end[1] - start[1]];
                let v = [corner[0] - start[0], corner[1] - start[1]];
                let along = ((v[0] * w[0] + v[1] * w[1]) / (w[0] * w[0] + w[1] * w[1])).clamp(0.0, 1.0);
                room = room.min((v[0] - along * w[0]).hypot(v[1] - along * w[1]));
            }
        }
    }
    // Half a turn of 150° at a corner needs 3.7 radii of its edge.
    (room * 1e3 / 12.0) as u32
}

/// A step moved toward the part by a distance, with lines to it and back: the arcs beside it keep their radii.
fn moved(path: &[Step<f64>], which: usize, by: f64, left: bool) -> Vec<Step<f64>> {
    let end_of = |step: &Step<f64>| match step.segment {
        Segment::Line { end } | Segment::Arc { end, .. } => end,
        Segment::Hold => unreachable!("programs without dwells"),
    };
    let from = end_of(&path[which - 1]);
    let end = end_of(&path[which]);
    let toward_right = match path[which].segment {
        Segment::Arc { centre, direction, .. } => {
            let middle = [(from[0] + end[0]) / 2.0 - centre[0], (from[1] + end[1]) / 2.0 - centre[1]];
            let out = middle[0].hypot(middle[1]);
            let sign = if direction == radcomp_spec::Direction::Counterclockwise { 1.0 } else { -1.0 };
            [sign * middle[0] / out, sign * middle[1] / out]
        }
        _ => {
            let length = (end[0] - from[0]).hypot(end[1] - from[1]);
            [(end[1] - from[1]) / length, (from[0] - end[0]) / length]
        }
    };
    let shift = toward_right.map(|part| if left { by * part } else { -by * part });
    let shifted = |p: [f64; 2]| [p[0] + shift[0], p[1] + shift[1]];
    let line = |end| Step { segment: Segment::Line { end }, ..path[which].clone() };
    let beside = match path[which].segment {
        Segment::Arc { centre, direction, full, .. } => {
            let segment = Segment::Arc { end: shifted(end), centre: shifted(centre), direction, full };
            Step { segment, ..path[which].clone() }
        }
        _ => line(shifted(end)),
    };
    [&path[..which], &[line(shifted(from)), beside, line(end)], &path[which + 1..]].concat()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn exact_paths_are_safe_and_moved_ones_are_not(seed: u64, arcs: bool, left: bool, round: bool, which: usize) {
        let mut dice = Dice::new(seed);
        let shape = star(&mut dice, arcs);
        let radius = small_radius(&shape);
        prop_assume!(radius > 20);
        let mut parameters = mill().parameters;
        parameters.outer_corner = if round { OuterCorner::Arc } else { OuterCorner::Intersection };
        let blocks = blocks(&shape.program(if left { "G41" } else { "G42" }), radius);
        let outcome = radcomp_model::run(&parameters, &blocks);
        prop_assume!(outcome.alarm.is_none() && outcome.advisories.is_empty());
        let contour = Contour::of(&blocks);
        let path = model_path(&parameters, &blocks);
        let verdict = check(&contour, &path, 1e-9);
        // Arcs may bulge into each other or across another edge: the peer's test sorts those out.
        prop_assume!(!arcs || verdict.is_safe());
        prop_assert!(verdict.is_safe(), "{:?}", verdict);
        prop_assert!(verdict.uncut.is_none(), "{:?}", verdict);
        let main: Vec<usize> = (1..path.len() - 1).filter(|index| path[*index].main && path[*index].block > 0).collect();
        let path = moved(&path, main[which % main.len()], 1e-3, left);
        let verdict = check(&contour, &path, 1e-7);
        let gouge = verdict.gouge();
        prop_assert!(gouge.is_some_and(|gouge| gouge.depth.0 > 0.3e-3 && gouge.depth.1 < 1.5e-3), "{:?}", verdict);
    }
}
