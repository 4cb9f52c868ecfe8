//! Time for long programs.

use std::time::Instant;

use radcomp::safety::{Contour, check};
use radcomp_spec::{Block, Compensation, Movement, Side};
use rug::Rational;

/// A closed gear of so many blocks, about as finely divided as a CAM system divides.
fn gear(count: u32, side: Side) -> Vec<Block<Rational>> {
    let point = |index: u32| {
        let turn = std::f64::consts::TAU * f64::from(index % count) / f64::from(count);
        let radius = 2000.0 + 60.0 * (turn * 25.0).sin();
        let at = |value: f64| Rational::from(((value * 1000.0).round() as i64, 1000));
        [at(radius * turn.cos()), at(radius * turn.sin())]
    };
    let line = |end| Block::moving(Movement::Line { end });
    let mut blocks =
        vec![Block { compensation: Some(Compensation::On(side)), radius: Some(Rational::from(5)), ..line(point(0)) }];
    blocks.extend((1..=count).map(|index| line(point(index))));
    blocks.push(Block { compensation: Some(Compensation::Off), ..line([Rational::new(), Rational::new()]) });
    blocks
}

#[test]
#[ignore = "timing: `cargo test --release --test safety -- --ignored --nocapture`"]
fn a_hundred_thousand_blocks() {
    for side in [Side::Left, Side::Right] {
        let blocks = gear(100_000, side);
        let start = Instant::now();
        let contour = Contour::of(&blocks);
        let read = start.elapsed();
        let path = super::model_path(&super::mill().parameters, &blocks);
        let start = Instant::now();
        let verdict = check(&contour, &path, 1e-9);
        println!("{side:?}: contour {read:?}, check {:?} for {} steps: {verdict:?}", start.elapsed(), path.len());
        // The same, 10 µm too near all along: every step gouges.
        let thin: Vec<_> = blocks
            .iter()
            .map(|block| Block {
                radius: block.radius.as_ref().map(|radius| radius - Rational::from((1, 100))),
                ..block.clone()
            })
            .collect();
        let path = super::model_path(&super::mill().parameters, &thin);
        let start = Instant::now();
        let verdict = check(&contour, &path, 1e-9);
        println!("{side:?}, 10 µm too near: check {:?}: {verdict:?}", start.elapsed());
    }
}
