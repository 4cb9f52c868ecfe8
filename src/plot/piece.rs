//! Straight and circular pieces of a drawing.

use std::f64::consts::TAU;

use radcomp_spec::Direction;
use radcomp_spec::block::Point;

/// A straight or circular piece, in millimetres.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Where it starts.
    pub start: Point<f64>,
    /// Where it ends.
    pub end: Point<f64>,
    /// What lies between.
    pub form: Form,
    /// What it belongs to.
    pub trace: Trace,
}

/// The form of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A straight line.
    Straight,
    /// An arc about a centre.
    Arc {
        /// Centre.
        centre: Point<f64>,
        /// Sense.
        direction: Direction,
        /// A whole turn.
        full: bool,
    },
}

/// What a piece belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trace {
    /// The programmed contour.
    Programmed,
    /// A programmed start-up or cancel move.
    Lead,
    /// A programmed move that the tool's centre follows itself: it is drawn as such.
    Followed,
    /// The programmed block that raises the alarm.
    Refused,
    /// The centre path in offset mode, start-up and cancel moves among it.
    Compensated,
    /// A corner move.
    Corner,
    /// The centre path in cancel mode.
    Uncompensated,
    /// The centre path at rapid traverse.
    Rapid,
}

impl Piece {
    /// The angle at its start and the angle it sweeps, in radians, positive counter-clockwise; none if it is straight.
    pub fn sweep(&self) -> Option<(f64, f64)> {
        let Form::Arc { centre, direction, full } = self.form else { return None };
        let angle = |point: Point<f64>| (point[1] - centre[1]).atan2(point[0] - centre[0]);
        let (from, to) = (angle(self.start), angle(self.end));
        let sweep = match (full, direction) {
            (true, Direction::Counterclockwise) => TAU,
            (true, Direction::Clockwise) => -TAU,
            (false, Direction::Counterclockwise) => (to - from).rem_euclid(TAU),
            (false, Direction::Clockwise) => -(from - to).rem_euclid(TAU),
        };
        Some((from, sweep))
    }

    /// Its radius; none if it is straight.
    pub fn radius(&self) -> Option<f64> {
        let Form::Arc { centre, .. } = self.form else { return None };
        Some((self.start[0] - centre[0]).hypot(self.start[1] - centre[1]))
    }

    /// Its length.
    pub fn length(&self) -> f64 {
        match self.sweep().zip(self.radius()) {
            Some(((_, sweep), radius)) => radius * sweep.abs(),
            None => (self.end[0] - self.start[0]).hypot(self.end[1] - self.start[1]),
        }
    }

    /// The point at a part of its length from 0 to 1, and the heading there in radians.
    pub fn at(&self, part: f64) -> (Point<f64>, f64) {
        if let (Some((from, sweep)), Some(radius), Form::Arc { centre, .. }) = (self.sweep(), self.radius(), self.form)
        {
            let angle = from + sweep * part;
            let quarter = std::f64::consts::FRAC_PI_2.copysign(sweep);
            return ([centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()], angle + quarter);
        }
        let along = [self.end[0] - self.start[0], self.end[1] - self.start[1]];
        ([self.start[0] + along[0] * part, self.start[1] + along[1] * part], along[1].atan2(along[0]))
    }

    /// Its ends, and of an arc the points that are outermost along an axis.
    pub fn extremes(&self) -> Vec<Point<f64>> {
        let mut points = vec![self.start, self.end];
        if let (Some((from, sweep)), Some(radius), Form::Arc { centre, .. }) = (self.sweep(), self.radius(), self.form)
        {
            for quarter in 0..4 {
                let angle = f64::from(quarter) * TAU / 4.0;
                let ahead = if sweep < 0.0 { (from - angle).rem_euclid(TAU) } else { (angle - from).rem_euclid(TAU) };
                if ahead <= sweep.abs() {
                    points.push([centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()]);
                }
            }
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_reaches_beyond_its_ends() {
        let form = Form::Arc { centre: [0.0, 0.0], direction: Direction::Clockwise, full: false };
        let half = Piece { start: [-2.0, 0.0], end: [2.0, 0.0], form, trace: Trace::Programmed };
        let highest = half.extremes().iter().map(|point| point[1]).fold(f64::MIN, f64::max);
        let lowest = half.extremes().iter().map(|point| point[1]).fold(f64::MAX, f64::min);
        assert!((highest - 2.0).abs() < 1e-12 && lowest > -1e-12);
        assert!((half.length() - TAU).abs() < 1e-12);
        assert!(half.at(0.5).1.abs() < 1e-12);
    }
}
