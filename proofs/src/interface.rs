//! The C interface: what C hands over is refused, or used within its bounds, whatever it is.

#![allow(unsafe_code, reason = "the C boundary")]

use core::ptr::{null, null_mut};

use radcomp_c::{
    RADCOMP_ALARM, RADCOMP_BLOCK, RADCOMP_MOST_STEPS, RADCOMP_NULL, RADCOMP_OK, RADCOMP_PROFILE, RADCOMP_SHORT,
    RADCOMP_STATE_SIZE, radcomp_alarm, radcomp_block, radcomp_finish, radcomp_new, radcomp_push, radcomp_state,
    radcomp_step, ratio,
};
use radcomp_spec::parameters::Ratio;

use crate::{Choice, engine, reached};

/// Bytes before the memory that is handed over, so that it begins at any address.
const BEFORE: usize = 16;
/// What memory that is not to be touched holds.
const UNTOUCHED: u8 = 0xa5;

/// Harness: `radcomp_new` with pointers that may be null, memory of any alignment and of a size near what it takes, and a
/// profile that is none: the status says what is wrong, and the memory and the pointer to the state stay as they were.
pub fn new(choice: &mut impl Choice) {
    let mut memory = [UNTOUCHED; BEFORE + RADCOMP_STATE_SIZE];
    let before = usize::from(choice.below(BEFORE as u8));
    let least = size_of::<radcomp_state>();
    let size = choice.of(&[0, 1, least - 1, least, least + align_of::<radcomp_state>(), RADCOMP_STATE_SIZE]);
    let mut state = null_mut();
    let place = memory.as_mut_ptr().wrapping_add(before);
    let [no_memory, no_profile, no_state] = [choice.flag(), choice.flag(), choice.flag()];
    let profile = if no_profile { null() } else { c"".as_ptr() };
    // SAFETY: a pointer that is not null is valid: `before` and `size` lie within the array, and the text ends with a zero.
    let status = unsafe {
        radcomp_new(
            if no_memory { null_mut() } else { place },
            size,
            profile,
            if no_state { null_mut() } else { &mut state },
        )
    };
    assert!((status == RADCOMP_NULL) == (no_memory || no_profile || no_state), "a null pointer is an error");
    if status == RADCOMP_SHORT {
        reached!(choice, "memory that is too short");
        assert!(size < least + align_of::<radcomp_state>(), "as much as any address takes is enough");
    } else if status == RADCOMP_PROFILE {
        reached!(choice, "a profile that is none");
        assert!(size >= least, "memory that holds no state is too short");
    } else {
        reached!(choice, "a null pointer");
        assert!(status == RADCOMP_NULL, "an empty profile is none");
    }
    assert!(state.is_null(), "no state is handed out");
    // Any one byte, which saves a solver the loop over all of them.
    let at = usize::from(choice.below(17)) * 255 + usize::from(choice.below(255));
    assert!(memory.get(at).is_none_or(|byte| *byte == UNTOUCHED), "nothing is written");
}

/// Harness: two calls of `radcomp_push` or `radcomp_finish` with pointers that may be null, any capacity up to one more
/// than is needed, and blocks of any kinds: the status says what is wrong, nothing is written behind the capacity, and
/// as many elements as `count` says.
pub fn calls(choice: &mut impl Choice) {
    let mut state = radcomp_state::new(&engine::plain());
    for _ in 0..2 {
        let mut steps = [radcomp_step { block: u64::MAX, ..radcomp_step::default() }; RADCOMP_MOST_STEPS + 1];
        let (mut count, mut alarm) = (usize::MAX, radcomp_alarm::default());
        let capacity = choice.of(&[0, 1, RADCOMP_MOST_STEPS - 1, RADCOMP_MOST_STEPS]);
        let nothing = choice.below(6);
        let block = if choice.flag() { Some(block(choice)) } else { None };
        let to = if nothing == 2 { null_mut() } else { steps.as_mut_ptr() };
        let told = if nothing == 3 { null_mut() } else { &raw mut count };
        let why = if nothing == 4 { null_mut() } else { &raw mut alarm };
        let with = if nothing == 1 { null_mut() } else { &raw mut state };
        // SAFETY: a pointer that is not null is valid, `steps` for more elements than `capacity`.
        let status = unsafe {
            match &block {
                Some(_) if nothing == 5 => radcomp_push(with, null(), to, capacity, told, why),
                Some(block) => radcomp_push(with, block, to, capacity, told, why),
                None => radcomp_finish(with, to, capacity, told, why),
            }
        };
        if status == RADCOMP_OK || status == RADCOMP_ALARM {
            assert!((status == RADCOMP_ALARM) == (alarm.name[0] != 0), "an alarm has a name, and nothing else has");
            if status == RADCOMP_ALARM {
                reached!(choice, "an alarm");
            } else {
                reached!(choice, "a call that is well");
            }
            assert!(count <= capacity, "no more elements than there is room for");
            assert!(steps[..count].iter().all(|step| step.block != u64::MAX), "each element is written");
            assert!(steps[count..].iter().all(|step| step.block == u64::MAX), "and no other");
        } else {
            let refused = [RADCOMP_NULL, RADCOMP_SHORT, RADCOMP_BLOCK];
            assert!(refused.contains(&status), "a state of `radcomp_new` is one");
            reached!(choice, "a call that is refused");
            assert!(count == usize::MAX && steps.iter().all(|step| step.block == u64::MAX), "nothing is written");
        }
    }
}

/// A block of C, its codes beyond those that there are as well.
fn block(choice: &mut impl Choice) -> radcomp_block {
    radcomp_block {
        movement: u32::from(choice.below(3)) * 2,
        compensation: u32::from(choice.below(3)) * 2,
        has_radius: 1,
        radius: choice.number(),
        end: [choice.number(), 1.0],
        ..radcomp_block::default()
    }
}

/// Harness: the number reader on `N` bytes, as many of them as the choice takes: no panic, and a number exactly where
/// the bytes are digits with at most one point or stroke between two of them, whose parts fit 32 bits; then its parts
/// are the digits'.
pub fn number<const N: usize>(choice: &mut impl Choice, alphabet: &[u8]) {
    let mut bytes = [0; N];
    let length = usize::from(choice.below(N as u8 + 1));
    for byte in &mut bytes[..length] {
        *byte = if alphabet.is_empty() { choice.below(u8::MAX) } else { choice.of(alphabet) };
    }
    let Ok(text) = core::str::from_utf8(&bytes[..length]) else { return };
    let read = ratio(text);
    match expected(text.as_bytes()) {
        Some(ratio) => {
            reached!(choice, "a number");
            assert!(read == Some(ratio), "the digits are the number");
        }
        None => {
            reached!(choice, "no number");
            assert!(read.is_none(), "what is no number is none");
        }
    }
}

/// What the bytes stand for, digit by digit.
fn expected(bytes: &[u8]) -> Option<Ratio> {
    let (mut parts, mut digits, mut separator) = ([0_u64; 2], [0_u32; 2], None);
    for &byte in bytes {
        let part = usize::from(separator.is_some());
        match byte {
            b'0'..=b'9' => {
                parts[part] = (parts[part] * 10 + u64::from(byte - b'0')).min(1 << 40);
                digits[part] += 1;
            }
            b'.' | b'/' if separator.is_none() => separator = Some(byte),
            _ => return None,
        }
    }
    let [first, second] = parts;
    if digits[0] == 0 || separator.is_some() && digits[1] == 0 {
        return None;
    }
    let (numerator, denominator) = match separator {
        Some(b'/') if second == 0 => return None,
        Some(b'/') => (first, second),
        _ => {
            let power = 10_u64.checked_pow(digits[1])?;
            (first.checked_mul(power)?.checked_add(second)?, power)
        }
    };
    Some(Ratio { numerator: u32::try_from(numerator).ok()?, denominator: u32::try_from(denominator).ok()? })
}
