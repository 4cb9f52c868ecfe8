//! The harnesses of the C interface, over all choices of a small scope and at random.

use proptest::prelude::*;
use radcomp_proofs::choice::{Bytes, Exhaustive};
use radcomp_proofs::interface::{calls, new, number};

/// Bytes that a number has, and some that it has not: signs, an exponent, blanks, another letter.
const ALPHABET: &[u8] = b"019./+-eE \xc3\xa9";

#[test]
fn every_memory() {
    let visited = Exhaustive::search(&[], |choice| new(choice));
    println!("radcomp_new: {} calls", visited.runs);
    assert_eq!(visited.reached.len(), 3, "{:?}", visited.reached);
}

#[test]
fn every_pair_of_calls() {
    let visited = Exhaustive::search(&[0.0, 1.0, f64::NAN], |choice| calls(choice));
    println!("radcomp_push and radcomp_finish: {} pairs of calls", visited.runs);
    assert_eq!(visited.reached.len(), 3, "{:?}", visited.reached);
}

#[test]
fn every_short_text() {
    let visited = Exhaustive::search(&[], |choice| number::<5>(choice, ALPHABET));
    println!("number reader: {} texts", visited.runs);
    assert_eq!(visited.reached.len(), 2, "{:?}", visited.reached);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_calls(bytes in any::<[u8; 64]>()) {
        calls(&mut Bytes(&bytes));
        new(&mut Bytes(&bytes));
    }

    #[test]
    fn long_texts(bytes in any::<[u8; 24]>()) {
        number::<23>(&mut Bytes(&bytes), b"0123456789./");
        number::<23>(&mut Bytes(&bytes), b"99999999999999999999990./");
        number::<23>(&mut Bytes(&bytes), &[]);
    }
}
