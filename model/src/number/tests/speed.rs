//! How fast a corner is. Run with `cargo test --release -p radcomp-model number::tests::speed -- --ignored --nocapture`.

use std::hint::black_box;
use std::time::Instant;

use rug::Rational;

use crate::number::Real;

fn thousandths(value: i64) -> Real {
    Real::rational(Rational::from((value, 1000)))
}

/// The unit normal of a line from decimal end points, times the radius, on the left.
fn offset(from: &[Real; 2], to: &[Real; 2], radius: &Real) -> [Real; 2] {
    let (dx, dy) = (&to[0] - &from[0], &to[1] - &from[1]);
    let length = (dx.square() + dy.square()).sqrt().unwrap();
    let factor = radius.checked_div(&length).unwrap();
    [-&dy * &factor, &dx * &factor]
}

/// The corner of two offset lines through `corner`, and the signs that decide its kind.
fn corner(before: &[Real; 2], corner: &[Real; 2], after: &[Real; 2], radius: &Real) -> Option<[Real; 2]> {
    let n1 = offset(before, corner, radius);
    let n2 = offset(corner, after, radius);
    let cross = &n1[0] * &n2[1] - &n1[1] * &n2[0];
    if cross.is_zero() {
        return None;
    }
    let dot = &n1[0] * &n2[0] + &n1[1] * &n2[1];
    let squared = radius.square();
    let denominator = &squared + &dot;
    let factor = squared.checked_div(&denominator)?;
    let x = &corner[0] + (&n1[0] + &n2[0]) * &factor;
    let y = &corner[1] + (&n1[1] + &n2[1]) * &factor;
    black_box((&x - &before[0]).sign());
    Some([x, y])
}

#[test]
#[ignore = "a measurement"]
fn line_line_corner() {
    let radius = thousandths(5_000);
    let rounds = 200_000_i64;
    let start = Instant::now();
    for i in 0..rounds {
        let a = [thousandths(i * 7 % 90_001), thousandths(i * 13 % 70_001)];
        let b = [thousandths(100_000 + i % 977), thousandths(i * 3 % 50_021)];
        let c = [thousandths(50_000 + i * 11 % 300_007), thousandths(120_000 + i % 10_007)];
        black_box(corner(&a, &b, &c, &radius));
    }
    println!("line-line corner: {:.2} µs", start.elapsed().as_secs_f64() * 1e6 / rounds as f64);
}

/// What a report asks of a corner beside its signs: enclosures of 100 bits, then doubles.
#[test]
#[ignore = "a measurement"]
fn enclosures_and_doubles() {
    let radius = thousandths(5_000);
    let rounds = 20_000_i64;
    let [mut enclosing, mut rounding] = [0.0, 0.0];
    for i in 0..rounds {
        let a = [thousandths(i * 7 % 90_001), thousandths(i * 13 % 70_001)];
        let b = [thousandths(100_000 + i % 977), thousandths(i * 3 % 50_021)];
        let c = [thousandths(50_000 + i * 11 % 300_007), thousandths(120_000 + i % 10_007)];
        let tip = corner(&a, &b, &c, &radius).unwrap();
        let start = Instant::now();
        black_box(tip.each_ref().map(|x| x.enclosure(100)));
        enclosing += start.elapsed().as_secs_f64();
        let start = Instant::now();
        black_box(tip.each_ref().map(Real::to_f64));
        rounding += start.elapsed().as_secs_f64();
    }
    for (what, spent) in [("two enclosures of 100 bits", enclosing), ("two doubles after that", rounding)] {
        println!("{what}: {:.2} µs", spent * 1e6 / rounds as f64);
    }
}

/// Zeros that only the separation bound proves: the corner's distance from a line (two roots), and its equality with the
/// same corner found from the mitre's length along the bisector (three roots, one nested).
#[test]
#[ignore = "a measurement"]
fn proofs_of_zero() {
    let radius = thousandths(5_000);
    let rounds = 2_000_i64;
    let mut bits = [0, 0];
    let mut spent = [0.0, 0.0];
    for i in 0..rounds {
        let a = [thousandths(i * 7 % 90_001), thousandths(i * 13 % 70_001)];
        let b = [thousandths(100_000 + i % 977), thousandths(i * 3 % 50_021)];
        let c = [thousandths(50_000 + i * 11 % 300_007), thousandths(120_000 + i % 10_007)];
        let Some(tip) = corner(&a, &b, &c, &radius) else {
            continue;
        };
        let n = offset(&b, &c, &radius);
        let m = offset(&a, &b, &radius);
        let distance = (&tip[0] - &b[0]) * &n[0] + (&tip[1] - &b[1]) * &n[1] - radius.square();
        bits[0] = distance.separation_bits().max(bits[0]);
        let start = Instant::now();
        assert!(distance.is_zero());
        spent[0] += start.elapsed().as_secs_f64();
        let bisector = [&n[0] + &m[0], &n[1] + &m[1]];
        let length = (bisector[0].square() + bisector[1].square()).sqrt().unwrap();
        // The mitre is r²·2/|n + m| long.
        let mitre = (radius.square() * Real::integer(2)).checked_div(&length).unwrap();
        let by_length = &b[0] + mitre * bisector[0].checked_div(&length).unwrap();
        let difference = by_length - &tip[0];
        bits[1] = difference.separation_bits().max(bits[1]);
        let start = Instant::now();
        assert!(difference.is_zero());
        spent[1] += start.elapsed().as_secs_f64();
    }
    for (spent, bits) in spent.iter().zip(bits) {
        println!("proof of zero: {:.1} µs, bound at most {bits} bits", spent * 1e6 / rounds as f64);
    }
}
