//! The two number kernels agree on every decision of generated programs: the sign that the model took, found with
//! intervals and a separation bound, is the sign that towers of square roots give the decision's margin.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::thread;
use std::time::{Duration, Instant};

use radcomp::generate::{self, Reach};
use radcomp_model::run;
use radcomp_model::tower::{Refusal, Tower};
use radcomp_spec::DecisionKind;
use radcomp_spec::profile::Profile;

/// The most independent square roots a margin may take.
const MOST_ROOTS: usize = 8;
const SEED: u64 = 0x726f_6f74;

/// What was compared.
#[derive(Debug, Default)]
struct Tally {
    compared: u64,
    zeros: u64,
    /// The zero margins of sweep comparisons.
    skipped: u64,
    /// Margins beyond [`MOST_ROOTS`].
    too_high: u64,
    /// How many margins took how many roots.
    heights: BTreeMap<usize, u64>,
    by_kind: BTreeMap<&'static str, u64>,
    slowest: Duration,
    slowest_at: String,
    disagreements: Vec<String>,
}

impl Tally {
    fn merge(&mut self, other: Tally) {
        self.compared += other.compared;
        self.zeros += other.zeros;
        self.skipped += other.skipped;
        self.too_high += other.too_high;
        for (height, count) in other.heights {
            *self.heights.entry(height).or_default() += count;
        }
        for (kind, count) in other.by_kind {
            *self.by_kind.entry(kind).or_default() += count;
        }
        if other.slowest > self.slowest {
            (self.slowest, self.slowest_at) = (other.slowest, other.slowest_at);
        }
        self.disagreements.extend(other.disagreements);
    }
}

fn compare_program(number: u64, profile: &Profile, tally: &mut Tally) {
    let blocks = generate::program(SEED, number, Reach::of(profile));
    for (index, (decision, _)) in run(&profile.parameters, &blocks).decisions.iter().enumerate() {
        let started = Instant::now();
        let mut tower = Tower::new(MOST_ROOTS);
        let sign = tower.convert(&decision.margin).map(|margin| margin.sign());
        let place = format!("program {number}, decision {index}, block {}: {}", decision.block, decision.kind.id());
        let t = started.elapsed();
        if t > tally.slowest {
            tally.slowest = t;
            tally.slowest_at = format!("{place} height {}", tower.height());
        }
        match sign {
            // The sweep comparison's margin is a distance: at zero the two sweeps may be equal or a turn apart.
            Ok(Ordering::Equal) if decision.kind == DecisionKind::ArcForward => {
                tally.skipped += 1;
                continue;
            }
            Ok(sign) if sign == decision.exact => {}
            Err(Refusal::TooManyRoots) => {
                tally.too_high += 1;
                continue;
            }
            other => tally.disagreements.push(format!("{place}: {other:?}, the model says {:?}", decision.exact)),
        }
        tally.compared += 1;
        tally.zeros += u64::from(decision.exact.is_eq());
        *tally.heights.entry(tower.height()).or_default() += 1;
        *tally.by_kind.entry(decision.kind.id()).or_default() += 1;
    }
}

/// Compares the decisions of programs 0, 1, … until there are enough, and prints what was compared.
fn compare(decisions: u64) {
    let started = Instant::now();
    let (next, done) = (AtomicU64::new(0), AtomicU64::new(0));
    let profile = Profile::builtin("yasnac-lx").expect("built in");
    let work = || {
        let mut tally = Tally::default();
        while done.load(Relaxed) < decisions {
            let before = tally.compared;
            compare_program(next.fetch_add(1, Relaxed), &profile, &mut tally);
            done.fetch_add(tally.compared - before, Relaxed);
        }
        tally
    };
    let mut tally = Tally::default();
    thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().for_each(|worker| tally.merge(worker.join().expect("a worker panicked")));
    });
    println!("{} programs in {:.1?}: {tally:#?}", next.into_inner(), started.elapsed());
    assert!(tally.disagreements.is_empty(), "{:#?}", tally.disagreements);
    assert!(tally.compared >= decisions);
}

#[test]
fn kernels_agree_on_decisions() {
    compare(20_000);
}

/// The same for many more; `cargo test --release --test kernels -- --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn kernels_agree_on_a_million_decisions() {
    compare(1_000_000);
}
