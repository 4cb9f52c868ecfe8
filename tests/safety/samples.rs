//! Bounds against samples: on paths that go anywhere, no sampled depth exceeds the bounds, and the worst place is as deep
//! as it is said to be. The peer measures the samples: its nearest point and its winding number.

use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{PlineSource, Polyline};
use radcomp::safety::{Contour, Finding, check};
use radcomp_spec::{Direction, Segment, Step};

use super::peer::polyline;
use super::shapes::{Dice, star};
use super::{blocks, lines};

const SAMPLES: u32 = 200;

/// The depth of a tool on the inside of a contour, or on its outside.
fn depth(contour: &Polyline<f64>, inside: bool, radius: f64, [x, y]: [f64; 2]) -> f64 {
    let point = Vector2::new(x, y);
    let distance = contour.closest_point(point, 1e-9).unwrap().distance;
    let free = (contour.winding_number(point) != 0) == inside;
    if free { radius - distance } else { radius + distance }
}

/// Points of a path from (0, 0), with the longest distance between two of them, moves before `from` left out.
fn samples(path: &[Step<f64>], from: usize) -> (Vec<[f64; 2]>, f64) {
    let mut at = [0.0_f64; 2];
    let (mut points, mut spacing) = (Vec::new(), 0.0_f64);
    for step in path {
        let start = at;
        let mut place: Box<dyn Fn(f64) -> [f64; 2]> = Box::new(|_| start);
        let mut length = 0.0;
        match step.segment {
            Segment::Hold => {}
            Segment::Line { end } => {
                length = (end[0] - start[0]).hypot(end[1] - start[1]);
                place = Box::new(move |t| [0, 1].map(|k| start[k] + t * (end[k] - start[k])));
                at = end;
            }
            Segment::Arc { end, centre, direction, .. } => {
                let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]);
                let sign = if direction == Direction::Counterclockwise { 1.0 } else { -1.0 };
                let turn = (sign * (angle(end) - angle(start))).rem_euclid(std::f64::consts::TAU);
                let (first, radius) = (angle(start), (start[0] - centre[0]).hypot(start[1] - centre[1]));
                length = turn * radius;
                place = Box::new(move |t| {
                    let (sine, cosine) = (first + sign * t * turn).sin_cos();
                    [centre[0] + radius * cosine, centre[1] + radius * sine]
                });
                at = end;
            }
        }
        if step.block >= from {
            points.extend((0..=SAMPLES).map(|index| place(f64::from(index) / f64::from(SAMPLES))));
            spacing = spacing.max(length / f64::from(SAMPLES));
        }
    }
    (points, spacing)
}

#[test]
fn no_sample_is_deeper_than_the_bounds() {
    let mut gouging = 0;
    for number in 0..400 {
        let mut dice = Dice::new(7_000_000 + number);
        let shape = star(&mut dice, true);
        let inside = number % 2 == 0;
        let radius = dice.between(500, 12_000) as u32;
        let contour = polyline(&shape);
        if contour.scan_for_self_intersect() {
            continue;
        }
        // Somewhere in the contour's neighbourhood: within the stars' least radius, or anywhere.
        let reach = dice.between(3, 90) as f64;
        let mut anywhere = || [0, 1].map(|_| dice.between(-1000, 1000) as f64 / 1000.0 * reach);
        let mut start = anywhere();
        let mut path = lines(&[(0, start)]);
        for index in 0..8 {
            let end = anywhere();
            let mut step = lines(&[(1, end)]).remove(0);
            if index % 2 == 1 {
                let [along, across] = [0, 1].map(|k| end[k] - start[k]);
                let bow = anywhere()[0] / reach;
                let middle = [0, 1].map(|k| 0.5 * (start[k] + end[k]));
                let centre = [middle[0] - bow * across, middle[1] + bow * along];
                step.segment = Segment::Arc { end, centre, direction: Direction::Clockwise, full: false };
            }
            path.push(step);
            start = end;
        }
        let radius_mm = f64::from(radius) / 1e3;
        let ours = Contour::of(&blocks(&shape.program(if inside { "G41" } else { "G42" }), radius));
        let (points, spacing) = samples(&path, 1);
        let depths = points.into_iter().map(|point| depth(&contour, inside, radius_mm, point));
        let deepest = depths.fold(f64::NEG_INFINITY, f64::max);
        match check(&ours, &path, 1e-3).path {
            Finding::Safe { at_most } => assert!(deepest <= at_most.max(1e-3) + 1e-6, "{number}: {deepest} {at_most}"),
            Finding::Gouges(gouge) => {
                gouging += 1;
                let (low, high) = gouge.depth;
                assert!(deepest <= high + 1e-6 && low <= deepest + spacing, "{number}: {deepest} {gouge:?}");
                let there = depth(&contour, inside, radius_mm, gouge.centre);
                assert!((there - low).abs() < 1e-6, "{number}: {there} {gouge:?}");
                assert!(high - low < 1e-5 * high, "{number}: {gouge:?}");
            }
            finding => panic!("{number}: {finding:?}"),
        }
    }
    assert!(gouging > 100 && gouging < 390, "{gouging}");
}
