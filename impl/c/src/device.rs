//! The function that a device in a shared library exports, of this implementation.

use core::ffi::c_char;

use crate::block::radcomp_block;
use crate::state::{RADCOMP_MOST_STEPS, RADCOMP_STATE_SIZE, radcomp_finish, radcomp_new, radcomp_push, radcomp_state};
use crate::status::{RADCOMP_ALARM, RADCOMP_NULL, RADCOMP_OK, RADCOMP_SHORT};
use crate::step::{radcomp_alarm, radcomp_step};

/// The type of `radcomp_device`, for those who load it.
pub type DeviceFunction = unsafe extern "C" fn(
    profile: *const c_char,
    blocks: *const radcomp_block,
    block_count: usize,
    steps: *mut radcomp_step,
    capacity: usize,
    count: *mut usize,
    alarm: *mut radcomp_alarm,
) -> i32;

/// The path of the tool's centre for a whole program. A device that radcomp judges as `lib:FILE` is a shared library that
/// exports this function: it writes at most `capacity` elements to `steps` and their number to `count`, and to `alarm`
/// the alarm that has ended the program, or an empty name. `profile` is as in `radcomp_new`.
///
/// Returns RADCOMP_OK (with or without an alarm), RADCOMP_UNSUPPORTED, RADCOMP_SHORT if there are more elements, or another
/// error.
///
/// # Safety
///
/// `profile` ends with a zero, `blocks` is valid for `block_count` blocks, `steps` for `capacity` elements, `count` and
/// `alarm` can be written to.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn radcomp_device(
    profile: *const c_char,
    blocks: *const radcomp_block,
    block_count: usize,
    steps: *mut radcomp_step,
    capacity: usize,
    count: *mut usize,
    alarm: *mut radcomp_alarm,
) -> i32 {
    if blocks.is_null() || steps.is_null() || count.is_null() || alarm.is_null() {
        return RADCOMP_NULL;
    }
    let mut memory = [0_u8; RADCOMP_STATE_SIZE];
    let mut state: *mut radcomp_state = core::ptr::null_mut();
    // SAFETY: `memory` is ours and lives to the end of this function; `profile` is the caller's promise.
    let begun = unsafe { radcomp_new(memory.as_mut_ptr(), memory.len(), profile, &mut state) };
    if begun != RADCOMP_OK {
        return begun;
    }
    let mut written = 0;
    for index in 0..=block_count {
        let (mut room, mut more) = ([radcomp_step::default(); RADCOMP_MOST_STEPS], 0);
        // SAFETY: `state` is of `radcomp_new`, the buffers are ours, and block `index` is one of the caller's blocks;
        // `alarm` is the caller's promise.
        let status = unsafe {
            match index < block_count {
                true => radcomp_push(state, blocks.add(index), room.as_mut_ptr(), room.len(), &mut more, alarm),
                false => radcomp_finish(state, room.as_mut_ptr(), room.len(), &mut more, alarm),
            }
        };
        if status < 0 {
            return status;
        }
        if capacity - written < more {
            return RADCOMP_SHORT;
        }
        for step in &room[..more] {
            // SAFETY: `written` is less than `capacity`, for which the caller promises `steps` to be valid.
            unsafe { steps.add(written).write(*step) };
            written += 1;
        }
        // SAFETY: the caller promises that `count` can be written to.
        unsafe { count.write(written) };
        if status == RADCOMP_ALARM {
            break;
        }
    }
    RADCOMP_OK
}
