//! The separation bound: how near to zero a number can be without being zero.
//!
//! C. Burnikel, S. Funke, K. Mehlhorn, S. Schirra and S. Schmitt, "A separation bound for real algebraic expressions",
//! Algorithmica 55 (2009) 14-28 (BFMSS).
//!
//! Each number x of an expression is 2^v·5^w·U/L with algebraic integers U and L of the field K that the expression's
//! square roots generate over the rationals. Powers of 2 and 5 are kept apart as decimal input abounds in them, after
//! S. Pion and C. Yap, "Constructive root bound for k-ary rational input numbers", SoCG 2003. Written without them, by
//! the paper's rules:
//!
//! | x | U | L |
//! |---|---|---|
//! | n/d | n | d |
//! | a ± b | U(a)·L(b) ± U(b)·L(a) | L(a)·L(b) |
//! | a·b | U(a)·U(b) | L(a)·L(b) |
//! | a/b | U(a)·L(b) | L(a)·U(b) |
//! | √a | √(U(a)·L(a)), or U(a) | L(a), or √(U(a)·L(a)) |
//!
//! With them: of a rational they are taken out of n and d; of a sum the lesser exponents of a and b are, and what is left
//! goes into U(a) and U(b); of products and quotients the exponents add and subtract; of a root they are halved, rounded
//! down, and an odd 2 or 5 goes into U(a) first.
//!
//! Let D be the degree of K, at most 2^k for k roots, and σ₁ … σ_D the embeddings of K. With u and l such that
//! |σ(U)| ≤ 2^u and |σ(L)| ≤ 2^l for every σ, a nonzero U has the norm |σ₁(U)|·…·|σ_D(U)| ≥ 1, as it is a nonzero
//! integer; so |U| ≥ 2^(-(D-1)·u), and |x| = 2^v·5^w·|U|/|L| ≥ 2^(v + w·log₂5 - (D-1)·u - l).
//!
//! An embedding respects the operations, so u and l follow from the table, in whole bits rounded up:
//! u(n/d) = ⌈log₂|n|⌉, l(n/d) = ⌈log₂ d⌉; u(a ± b) = max(u(a)+l(b), u(b)+l(a)) + 1, as 2^p + 2^q ≤ 2^(max(p,q)+1);
//! products add; a root takes ⌈(u+l)/2⌉ on the side where it gains, which by the paper is U where u ≥ l, else L.

use std::collections::{HashMap, HashSet};

use rug::{Integer, Rational};

use super::Real;
use super::node::{Node, Shape};

/// x = 2^`twos`·5^`fives`·U/L, with |σ(U)| ≤ 2^`above` and |σ(L)| ≤ 2^`below` for every embedding σ.
///
/// All arithmetic saturates, which is harmless: a bound of 2⁶³ bits is never reached.
#[derive(Clone, Copy, Default)]
struct Size {
    twos: i64,
    fives: i64,
    above: i64,
    below: i64,
}

impl Real {
    /// A number of bits B such that x = 0 or |x| ≥ 2^-B.
    pub(super) fn separation_bits(&self) -> i64 {
        let mut sizes: HashMap<*const Node, Size> = HashMap::new();
        let mut roots = Roots::default();
        let mut pending = vec![self];
        while let Some(&real) = pending.last() {
            if sizes.contains_key(&real.address()) {
                pending.pop();
                continue;
            }
            let waiting = pending.len();
            // A number proved to be zero counts as the rational 0, whatever it was made from.
            let shape = &real.0.shape;
            let operands = if real.known_zero() { [None, None] } else { shape.operands() };
            pending.extend(operands.into_iter().flatten().filter(|operand| !sizes.contains_key(&operand.address())));
            if pending.len() == waiting {
                if let Shape::Root(radicand) = shape
                    && !real.known_zero()
                {
                    roots.add(radicand);
                }
                // Every operand has its size by now.
                let size = size(real, |operand| sizes[&operand.address()]);
                sizes.insert(real.address(), size);
                pending.pop();
            }
        }
        let whole = sizes[&self.address()];
        let conjugates = 1_i64.checked_shl(roots.count).filter(|degree| *degree > 0).unwrap_or(i64::MAX) - 1;
        let bits = conjugates.saturating_mul(whole.above).saturating_add(whole.below);
        bits.saturating_sub(whole.twos).saturating_add(log2_of_power_of_five(whole.fives.saturating_neg()))
    }
}

fn size<'a>(real: &'a Real, of: impl Fn(&'a Real) -> Size) -> Size {
    match &real.0.shape {
        _ if real.known_zero() => Size::default(),
        Shape::Rational(value) | Shape::Input(value) => Size::of_rational(value),
        Shape::Negation(a) => of(a),
        Shape::Sum(a, b) | Shape::Difference(a, b) => of(a).plus(of(b)),
        Shape::Product(a, b) => of(a).times(of(b)),
        Shape::Square(a) => of(a).times(of(a)),
        Shape::Quotient(a, b, _) => of(a).times(of(b).inverse()),
        Shape::Root(a) => of(a).root(),
    }
}

impl Size {
    fn of_rational(value: &Rational) -> Size {
        let (two, five) = (Integer::from(2), Integer::from(5));
        let (mut n, mut d) = (value.numer().clone(), value.denom().clone());
        let mut remove = |factor| i64::from(n.remove_factor_mut(factor)) - i64::from(d.remove_factor_mut(factor));
        let (twos, fives) = (remove(&two), remove(&five));
        Size { twos, fives, above: log2_up(&n), below: log2_up(&d) }
    }

    fn plus(self, other: Size) -> Size {
        let (twos, fives) = (self.twos.min(other.twos), self.fives.min(other.fives));
        let term = |a: Size, b: Size| {
            let rest = a.twos.saturating_sub(twos).saturating_add(log2_of_power_of_five(a.fives.saturating_sub(fives)));
            a.above.saturating_add(b.below).saturating_add(rest)
        };
        let above = term(self, other).max(term(other, self)).saturating_add(1);
        Size { twos, fives, above, below: self.below.saturating_add(other.below) }
    }

    fn times(self, other: Size) -> Size {
        Size {
            twos: self.twos.saturating_add(other.twos),
            fives: self.fives.saturating_add(other.fives),
            above: self.above.saturating_add(other.above),
            below: self.below.saturating_add(other.below),
        }
    }

    fn inverse(self) -> Size {
        Size {
            twos: self.twos.saturating_neg(),
            fives: self.fives.saturating_neg(),
            above: self.below,
            below: self.above,
        }
    }

    fn root(self) -> Size {
        let odd = self.twos.rem_euclid(2) + log2_of_power_of_five(self.fives.rem_euclid(2));
        let above = self.above.saturating_add(odd);
        let half = above.saturating_add(self.below.saturating_add(1)).div_euclid(2);
        let (above, below) = if above >= self.below { (half, self.below) } else { (above, half) };
        Size { twos: self.twos.div_euclid(2), fives: self.fives.div_euclid(2), above, below }
    }
}

/// ⌈log₂|value|⌉, and 0 for zero.
fn log2_up(value: &Integer) -> i64 {
    let bits = i64::from(value.significant_bits());
    // 2^(bits-1) ≤ |value| < 2^bits, with equality on the left for a power of two only.
    let power_of_two = value.find_one(0).is_some_and(|place| i64::from(place) == bits - 1);
    if power_of_two { bits - 1 } else { bits }
}

/// An integer not less than log₂ 5^`exponent`, for exponents of either sign.
fn log2_of_power_of_five(exponent: i64) -> i64 {
    // 2.321928 < log₂ 5 < 2.321929
    let millionths = if exponent >= 0 { 2_321_929 } else { 2_321_928 };
    let product = i128::from(exponent) * millionths;
    i64::try_from((product + 999_999).div_euclid(1_000_000)).unwrap_or(i64::MAX)
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
            Shape::Rational(value) | Shape::Input(value) => self.add_rational(value),
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
