//! The programs just outside of the band of `binary64`.

use std::cmp::Ordering;

use radcomp_model::number::Real;
use radcomp_model::{Decision, Engine, Sink};
use radcomp_spec::{Block, DecisionKind, Segment, Step};
use rug::Rational;

use crate::generate::Reach;
use crate::judge::{Budget, Grade};

/// How many times the band a number is moved at least.
const TIMES_THE_BAND: f64 = 64.0;

/// How many times the band the margin is moved at least: what the numbers of a corner move it by, and as much again.
const MARGIN: f64 = 16.0;

/// A lower bound on how far, in thousandths of a millimetre: for a contour of no size.
const LEAST: f64 = 1e-12;

/// How far a point moves at most when a number moves by what f64 rounds it by, in millimetres: a quarter of what a device's
/// points may lie off.
const STEADY: f64 = 1e-6 / 4.0;

/// The most increments that a number is moved by: where a corner follows it so little that its neighbours are in the band.
const MOST: u32 = 10_000;

/// The programs just outside of the band, `at` so many thousandths of a millimetre from the decision that `on` lies on; none
/// where too many lead out of it, or what f64 rounds a number by is not small beside the path.
pub(super) fn beside(
    kind: DecisionKind,
    on: &[Block<Rational>],
    at: impl Fn(Rational) -> Vec<Block<Rational>>,
    increment: &Rational,
    reach: Reach,
) -> Option<[Vec<Block<Rational>>; 2]> {
    let look = |blocks: &[Block<Rational>]| Look::at(kind, blocks, reach);
    let number = look(on).margins.iter().position(|margin| *margin == 0.0);
    let band = band(on);
    let is_outside = |look: &Look| {
        number.is_none_or(|number| look.margins.get(number).is_some_and(|margin| margin.abs() >= MARGIN * band))
    };
    // In thousandths: a unit in the last place of the largest number.
    let unit = Rational::from_f64(band * 1000.0 / 4096.0)?;
    let mut near = outside_the_band(band);
    let most = Rational::from(increment * MOST);
    while near < most {
        let programs = [Rational::from(-&near), near.clone()].map(|steps| (at(steps.clone()), at(steps + &unit)));
        let looks = programs.each_ref().map(|(own, moved)| (look(own), look(moved)));
        if looks.iter().all(|(own, _)| is_outside(own)) {
            let steady = looks.iter().all(|(own, moved)| own.is_near(moved));
            return steady.then(|| programs.map(|(own, _)| own));
        }
        near *= 10;
    }
    None
}

/// The least power of ten that is as many times the band, in thousandths of a millimetre.
fn outside_the_band(band: f64) -> Rational {
    let least = TIMES_THE_BAND * band * 1000.0;
    let mut near = Rational::from(1);
    while near > least && near > LEAST {
        near /= 10;
    }
    near * 10
}

/// The band of `binary64`, in millimetres.
fn band(blocks: &[Block<Rational>]) -> f64 {
    Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 }.beta(blocks)
}

/// What of a run matters here.
struct Look {
    kind: DecisionKind,
    /// Of the decisions of this kind, in millimetres.
    margins: Vec<f64>,
    /// The coordinates that the path is made of, in millimetres.
    path: Vec<f64>,
}

impl Look {
    fn at(kind: DecisionKind, blocks: &[Block<Rational>], reach: Reach) -> Self {
        let mut look = Look { kind, margins: Vec::new(), path: Vec::new() };
        let mut engine = Engine::new(reach.parameters());
        // An alarm ends the path.
        let _ =
            blocks.iter().try_for_each(|block| engine.push(block, &mut look)).and_then(|()| engine.finish(&mut look));
        look
    }

    fn is_near(&self, other: &Look) -> bool {
        let near = |(one, other): (&f64, &f64)| (one - other).abs() <= STEADY;
        self.path.len() == other.path.len() && self.path.iter().zip(&other.path).all(near)
    }
}

impl Sink for Look {
    fn step(&mut self, step: Step<Real>) {
        let points = match &step.segment {
            Segment::Hold => vec![],
            Segment::Line { end } => vec![end],
            Segment::Arc { end, centre, .. } => vec![end, centre],
        };
        self.path.extend(points.into_iter().flatten().map(Real::to_f64));
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        if decision.kind == self.kind {
            self.margins.push(decision.margin.to_f64());
        }
        decision.exact
    }
}
