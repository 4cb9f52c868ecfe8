//! How many blocks a second the model takes. Run with
//! `cargo test --release -p radcomp-model --test speed -- --ignored --nocapture`.

use std::time::Instant;

use radcomp_model::{Engine, Sink};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Compensation, Movement, Side};
use rug::Rational;

/// Takes nothing, so that only the engine is measured.
struct Silent;

impl Sink for Silent {}

fn to(a: i64, b: i64) -> Block<Rational> {
    Block::moving(Movement::Line { end: [Rational::from((a, 1000)), Rational::from((b, 1000))] })
}

#[test]
#[ignore = "a measurement"]
fn lines() {
    let parameters = Profile::builtin("seed-mill").expect("a built-in profile").parameters;
    let blocks = 100_000;
    for _ in 0..3 {
        let mut engine = Engine::new(&parameters);
        let first = Block {
            compensation: Some(Compensation::On(Side::Left)),
            radius: Some(Rational::from(5)),
            ..to(20_000, 15_000)
        };
        let start = Instant::now();
        engine.push(&first, &mut Silent).expect("no alarm");
        for i in 1..blocks {
            let block = to(20_000 + i * 30_000 + i * 7 % 9001, i % 2 * 40_000 + i * 13 % 7001);
            engine.push(&block, &mut Silent).expect("no alarm");
        }
        println!("{:.0} blocks per second", blocks as f64 / start.elapsed().as_secs_f64());
    }
}
