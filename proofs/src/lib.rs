//! What is proved of radcomp's implementation. A *harness* is one function, generic over where its choices come from
//! ([`Choice`]): every property is stated once, and three things run it.
//!
//! * Kani lets each choice be any value at all, and proves the harness up to its stated bound.
//! * The tests let the choices run through **all** values of a small scope ([`choice::Exhaustive`]), and for the
//!   look-ahead through all states that any sequence of events reaches.
//! * Beyond that scope the tests draw choices at random ([`choice::Bytes`]).
//!
//! `proofs/README.md` lists the harnesses with property, bound, assumption and expected time.

pub mod choice;
pub mod engine;
pub mod interface;
pub mod look_ahead;
pub mod rounding;

#[cfg(kani)]
mod harnesses;
/// Stands in for Kani's interface where only the types of the harnesses are checked.
#[cfg(kani_stand_in)]
mod kani;

pub use choice::Choice;

/// Claims that some run of the harness comes here: without it a property might hold of nothing. Kani proves that the
/// place is reachable; the exhaustive tests compare what was reached with what a harness lists.
#[macro_export]
macro_rules! reached {
    ($choice:expr, $what:literal) => {{
        #[cfg(kani)]
        {
            #[cfg(kani_stand_in)]
            use $crate::kani;
            kani::cover!(true, $what);
        }
        #[cfg(not(kani))]
        $crate::Choice::reached($choice, $what);
    }};
}
