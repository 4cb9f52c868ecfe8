//! Seeded choices of sizes, directions and turns, all of them rational.

use radcomp_spec::Direction;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use rug::Rational;

use super::point::{Point, ratio};

/// A stream of choices; one seed and number give one stream, on every platform.
pub(super) struct Choice(ChaCha8Rng);

/// Half-angle tangents n/m whose angles have small denominators: 5, 13, 25, 17, 29.
const HALF_ANGLES: [(i64, i64); 10] = [(1, 2), (1, 3), (2, 3), (1, 5), (1, 7), (3, 4), (1, 4), (3, 5), (2, 5), (1, 1)];

impl Choice {
    pub(super) fn new(seed: u64, kind: u64, number: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed ^ (kind << 56));
        rng.set_stream(number);
        Choice(rng)
    }

    /// A number from 0 to `below - 1`; 0 when `below` is 0.
    pub(super) fn below(&mut self, below: usize) -> usize {
        (self.0.next_u64() % below.max(1) as u64) as usize
    }

    /// A whole number from `low` to `high`, both included.
    pub(super) fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1).max(1) as usize) as i64
    }

    pub(super) fn coin(&mut self) -> bool {
        self.below(2) == 0
    }

    /// One of some things.
    pub(super) fn pick<T: Copy>(&mut self, things: &[T]) -> T {
        things[self.below(things.len())]
    }

    /// A length: a small whole number, or one and a half or a quarter of it.
    pub(super) fn length(&mut self) -> Rational {
        ratio(self.between(1, 12), self.pick(&[1, 1, 1, 2, 4]))
    }

    /// A positive number below 1.
    pub(super) fn part(&mut self) -> Rational {
        let (n, m) = self.pick(&[(1, 2), (1, 4), (3, 4), (1, 5), (4, 5), (1, 10), (9, 10)]);
        ratio(n, m)
    }

    pub(super) fn sense(&mut self) -> Direction {
        self.pick(&[Direction::Clockwise, Direction::Counterclockwise])
    }

    /// A half-angle tangent of at most 1.
    pub(super) fn half_angle(&mut self) -> Rational {
        let (n, m) = self.pick(&HALF_ANGLES);
        ratio(n, m)
    }

    /// A half-angle tangent from 1/7 to 7.
    pub(super) fn any_half_angle(&mut self) -> Rational {
        let tangent = self.half_angle();
        if self.coin() { tangent } else { tangent.recip() }
    }

    /// A unit vector with positive coordinates.
    pub(super) fn slant(&mut self) -> Point {
        let tangent = loop {
            let tangent = self.half_angle();
            if tangent != 1 {
                break tangent;
            }
        };
        unit(&tangent)
    }

    /// A unit vector in any direction, an axis now and then.
    pub(super) fn direction(&mut self) -> Point {
        let quarter = self.quarter();
        if self.below(4) == 0 { quarter } else { self.slant().turned(&quarter) }
    }

    /// A unit vector along an axis.
    pub(super) fn quarter(&mut self) -> Point {
        let (a, b) = self.pick(&[(1, 0), (0, 1), (-1, 0), (0, -1)]);
        Point::new(a, b)
    }

    /// A unit vector whose denominator is a power of five, for figures that multiply several of them.
    pub(super) fn of_fives(&mut self) -> Point {
        let (a, b, h) = self.pick(&[(1, 0, 1), (3, 4, 5), (4, 3, 5), (7, 24, 25), (24, 7, 25)]);
        Point::new(ratio(a, h), ratio(b, h)).turned(&self.quarter())
    }

    /// The angle of an arc, as a unit vector: not nothing, and not a whole turn.
    pub(super) fn sweep(&mut self) -> Point {
        let (a, b, h) =
            self.pick(&[(0, 1, 1), (-1, 0, 1), (0, -1, 1), (3, 4, 5), (4, 3, 5), (-3, 4, 5), (-7, -24, 25)]);
        Point::new(ratio(a, h), ratio(b, h))
    }

    /// The angle of an arc of at most a half turn.
    pub(super) fn short_sweep(&mut self) -> Point {
        let (a, b, h) = self.pick(&[(0, 1, 1), (-1, 0, 1), (3, 4, 5), (4, 3, 5), (-3, 4, 5), (-7, 24, 25)]);
        Point::new(ratio(a, h), ratio(b, h))
    }
}

/// The unit vector at an angle given by the tangent t of its half: `((1 - t²), 2t) / (1 + t²)`.
pub(super) fn unit(tangent: &Rational) -> Point {
    let square = Rational::from(tangent.square_ref());
    let under = Rational::from(&square + 1);
    Point::new((1 - square) / &under, Rational::from(tangent * 2) / under)
}
