//! The harnesses as Kani runs them: every choice is any value at all.
//!
//! `unwind` is one more than the most turns of any loop: of the look-ahead's over the blocks it holds, and of the
//! harness over its events.

use crate::{Choice, engine, interface, look_ahead, rounding};

#[cfg(kani_stand_in)]
use crate::kani;

/// Any choice.
struct Any;

impl Choice for Any {
    fn below(&mut self, bound: u8) -> u8 {
        let value: u8 = kani::any();
        kani::assume(value < bound);
        value
    }

    fn number(&mut self) -> f64 {
        kani::any()
    }
}

/// `name: unwind, body;`: a proof of each.
macro_rules! proofs {
    ($($(#[$doc:meta])* $name:ident: $unwind:literal, $body:expr;)*) => {
        $(
            $(#[$doc])*
            #[cfg_attr(not(kani_stand_in), kani::proof)]
            #[cfg_attr(not(kani_stand_in), kani::unwind($unwind))]
            #[cfg_attr(kani_stand_in, allow(dead_code))]
            fn $name() {
                let body: fn(&mut Any) = $body;
                body(&mut Any);
            }
        )*
    };
}

proofs! {
    look_ahead_of_four_events: 6, |choice| look_ahead::programs(choice, 4, 2);
    look_ahead_of_eight_events: 10, |choice| look_ahead::programs(choice, 8, 2);
    look_ahead_of_the_longest_run: 12, |choice| look_ahead::programs(choice, 10, 8);
    one_block_without_arcs: 5, |choice| engine::one_block(choice, 3);
    one_block: 5, |choice| engine::one_block(choice, 4);
    two_lines: 5, |choice| engine::programs(choice, &engine::plain(), 2, 2);
    state_after_an_alarm: 5, |choice| engine::after_an_alarm(choice, 3);
    new_of_the_c_interface: 4, interface::new;
    calls_of_the_c_interface: 50, interface::calls;
    number_reader: 7, |choice| interface::number::<5>(choice, &[]);
    sign_is_odd: 2, rounding::odd;
    sign_is_sound: 2, rounding::sound;
    sign_of_not_a_number: 2, rounding::not_a_number;
}
