//! The least that compensation of a contour of lines can cost: at every vertex the mitre point, and nothing else.

use radcomp_spec::block::Point;

/// The sum of the mitre points left of the closed contour: no state, no cases, nothing stored.
pub fn run(points: &[Point<f64>], radius: f64) -> f64 {
    let Some((&last, _)) = points.split_last() else { return 0.0 };
    let mut sum = 0.0;
    let mut previous = last;
    let mut normal_before = [0.0, 0.0];
    for &point in points {
        let (dx, dy) = (point[0] - previous[0], point[1] - previous[1]);
        let inverse = 1.0 / (dx * dx + dy * dy).sqrt();
        let normal = [-dy * inverse, dx * inverse];
        let scale = radius / (1.0 + normal[0] * normal_before[0] + normal[1] * normal_before[1]);
        sum += previous[0] + scale * (normal[0] + normal_before[0]);
        sum += previous[1] + scale * (normal[1] + normal_before[1]);
        previous = point;
        normal_before = normal;
    }
    sum
}
