//! A bound on the work of one exploratory computation.
//!
//! Zero is proved by as many bits as the separation bound asks for, which may be millions where numbers of no particular
//! origin meet. Who only looks around (a search, never the reference) can give up on those.

use std::cell::Cell;

thread_local! {
    /// The most bits that a sign may take.
    static MOST_BITS: Cell<i64> = const { Cell::new(i64::MAX) };
    /// A sign has been given up.
    static GIVEN_UP: Cell<bool> = const { Cell::new(false) };
}

/// Computes with signs of at most `bits` bits. Answers what was computed, or none if a sign would have taken more: then
/// that sign was taken to be zero without proof, and the rest is worth nothing.
///
/// # Exactness
///
/// What is answered rests on exact signs alone.
pub fn within_bits<T>(bits: i64, compute: impl FnOnce() -> T) -> Option<T> {
    let limits = Before { most_bits: MOST_BITS.replace(bits), given_up: GIVEN_UP.replace(false) };
    let value = compute();
    let given_up = GIVEN_UP.get();
    drop(limits);
    (!given_up).then_some(value)
}

/// Puts back what held before, also when the computation panics.
struct Before {
    most_bits: i64,
    given_up: bool,
}

impl Drop for Before {
    fn drop(&mut self) {
        MOST_BITS.set(self.most_bits);
        GIVEN_UP.set(self.given_up);
    }
}

/// Whether a sign may take so many bits; if not, it is noted.
pub(super) fn allows(bits: i64) -> bool {
    let allowed = bits <= MOST_BITS.get();
    if !allowed {
        GIVEN_UP.set(true);
    }
    allowed
}
