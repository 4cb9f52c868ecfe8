//! Compensation, block by block, in memory that the caller brings.

use core::ffi::{CStr, c_char};
use core::mem::{align_of, size_of};

use radcomp_impl::{Engine, Sink};
use radcomp_spec::{Alarm, Parameters, Step};

use crate::block::radcomp_block;
use crate::profile::parameters;
use crate::status::{
    RADCOMP_ALARM, RADCOMP_BLOCK, RADCOMP_NULL, RADCOMP_OK, RADCOMP_PROFILE, RADCOMP_SHORT, RADCOMP_STATE,
};
use crate::step::{radcomp_alarm, radcomp_step};

/// The compensation of one program. It lies in the memory that `radcomp_new` was given, and needs no end.
pub struct radcomp_state {
    mark: u64,
    engine: Engine,
}

impl radcomp_state {
    /// The state of a program that begins, for callers in Rust.
    pub fn new(parameters: &Parameters) -> Self {
        radcomp_state { mark: MARK, engine: Engine::new(parameters) }
    }
}

/// As many bytes as the memory of a state has to have, at any address.
pub const RADCOMP_STATE_SIZE: usize = 4096;

/// The most elements that one call of `radcomp_push` or `radcomp_finish` gives.
pub const RADCOMP_MOST_STEPS: usize = 128;

/// What a state begins with.
const MARK: u64 = 0x7261_6463_6f6d_7031;

const _: () = assert!(size_of::<radcomp_state>() + align_of::<radcomp_state>() <= RADCOMP_STATE_SIZE);

/// Begins a program in `memory` of at least RADCOMP_STATE_SIZE bytes. `profile` is text with a zero at its end: a line
/// `name = value` for each parameter of the compensation, by the names of spec/PARAMETERS.md. The state, which is to be
/// given to the other functions, is stored in `state`; the memory is to stay where it is until the program has ended.
///
/// Returns RADCOMP_OK, RADCOMP_NULL, RADCOMP_SHORT or RADCOMP_PROFILE.
///
/// # Safety
///
/// `memory` is valid for `size` bytes, `profile` ends with a zero, and `state` can be written to.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn radcomp_new(
    memory: *mut u8,
    size: usize,
    profile: *const c_char,
    state: *mut *mut radcomp_state,
) -> i32 {
    if memory.is_null() || profile.is_null() || state.is_null() {
        return RADCOMP_NULL;
    }
    let offset = memory.align_offset(align_of::<radcomp_state>());
    if offset.checked_add(size_of::<radcomp_state>()).is_none_or(|end| end > size) {
        return RADCOMP_SHORT;
    }
    // SAFETY: the caller promises a zero at the end.
    let text = unsafe { CStr::from_ptr(profile) };
    let Some(parameters) = text.to_str().ok().and_then(parameters) else { return RADCOMP_PROFILE };
    let place = memory.wrapping_add(offset).cast::<radcomp_state>();
    // SAFETY: `place` is aligned, and the state ends within the `size` bytes that the caller promises.
    unsafe { place.write(radcomp_state::new(&parameters)) };
    // SAFETY: the caller promises that `state` can be written to.
    unsafe { state.write(place) };
    RADCOMP_OK
}

/// Reads the next block. The elements of the path that this settles are written to `steps`, which has room for at least
/// RADCOMP_MOST_STEPS of them, and their number to `count`. After an alarm, which is written to `alarm`, every call
/// returns the same alarm and gives no elements.
///
/// Returns RADCOMP_OK, RADCOMP_ALARM, RADCOMP_NULL, RADCOMP_SHORT, RADCOMP_BLOCK or RADCOMP_STATE.
///
/// # Safety
///
/// `state` is of `radcomp_new` and used by no other thread, `block` can be read, `steps` is valid for `capacity`
/// elements, `count` and `alarm` can be written to.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn radcomp_push(
    state: *mut radcomp_state,
    block: *const radcomp_block,
    steps: *mut radcomp_step,
    capacity: usize,
    count: *mut usize,
    alarm: *mut radcomp_alarm,
) -> i32 {
    if block.is_null() {
        return RADCOMP_NULL;
    }
    // SAFETY: the caller promises that the block can be read.
    let Some(block) = unsafe { block.read() }.block() else { return RADCOMP_BLOCK };
    // SAFETY: the caller's promises are the same.
    unsafe { advance(state, steps, capacity, count, alarm, |engine, sink| engine.push(&block, sink)) }
}

/// Ends the program. As `radcomp_push`, without a block.
///
/// # Safety
///
/// As of `radcomp_push`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn radcomp_finish(
    state: *mut radcomp_state,
    steps: *mut radcomp_step,
    capacity: usize,
    count: *mut usize,
    alarm: *mut radcomp_alarm,
) -> i32 {
    // SAFETY: the caller's promises are the same.
    unsafe { advance(state, steps, capacity, count, alarm, |engine, sink| engine.finish(sink)) }
}

/// # Safety
///
/// As of `radcomp_push`.
unsafe fn advance(
    state: *mut radcomp_state,
    steps: *mut radcomp_step,
    capacity: usize,
    count: *mut usize,
    alarm: *mut radcomp_alarm,
    work: impl FnOnce(&mut Engine, &mut Buffer) -> Result<(), Alarm>,
) -> i32 {
    if state.is_null() || steps.is_null() || count.is_null() || alarm.is_null() {
        return RADCOMP_NULL;
    }
    if capacity < RADCOMP_MOST_STEPS {
        return RADCOMP_SHORT;
    }
    // SAFETY: the caller promises a state that `radcomp_new` has written, used by no other thread.
    let state = unsafe { &mut *state };
    if state.mark != MARK {
        return RADCOMP_STATE;
    }
    let mut buffer = Buffer { steps, capacity, count: 0, lost: false };
    let result = work(&mut state.engine, &mut buffer);
    // SAFETY: the caller promises that `count` and `alarm` can be written to.
    unsafe {
        count.write(buffer.count);
        alarm.write(result.err().map_or_else(radcomp_alarm::default, radcomp_alarm::from));
    }
    match result {
        _ if buffer.lost => RADCOMP_SHORT,
        Ok(()) => RADCOMP_OK,
        Err(_) => RADCOMP_ALARM,
    }
}

/// The caller's memory, filled element by element.
struct Buffer {
    steps: *mut radcomp_step,
    capacity: usize,
    count: usize,
    lost: bool,
}

impl Sink for Buffer {
    fn step(&mut self, step: Step<f64>) {
        if self.count == self.capacity {
            self.lost = true;
            return;
        }
        // SAFETY: `count` is less than the `capacity` elements that the caller promises.
        unsafe { self.steps.add(self.count).write(radcomp_step::from(&step)) };
        self.count += 1;
    }
}
