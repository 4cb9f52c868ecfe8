//! Labels placed where they cover little.

use radcomp_spec::block::Point;

/// Puts labels beside their points, away from each other and from what is drawn.
#[derive(Debug)]
pub(super) struct Labels {
    drawn: Vec<Point<f64>>,
    taken: Vec<Rectangle>,
    most: Rectangle,
}

#[derive(Clone, Copy, Debug)]
struct Rectangle {
    low: Point<f64>,
    high: Point<f64>,
}

/// Width of a character and height of a line of a label.
const CHARACTER: f64 = 6.7;
const LINE: f64 = 13.0;

impl Labels {
    /// No labels yet; they keep away from these points and inside this part of the picture.
    pub(super) fn new(drawn: Vec<Point<f64>>, low: Point<f64>, high: Point<f64>) -> Self {
        Labels { drawn, taken: Vec::new(), most: Rectangle { low, high } }
    }

    /// The middle of the place for a label of a point.
    pub(super) fn place(&mut self, point: Point<f64>, text: &str) -> Point<f64> {
        // Labels are a few characters.
        let half = [text.chars().count() as f64 * CHARACTER / 2.0 + 1.0, LINE / 2.0];
        let mut best = (f64::MAX, point);
        for distance in [8.0, 16.0, 26.0, 40.0] {
            for direction in 0..12 {
                let (sine, cosine) = (f64::from(direction) * std::f64::consts::TAU / 12.0).sin_cos();
                let middle = [point[0] + cosine * (distance + half[0]), point[1] + sine * (distance + half[1])];
                let cost = self.cost(Rectangle::about(middle, half)) + distance / 20.0;
                if cost < best.0 {
                    best = (cost, middle);
                }
            }
        }
        self.taken.push(Rectangle::about(best.1, half));
        best.1
    }

    fn cost(&self, place: Rectangle) -> f64 {
        let covered = self.drawn.iter().filter(|point| place.holds(**point)).count();
        let overlapping = self.taken.iter().filter(|taken| taken.meets(place)).count();
        let outside = if place.is_within(self.most) { 0.0 } else { 50.0 };
        // A covered label is worse than a covered line.
        covered as f64 + overlapping as f64 * 30.0 + outside
    }
}

impl Rectangle {
    fn about(middle: Point<f64>, half: Point<f64>) -> Self {
        Rectangle { low: [middle[0] - half[0], middle[1] - half[1]], high: [middle[0] + half[0], middle[1] + half[1]] }
    }

    fn holds(&self, point: Point<f64>) -> bool {
        (0..2).all(|axis| self.low[axis] <= point[axis] && point[axis] <= self.high[axis])
    }

    fn meets(&self, other: Rectangle) -> bool {
        (0..2).all(|axis| self.low[axis] < other.high[axis] && other.low[axis] < self.high[axis])
    }

    fn is_within(&self, other: Rectangle) -> bool {
        other.holds(self.low) && other.holds(self.high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_point_do_not_cover_each_other() {
        let mut labels = Labels::new(vec![[100.0, 100.0]], [0.0, 0.0], [200.0, 200.0]);
        for name in ["N10", "N20", "N30"] {
            labels.place([100.0, 100.0], name);
        }
        let taken = &labels.taken;
        for (index, place) in taken.iter().enumerate() {
            assert!(place.is_within(labels.most) && !place.holds([100.0, 100.0]));
            assert!(!taken[..index].iter().any(|other| other.meets(*place)));
        }
    }
}
