//! The two number kernels: intervals with a separation bound, and towers of square roots.

use std::cmp::Ordering;

use radcomp::edited::Edited;
use radcomp_model::number::Real;
use radcomp_model::run;
use radcomp_model::tower::{Refusal, Tower};

use crate::ledger;

/// The most independent square roots that a number may take.
const MOST_ROOTS: usize = 6;
/// The most operations of an expression.
const MOST_OPERATIONS: usize = 12;

/// Both kernels find the same sign of every decision of a program, and of an expression that the bytes write.
pub fn kernels(bytes: &[u8]) {
    let Some((&kind, rest)) = bytes.split_first() else { return };
    if kind < 128 {
        agree(&expression(rest));
        return;
    }
    let Some(Edited { profile, blocks }) = Edited::from_bytes(rest) else { return };
    let run = run(&profile.parameters, &blocks);
    ledger::note(&run);
    for (decision, _) in &run.decisions {
        agree(&decision.margin);
    }
}

/// # Panics
/// When the kernels differ.
fn agree(number: &Real) -> Option<Ordering> {
    match Tower::new(MOST_ROOTS).convert(number) {
        Ok(tower) => {
            assert_eq!(tower.sign(), number.sign(), "{:?}", number.filter());
            Some(number.sign())
        }
        Err(Refusal::TooManyRoots) => None,
        Err(other) => panic!("{other:?}"),
    }
}

/// An expression in postfix: operations on a stack of numbers, the last of which counts.
fn expression(bytes: &[u8]) -> Real {
    let mut stack = vec![Real::one()];
    let mut bytes = bytes.iter().copied();
    let mut operations = 0;
    while let Some(byte) = bytes.next() {
        let (top, below) = (stack[stack.len() - 1].clone(), stack[stack.len().saturating_sub(2)].clone());
        operations += 1;
        if operations > MOST_OPERATIONS {
            break;
        }
        let made = match byte % 8 {
            0 | 1 => Some(Real::integer(bytes.next().map_or(2, i64::from) - 128)),
            2 => Some(&below + &top),
            3 => Some(&below - &top),
            4 => Some(&below * &top),
            5 => below.checked_div(&top),
            6 => Some(top.square()),
            _ => top.abs().sqrt(),
        };
        stack.extend(made);
    }
    stack.pop().unwrap_or_else(Real::one)
}
