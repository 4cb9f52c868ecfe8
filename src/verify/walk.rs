//! Whether an answer is an outcome to within δ.
//!
//! Two walkers follow the two paths from (0, 0), each at any speed, never backwards, and never farther than δ from each
//! other. The answer is the outcome to within δ if both can reach their ends so and the alarms are the same. A verdict
//! that accepts the answer allows the rounding of its coordinates beside δ, [`Reach`]. They pass
//!
//! * blocks without movement together, in the same block;
//! * arcs together: same block, rate, sense and wholeness, and centres no farther than δ apart;
//! * straight moves of one block and rate however the two paths split them: this is the decision procedure of the
//!   Fréchet distance of two polylines (Alt and Godau, *Computing the Fréchet distance between two polygonal curves*,
//!   1995), on straight moves of one block and rate;
//! * a straight move or an arc that is not whole alone, while the other stands within δ of both its ends: a move of no
//!   length to within δ, unless the arc goes the long way round.
//!
//! Of an arc whose ends lie within 2δ of each other its sense tells whether it goes the short way or the long way; where
//! the ends of the answer's arc lie within 16β, its rounding may have put them past each other, and it counts as either.
//!
//! # Exactness
//!
//! Every comparison is exact. Squares of distances are compared with δ², so that the only roots are those of the
//! places where a circle of radius δ cuts a straight move.

use std::collections::BTreeMap;

use radcomp_model::Vector;
use radcomp_model::number::Real;
use radcomp_spec::Direction;
use rug::Rational;

use super::path::{Move, Path, Shape};

/// How an answer differs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Parting {
    /// The paths part.
    Path {
        /// At this block.
        block: usize,
        /// No outcome that begins with as many moves of this one is the answer.
        moves: usize,
    },
    /// The paths are the same, the alarms are not.
    Alarm,
}

/// What is known of one pair of places: so many moves of the outcome, so many of the answer.
#[derive(Default)]
struct Place {
    /// Both walkers may stand at the ends of these moves.
    both: bool,
    /// The answer's walker may stand there while the outcome's is on its next move, this far along at the least.
    outcome_ahead: Option<Real>,
    /// The other way round.
    answer_ahead: Option<Real>,
}

/// How far from the outcome the answer may lie: δ and, for the judge compares coordinates that are rounded to f64, so many
/// units in the last place of the answer's larger coordinate.
pub(super) struct Reach {
    pub(super) delta: Real,
    pub(super) units: i64,
}

impl Reach {
    /// A verdict that accepts: the judge allows a unit, and rounds the outcome's coordinates by half of one.
    pub(super) const ACCEPTING: i64 = 2;
    /// A verdict that refuses.
    pub(super) const REFUSING: i64 = 0;

    /// The square of how far it may lie off at a point of the answer.
    fn squared_at(&self, point: &Vector) -> Real {
        let larger = point.a.abs().max(point.b.abs());
        let unit = Real::rational(Rational::from((self.units, 1_u64 << 52)));
        (&self.delta + &(&larger * &unit)).square()
    }
}

struct Walk<'a> {
    outcome: &'a Path,
    answer: &'a Path,
    reach: &'a Reach,
    /// The square of δ.
    delta_squared: Real,
    /// The square of how far the answer may lie off after so many moves.
    reach_squared: Vec<Real>,
    grain_squared: Real,
    /// Places not looked at yet, in an order in which each comes after those that lead to it.
    places: BTreeMap<(usize, usize), Place>,
}

/// Compares an answer with an outcome.
pub(super) fn compare(outcome: &Path, answer: &Path, reach: &Reach, beta: &Real) -> Result<(), Parting> {
    let start = Place { both: true, ..Place::default() };
    let places = BTreeMap::from([((0, 0), start)]);
    let grain = (beta * &Real::integer(16)).min(reach.delta.clone());
    let (delta_squared, grain_squared) = (reach.delta.square(), grain.square());
    let reach_squared = (0..=answer.moves.len()).map(|moves| reach.squared_at(answer.after(moves))).collect();
    let mut walk = Walk { outcome, answer, reach, delta_squared, reach_squared, grain_squared, places };
    let ends = (outcome.moves.len(), answer.moves.len());
    let mut farthest = (0, 0);
    // The walker on the outcome has come to no move behind this one.
    let mut last = 0;
    while let Some((at, place)) = walk.places.pop_first() {
        if place.both && at == ends {
            return if outcome.alarm == answer.alarm { Ok(()) } else { Err(Parting::Alarm) };
        }
        last = last.max(at.0);
        if at.0 + at.1 >= farthest.0 + farthest.1 {
            farthest = at;
        }
        walk.on(at, place);
    }
    let next = [outcome.moves.get(farthest.0), answer.moves.get(farthest.1)];
    let block = next.into_iter().flatten().map(|element| element.block).min().unwrap_or_default();
    Err(Parting::Path { block, moves: last + 1 })
}

impl Walk<'_> {
    /// Notes every place that can be reached next.
    fn on(&mut self, (i, j): (usize, usize), mut place: Place) {
        let (outcome, answer) = (self.outcome, self.answer);
        let (here, there) = (outcome.moves.get(i), answer.moves.get(j));
        if place.both {
            place.outcome_ahead = Some(Real::zero());
            place.answer_ahead = Some(Real::zero());
            let no_way =
                |path: &Path, at, way| way != Way::Long && path.moves.get(at).is_some_and(Move::may_have_no_length);
            if no_way(outcome, i, self.way(outcome, i, &Real::zero())) && self.near(i + 1, j) {
                self.reach(i + 1, j).both = true;
            }
            if no_way(answer, j, self.way(answer, j, &self.grain_squared)) && self.near(i, j + 1) {
                self.reach(i, j + 1).both = true;
            }
        }
        let (Some(here), Some(there)) = (here, there) else { return };
        if here.is_line_like(there) {
            self.straight((i, j), place);
        } else if place.both && self.together(here, there) && self.same_way(i, j) && self.near(i + 1, j + 1) {
            self.reach(i + 1, j + 1).both = true;
        }
    }

    /// Two straight moves of one block, walked in any way.
    fn straight(&mut self, (i, j): (usize, usize), place: Place) {
        if place.outcome_ahead.is_none() && place.answer_ahead.is_none() {
            return;
        }
        let (outcome, answer) = (self.outcome, self.answer);
        // The answer's move is done first.
        let free = self.free(outcome.after(i), outcome.after(i + 1), answer.after(j + 1), j + 1);
        if let Some(least) = earliest(free, &place.outcome_ahead, place.answer_ahead.is_some()) {
            self.reach(i, j + 1).outcome_ahead = Some(least);
        }
        // The outcome's is.
        let free = self.free(answer.after(j), answer.after(j + 1), outcome.after(i + 1), j + 1);
        if let Some(least) = earliest(free, &place.answer_ahead, place.outcome_ahead.is_some()) {
            self.reach(i + 1, j).answer_ahead = Some(least);
        }
        // Both at once: what is free of two straight moves is convex.
        if self.near(i + 1, j + 1) {
            self.reach(i + 1, j + 1).both = true;
        }
    }

    /// Whether two moves that are not both straight are passed together.
    fn together(&self, here: &Move, there: &Move) -> bool {
        let same = here.block == there.block;
        match (&here.shape, &there.shape) {
            (Shape::Hold, Shape::Hold) => same,
            (
                Shape::Arc { centre, direction, full },
                Shape::Arc { centre: centre_there, direction: direction_there, full: full_there },
            ) => {
                same && here.rapid == there.rapid
                    && direction == direction_there
                    && full == full_there
                    && centre.minus(centre_there).length_squared() <= self.reach.squared_at(centre_there)
            }
            _ => false,
        }
    }

    /// Whether two arcs go the same way round, as far as their ends tell.
    fn same_way(&self, i: usize, j: usize) -> bool {
        let ways = (self.way(self.outcome, i, &Real::zero()), self.way(self.answer, j, &self.grain_squared));
        ways.0 == ways.1 || ways.0 == Way::Either || ways.1 == Way::Either
    }

    /// Which way round an arc goes whose ends lie near each other.
    fn way(&self, path: &Path, at: usize, grain_squared: &Real) -> Way {
        let Some(Shape::Arc { centre, direction, full: false }) = path.moves.get(at).map(|element| &element.shape)
        else {
            return Way::Either;
        };
        let (from, to) = (path.after(at), path.after(at + 1));
        let (chord, ray) = (to.minus(from), from.minus(centre));
        let (chord_squared, near_squared) = (chord.length_squared(), &self.delta_squared * &Real::integer(4));
        let small = ray.length_squared() * Real::integer(4) <= near_squared;
        if chord_squared > near_squared || chord_squared <= *grain_squared || small {
            return Way::Either;
        }
        let onward = ray.cross(&chord).sign();
        let short = match direction {
            Direction::Counterclockwise => onward.is_ge(),
            Direction::Clockwise => onward.is_le(),
        };
        if short { Way::Short } else { Way::Long }
    }

    /// The part of the move from `start` to `end` that is no farther from `point` than the answer may lie off after so many
    /// moves: from where to where, each times the square of the move's length.
    fn free(&self, start: &Vector, end: &Vector, point: &Vector, moves: usize) -> Option<(Real, Real)> {
        let (along, to_point) = (end.minus(start), point.minus(start));
        let length_squared = along.length_squared();
        let projection = to_point.dot(&along);
        // |start + s·along - point|² ≤ δ², and σ = s·|along|², give σ² - 2·σ·projection + |along|²·spare ≤ 0.
        let spare = to_point.length_squared() - &self.reach_squared[moves];
        if length_squared.is_zero() {
            return spare.sign().is_le().then(|| (Real::zero(), Real::zero()));
        }
        let root = (projection.square() - &length_squared * &spare).sqrt()?;
        let from = (&projection - &root).max(Real::zero());
        let to = (&projection + &root).min(length_squared);
        (from <= to).then_some((from, to))
    }

    /// Whether the two places lie no farther apart than the answer may lie off.
    fn near(&self, i: usize, j: usize) -> bool {
        self.outcome.after(i).minus(self.answer.after(j)).length_squared() <= self.reach_squared[j]
    }

    fn reach(&mut self, i: usize, j: usize) -> &mut Place {
        self.places.entry((i, j)).or_default()
    }
}

impl Move {
    fn may_have_no_length(&self) -> bool {
        match self.shape {
            Shape::Line => true,
            Shape::Arc { full, .. } => !full,
            Shape::Hold => false,
        }
    }
}

/// Which way round an arc goes whose ends lie near each other.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// Along the short piece between them.
    Short,
    /// Along all the rest of the circle.
    Long,
    /// The ends lie apart, or too near for the rounding of a device.
    Either,
}

/// The earliest place of a free part that can be reached: any, `from_across`, or none before `before`.
fn earliest(free: Option<(Real, Real)>, before: &Option<Real>, from_across: bool) -> Option<Real> {
    let (from, to) = free?;
    if from_across {
        return Some(from);
    }
    let least = from.max(before.clone()?);
    (least <= to).then_some(least)
}
