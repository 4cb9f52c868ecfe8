//! The one place where a rounded number becomes a decision, on every bit pattern.

use core::cmp::Ordering;

use radcomp_impl::sign::sign;

use crate::{Choice, reached};

/// Harness: the sign of -x is the reverse of the sign of x, whatever the scale.
pub fn odd(choice: &mut impl Choice) {
    let (value, scale) = (choice.number(), choice.number());
    if scale >= 0.0 {
        if sign(value, scale) == Ordering::Greater {
            reached!(choice, "a value above the band");
        }
        assert!(sign(-value, scale) == sign(value, scale).reverse(), "the sign is odd");
    }
}

/// Harness: a sign that is not `Equal` is that of the number itself, and larger than the band.
pub fn sound(choice: &mut impl Choice) {
    let (value, scale) = (choice.number(), choice.number());
    if scale >= 0.0 {
        match sign(value, scale) {
            Ordering::Greater => {
                reached!(choice, "a value above the band");
                assert!(value > 0.0, "above the band is positive");
            }
            Ordering::Less => {
                reached!(choice, "a value below the band");
                assert!(value < 0.0, "below the band is negative");
            }
            Ordering::Equal => {
                reached!(choice, "a value within the band");
                // Zero and what is not a number have no sign; no other number has none when the scale is zero.
                assert!(value == 0.0 || value.is_nan() || scale > 0.0, "a number without scale has its sign");
            }
        }
    }
}

/// Harness: what is not a number, either of the two, decides nothing.
pub fn not_a_number(choice: &mut impl Choice) {
    let number = choice.number();
    reached!(choice, "a number");
    assert!(sign(f64::NAN, number) == Ordering::Equal && sign(number, f64::NAN) == Ordering::Equal);
}
