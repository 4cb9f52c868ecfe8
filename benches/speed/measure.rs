//! Time: contestants take turns, the median of the turns counts.

use std::time::{Duration, Instant};

/// A turn lasts at least this long, so that the clock's own cost does not count.
const SHORTEST_TURN: Duration = Duration::from_millis(2);

/// What takes part in a race.
pub struct Contestant<F> {
    /// Blocks, vertices or programs that one call works through.
    units: usize,
    call: F,
}

impl<'a> Contestant<Box<dyn FnMut() + 'a>> {
    /// One call of `call` works through `units` units; what it answers is kept from the optimiser.
    pub fn new<T>(units: usize, mut call: impl FnMut() -> T + 'a) -> Self {
        let call = move || {
            std::hint::black_box(call());
        };
        Contestant { units, call: Box::new(call) }
    }
}

/// The median nanoseconds per unit of each contestant over `rounds` rounds, in each of which all of them have a turn.
pub fn race<const N: usize>(mut contestants: [Contestant<Box<dyn FnMut() + '_>>; N], rounds: usize) -> [f64; N] {
    let calls: [u32; N] = std::array::from_fn(|i| {
        let once = time(1, &mut contestants[i].call).max(Duration::from_nanos(1));
        u32::try_from(SHORTEST_TURN.as_nanos() / once.as_nanos()).unwrap_or(u32::MAX).max(1)
    });
    let mut turns: [Vec<f64>; N] = std::array::from_fn(|_| Vec::with_capacity(rounds));
    for _ in 0..rounds {
        for (i, contestant) in contestants.iter_mut().enumerate() {
            let elapsed = time(calls[i], &mut contestant.call);
            turns[i].push(elapsed.as_nanos() as f64 / f64::from(calls[i]) / contestant.units as f64);
        }
    }
    turns.map(median)
}

/// The middle value; NaN of none.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The most memory that this process has held so far, where the system tells.
pub fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.parse::<u64>().ok().map(|kibibytes| kibibytes * 1024)
}

fn time(calls: u32, call: &mut dyn FnMut()) -> Duration {
    let start = Instant::now();
    for _ in 0..calls {
        call();
    }
    start.elapsed()
}
