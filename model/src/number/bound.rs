//! The separation bound: how near to zero a number can be without being zero.
//!
//! C. Burnikel, S. Funke, K. Mehlhorn, S. Schirra and S. Schmitt, "A separation bound for real algebraic expressions",
//! Algorithmica 55 (2009) 14-28 (BFMSS).
//!
//! Each number x of an expression is a quotient U/L of algebraic integers in the field K that the expression's square
//! roots generate over the rationals:
//!
//! | x | U | L |
//! |---|---|---|
//! | n/d | n | d |
//! | a ± b | U(a)·L(b) ± U(b)·L(a) | L(a)·L(b) |
//! | a·b | U(a)·U(b) | L(a)·L(b) |
//! | a/b | U(a)·L(b) | L(a)·U(b) |
//! | √a | √(U(a)·L(a)), or U(a) | L(a), or √(U(a)·L(a)) |
//!
//! Let D be the degree of K, at most 2^k for k roots, and σ₁ … σ_D the embeddings of K. With u and l such that
//! |σ(U)| ≤ 2^u and |σ(L)| ≤ 2^l for every σ, a nonzero U has the norm |σ₁(U)|·…·|σ_D(U)| ≥ 1, as it is a nonzero
//! integer; so |U| ≥ 2^(-(D-1)·u), and |x| = |U|/|L| ≥ 2^-((D-1)·u + l).
//!
//! An embedding respects the operations, so u and l follow from the table, in whole bits rounded up:
//! u(n/d) = ⌈log₂|n|⌉, l(n/d) = ⌈log₂ d⌉; u(a ± b) = max(u(a)+l(b), u(b)+l(a)) + 1, as 2^p + 2^q ≤ 2^(max(p,q)+1);
//! products add; a root takes ⌈(u+l)/2⌉ on the side where it gains, which by the paper is U where u ≥ l, else L.

use std::collections::{HashMap, HashSet};

use rug::{Integer, Rational};

use super::Real;
use super::node::{Node, Shape};

/// |σ(U)| ≤ 2^`above` and |σ(L)| ≤ 2^`below` for every embedding σ.
#[derive(Clone, Copy)]
struct Size {
    above: u64,
    below: u64,
}

impl Real {
    /// A number of bits B such that x = 0 or |x| ≥ 2^-B.
    pub(super) fn separation_bits(&self) -> u64 {
        let mut sizes: HashMap<*const Node, Size> = HashMap::new();
        let mut roots = Roots::default();
        let mut pending = vec![self];
        while let Some(&real) = pending.last() {
            if sizes.contains_key(&real.address()) {
                pending.pop();
                continue;
            }
            let waiting = pending.len();
            let operands = real.0.shape.operands().into_iter().flatten();
            pending.extend(operands.filter(|operand| !sizes.contains_key(&operand.address())));
            if pending.len() == waiting {
                if let Shape::Root(radicand) = &real.0.shape {
                    roots.add(radicand);
                }
                // Every operand has its size by now.
                let size = size(real, |operand| sizes[&operand.address()]);
                sizes.insert(real.address(), size);
                pending.pop();
            }
        }
        let whole = sizes[&self.address()];
        let conjugates = 1_u64.checked_shl(roots.count).map_or(u64::MAX, |degree| degree - 1);
        conjugates.saturating_mul(whole.above).saturating_add(whole.below)
    }
}

fn size<'a>(real: &'a Real, of: impl Fn(&'a Real) -> Size) -> Size {
    // Saturation is harmless: a bound of 2⁶⁴ bits is never reached.
    match &real.0.shape {
        Shape::Rational(value) => Size { above: log2_up(value.numer()), below: log2_up(value.denom()) },
        Shape::Negation(a) => of(a),
        Shape::Sum(a, b) | Shape::Difference(a, b) => {
            let (a, b) = (of(a), of(b));
            let left = a.above.saturating_add(b.below);
            let right = b.above.saturating_add(a.below);
            Size { above: left.max(right).saturating_add(1), below: a.below.saturating_add(b.below) }
        }
        Shape::Product(a, b) => product(of(a), of(b)),
        Shape::Square(a) => product(of(a), of(a)),
        Shape::Quotient(a, b, _) => {
            let b = of(b);
            product(of(a), Size { above: b.below, below: b.above })
        }
        Shape::Root(a) => {
            let a = of(a);
            let half = a.above.saturating_add(a.below).div_ceil(2);
            if a.above >= a.below { Size { above: half, below: a.below } } else { Size { above: a.above, below: half } }
        }
    }
}

fn product(a: Size, b: Size) -> Size {
    Size { above: a.above.saturating_add(b.above), below: a.below.saturating_add(b.below) }
}

/// ⌈log₂|value|⌉, and 0 for zero.
fn log2_up(value: &Integer) -> u64 {
    let bits = u64::from(value.significant_bits());
    // 2^(bits-1) ≤ |value| < 2^bits, with equality on the left for a power of two only.
    if value.find_one(0).map(u64::from) == Some(bits.saturating_sub(1)) { bits.saturating_sub(1) } else { bits }
}

/// The roots met so far, and how many of them the degree of the field can be charged with.
#[derive(Default)]
struct Roots {
    /// log₂ of a bound of the degree.
    count: u32,
    /// Radicands of roots whose value is known to lie in the field: n·d for each root √(n/d) = √(n·d)/d counted, and
    /// products of these. A root of this class adds nothing to the field.
    classes: Vec<Integer>,
    /// Radicands that are not rational, by node.
    nested: HashSet<*const Node>,
}

/// Above this many classes no more products are formed; a root too many in the count costs time, never exactness.
const MOST_CLASSES: usize = 64;

impl Roots {
    fn add(&mut self, radicand: &Real) {
        match &radicand.0.shape {
            Shape::Rational(value) => self.add_rational(value),
            _ => self.count += u32::from(self.nested.insert(radicand.address())),
        }
    }

    fn add_rational(&mut self, value: &Rational) {
        let class = Integer::from(value.numer() * value.denom());
        if self.classes.iter().any(|known| Integer::from(known * &class).is_perfect_square()) {
            return;
        }
        self.count += 1;
        let products = self.classes.iter().map(|known| Integer::from(known * &class));
        let more: Vec<Integer> = products.take(MOST_CLASSES.saturating_sub(self.classes.len())).collect();
        self.classes.extend(more);
        self.classes.push(class);
    }
}
