//! Whole lines and arcs in plain f64: what the search for uncut material and for leads reasons with.

use std::f64::consts::TAU;

/// A line or an arc, in millimetres and radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Curve {
    /// Straight.
    Line {
        /// Start.
        start: [f64; 2],
        /// End.
        end: [f64; 2],
    },
    /// Circular.
    Arc {
        /// Centre.
        centre: [f64; 2],
        /// Radius.
        radius: f64,
        /// Angle of the start.
        from: f64,
        /// Angle swept, positive counter-clockwise, from -2π to 2π.
        sweep: f64,
    },
}

/// Distance.
pub(crate) fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1])
}

impl Curve {
    /// The arc from one ray to another.
    pub(crate) fn arc(centre: [f64; 2], start: [f64; 2], end: [f64; 2], ccw: bool, full: bool) -> Self {
        let ray = |p: [f64; 2]| [p[0] - centre[0], p[1] - centre[1]];
        let (a, b) = (ray(start), ray(end));
        let (from, to) = (a[1].atan2(a[0]), b[1].atan2(b[0]));
        let turn = if ccw { to - from } else { from - to }.rem_euclid(TAU);
        let turn = if full { TAU } else { turn };
        let radius = 0.5 * (a[0].hypot(a[1]) + b[0].hypot(b[1]));
        Curve::Arc { centre, radius, from, sweep: if ccw { turn } else { -turn } }
    }

    /// The point at a fraction of the length, 0 the start and 1 the end.
    pub(crate) fn at(&self, fraction: f64) -> [f64; 2] {
        match *self {
            Curve::Line { start, end } => {
                [start[0] + fraction * (end[0] - start[0]), start[1] + fraction * (end[1] - start[1])]
            }
            Curve::Arc { centre, radius, from, sweep } => {
                let (sine, cosine) = (from + fraction * sweep).sin_cos();
                [centre[0] + radius * cosine, centre[1] + radius * sine]
            }
        }
    }

    /// Length in millimetres.
    pub(crate) fn length(&self) -> f64 {
        match *self {
            Curve::Line { start, end } => distance(start, end),
            Curve::Arc { radius, sweep, .. } => radius * sweep.abs(),
        }
    }

    /// The unit vector to the left of the direction of travel.
    pub(crate) fn left(&self, fraction: f64) -> [f64; 2] {
        match *self {
            Curve::Line { start, end } => {
                let length = distance(start, end);
                [(start[1] - end[1]) / length, (end[0] - start[0]) / length]
            }
            Curve::Arc { from, sweep, .. } => {
                let (sine, cosine) = (from + fraction * sweep).sin_cos();
                let inward = -sweep.signum();
                [inward * cosine, inward * sine]
            }
        }
    }

    /// The curve moved to its left by a distance; none if nothing of an arc is left.
    pub(crate) fn moved_left(&self, by: f64) -> Option<Curve> {
        match *self {
            Curve::Line { start, end } => {
                let n = self.left(0.0);
                let shift = |p: [f64; 2]| [p[0] + by * n[0], p[1] + by * n[1]];
                Some(Curve::Line { start: shift(start), end: shift(end) })
            }
            Curve::Arc { centre, radius, from, sweep } => {
                let radius = radius - by * sweep.signum();
                (radius > 0.0).then_some(Curve::Arc { centre, radius, from, sweep })
            }
        }
    }

    /// The fraction at which an angle about the centre lies, if the arc reaches it; any line gives none.
    fn fraction_of(&self, angle: f64) -> Option<f64> {
        let Curve::Arc { from, sweep, .. } = *self else { return None };
        if sweep == 0.0 {
            return None;
        }
        let turn = ((angle - from) * sweep.signum()).rem_euclid(TAU);
        let fraction = turn / sweep.abs();
        (fraction <= 1.0).then_some(fraction)
    }

    /// Distance of a point from the curve, and the fraction of the nearest point.
    pub(crate) fn nearest(&self, q: [f64; 2]) -> (f64, f64) {
        let inner = match *self {
            Curve::Line { start, end } => {
                let w = [end[0] - start[0], end[1] - start[1]];
                let squared = w[0] * w[0] + w[1] * w[1];
                let along = ((q[0] - start[0]) * w[0] + (q[1] - start[1]) * w[1]) / squared;
                (0.0..=1.0).contains(&along).then_some(along)
            }
            Curve::Arc { centre, .. } => self.fraction_of((q[1] - centre[1]).atan2(q[0] - centre[0])),
        };
        let mut best = (distance(q, self.at(0.0)), 0.0);
        for fraction in [Some(1.0), inner].into_iter().flatten() {
            let off = distance(q, self.at(fraction));
            if off < best.0 {
                best = (off, fraction);
            }
        }
        best
    }

    /// The fractions in \[0, 1\] at which the curve crosses a circle.
    pub(crate) fn meets_circle(&self, about: [f64; 2], radius: f64, found: &mut Vec<f64>) {
        match *self {
            Curve::Line { start, end } => {
                let w = [end[0] - start[0], end[1] - start[1]];
                let v = [start[0] - about[0], start[1] - about[1]];
                let squared = w[0] * w[0] + w[1] * w[1];
                let foot = -(v[0] * w[0] + v[1] * w[1]) / squared;
                let off = (w[0] * v[1] - w[1] * v[0]).powi(2) / squared;
                let rest = radius * radius - off;
                if rest >= 0.0 {
                    let half = (rest / squared).sqrt();
                    found.extend([foot - half, foot + half].into_iter().filter(|t| (0.0..=1.0).contains(t)));
                }
            }
            Curve::Arc { centre, radius: own, .. } => {
                let to = [about[0] - centre[0], about[1] - centre[1]];
                let apart = to[0].hypot(to[1]);
                if apart == 0.0 {
                    return;
                }
                let cosine = (own * own + apart * apart - radius * radius) / (2.0 * own * apart);
                if cosine.abs() <= 1.0 {
                    let (axis, half) = (to[1].atan2(to[0]), cosine.acos());
                    found.extend([axis - half, axis + half].into_iter().filter_map(|angle| self.fraction_of(angle)));
                }
            }
        }
    }

    /// The fractions in \[0, 1\] at which the curve crosses an infinite line through a point with a unit direction.
    pub(crate) fn meets_line(&self, through: [f64; 2], along: [f64; 2], found: &mut Vec<f64>) {
        let off = |p: [f64; 2]| along[0] * (p[1] - through[1]) - along[1] * (p[0] - through[0]);
        match *self {
            Curve::Line { start, end } => {
                let (from, to) = (off(start), off(end));
                let fraction = from / (from - to);
                if (0.0..=1.0).contains(&fraction) {
                    found.push(fraction);
                }
            }
            Curve::Arc { centre, radius, .. } => {
                let sine = off(centre) / radius;
                if sine.abs() <= 1.0 {
                    // The point at angle θ lies off(centre) + radius·sin(θ - direction) from the line.
                    let (direction, half) = (along[1].atan2(along[0]), (-sine).asin());
                    let angles = [direction + half, direction + std::f64::consts::PI - half];
                    found.extend(angles.into_iter().filter_map(|angle| self.fraction_of(angle)));
                }
            }
        }
    }

    /// The intervals of the fraction on which the curve lies within a distance of another one.
    ///
    /// # Exactness
    ///
    /// The ends are roots in closed form, in f64; between two of them the answer is one point's.
    pub(crate) fn within(&self, other: &Curve, reach: f64) -> Vec<[f64; 2]> {
        let mut ends = vec![0.0, 1.0];
        for tip in [other.at(0.0), other.at(1.0)] {
            self.meets_circle(tip, reach, &mut ends);
        }
        match *other {
            Curve::Line { start, end } => {
                let (length, n) = (distance(start, end), other.left(0.0));
                let along = [(end[0] - start[0]) / length, (end[1] - start[1]) / length];
                for by in [reach, -reach] {
                    self.meets_line([start[0] + by * n[0], start[1] + by * n[1]], along, &mut ends);
                }
            }
            Curve::Arc { centre, radius, .. } => {
                self.meets_circle(centre, radius + reach, &mut ends);
                self.meets_circle(centre, (radius - reach).abs(), &mut ends);
            }
        }
        ends.sort_by(f64::total_cmp);
        let parts = ends.windows(2).filter(|part| part[1] > part[0]);
        let near = parts.filter(|part| other.nearest(self.at(0.5 * (part[0] + part[1]))).0 <= reach);
        near.map(|part| [part[0], part[1]]).collect()
    }
}
