//! The two number kernels on real work: the sign that the model found with intervals and a separation bound is the
//! sign that towers of square roots give, on every decision of generated programs and on circles that their paths
//! must satisfy.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread;
use std::time::{Duration, Instant};

use radcomp::generate::{self, Reach};
use radcomp_model::number::Real;
use radcomp_model::tower::{Refusal, Tower};
use radcomp_model::{Decision, Run, run};
use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Block, DecisionKind, Segment, Step};
use rug::Rational;

/// The most independent square roots that a number may take.
const MOST_ROOTS: usize = 8;
const SEED: u64 = 0x726f_6f74;

/// What was compared.
#[derive(Debug, Default)]
struct Tally {
    compared: u64,
    zeros: u64,
    /// Margins of zero whose decision is not; see [`zero_is_enough`].
    waived: u64,
    /// Numbers beyond [`MOST_ROOTS`].
    too_high: u64,
    /// How many numbers took how many roots.
    heights: BTreeMap<usize, u64>,
    slowest: Duration,
    disagreements: Vec<String>,
}

impl Tally {
    fn merge(mut self, other: Tally) -> Tally {
        self.compared += other.compared;
        self.zeros += other.zeros;
        self.waived += other.waived;
        self.too_high += other.too_high;
        for (height, count) in other.heights {
            *self.heights.entry(height).or_default() += count;
        }
        self.slowest = self.slowest.max(other.slowest);
        self.disagreements.extend(other.disagreements);
        self
    }

    /// Compares the kernels on one number; the sign, if they agree.
    fn compare(&mut self, number: &Real, place: impl Fn() -> String) -> Option<Ordering> {
        let mut tower = Tower::new(MOST_ROOTS);
        let started = Instant::now();
        let converted = tower.convert(number).map(|number| number.sign());
        self.slowest = self.slowest.max(started.elapsed());
        match converted {
            Err(Refusal::TooManyRoots) => {
                self.too_high += 1;
                None
            }
            Ok(sign) if sign == number.sign() => {
                self.compared += 1;
                self.zeros += u64::from(sign.is_eq());
                *self.heights.entry(tower.height()).or_default() += 1;
                Some(sign)
            }
            other => {
                self.disagreements.push(format!("{}: {other:?}, not {:?}", place(), number.sign()));
                None
            }
        }
    }
}

/// Whether a decision may be other than zero though its margin is zero.
fn zero_is_enough(decision: &Decision) -> bool {
    match decision.kind {
        // The margin is a distance: at zero the two sweeps may be equal or a whole turn apart, which runs backwards.
        DecisionKind::ArcForward | DecisionKind::ArcInterference => decision.exact == Ordering::Less,
        _ => false,
    }
}

/// Every decision's margin has the decision's sign.
fn decisions(name: &str, _: &[Block<Rational>], run: &Run, tally: &mut Tally) {
    for (index, (decision, _)) in run.decisions.iter().enumerate() {
        let place = || format!("{name}, decision {index} in block {}, {}", decision.block, decision.kind.id());
        let Some(sign) = tally.compare(&decision.margin, place) else { continue };
        if sign.is_eq() && decision.exact.is_ne() && zero_is_enough(decision) {
            tally.waived += 1;
        } else if sign != decision.exact {
            tally.disagreements.push(format!("{}: margin {sign:?}, decision {:?}", place(), decision.exact));
        }
    }
}

/// Start and end of every arc of the path are as far from its centre: mostly zeros, and deep ones.
fn circles(name: &str, _: &[Block<Rational>], run: &Run, tally: &mut Tally) {
    let mut here: Option<&[Real; 2]> = None;
    for (index, Step { segment, .. }) in run.steps.iter().enumerate() {
        let end = match segment {
            Segment::Hold => continue,
            Segment::Line { end } | Segment::Arc { end, .. } => end,
        };
        if let (Segment::Arc { centre, .. }, Some(start)) = (segment, here) {
            let squared = |point: &[Real; 2]| (&point[0] - &centre[0]).square() + (&point[1] - &centre[1]).square();
            tally.compare(&(squared(start) - squared(end)), || format!("{name}, step {index}"));
        }
        here = Some(end);
    }
}

type Comparison = fn(&str, &[Block<Rational>], &Run, &mut Tally);

/// Compares programs 0, 1, … of every built-in profile until there is enough, and prints what was compared.
fn compare(comparison: Comparison, enough: u64) -> Tally {
    BUILTIN.iter().map(|(name, _)| compare_profile(name, comparison, enough)).fold(Tally::default(), Tally::merge)
}

fn compare_profile(name: &str, comparison: Comparison, enough: u64) -> Tally {
    let started = Instant::now();
    let (next, done) = (AtomicU64::new(0), AtomicU64::new(0));
    let profile = Profile::builtin(name).expect("built in");
    let work = || {
        let mut tally = Tally::default();
        while done.load(Relaxed) < enough {
            let before = tally.compared;
            let number = next.fetch_add(1, Relaxed);
            let blocks = generate::program(SEED, number, Reach::of(&profile));
            let run = run(&profile.parameters, &blocks);
            comparison(&format!("{name} #{number} of seed {SEED}"), &blocks, &run, &mut tally);
            done.fetch_add(tally.compared - before, Relaxed);
        }
        tally
    };
    let tally = thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let tallies = workers.into_iter().map(|worker| worker.join().expect("no panic in a worker"));
        tallies.fold(Tally::default(), Tally::merge)
    });
    println!("{name}: {} programs in {:.1?}: {tally:?}", next.into_inner(), started.elapsed());
    assert!(tally.disagreements.is_empty(), "{:#?}", tally.disagreements);
    assert_eq!(tally.too_high, 0);
    tally
}

#[test]
fn kernels_agree_on_decisions() {
    let tally = compare(decisions, 20_000);
    assert!(tally.zeros >= 1000, "few zeros: {}", tally.zeros);
}

#[test]
fn kernels_agree_on_circles() {
    let tally = compare(circles, 500);
    assert!(tally.zeros >= 1000, "few zeros: {}", tally.zeros);
}

/// `cargo test --release --test kernels -- --ignored --nocapture`
#[test]
#[ignore = "takes a minute"]
fn kernels_agree_on_a_million_decisions() {
    compare(decisions, 1_000_000);
}

/// `cargo test --release --test kernels -- --ignored --nocapture`
#[test]
#[ignore = "takes a minute"]
fn kernels_agree_on_many_circles() {
    compare(circles, 30_000);
}
