//! The C interface: radcomp-impl for firmware that is written in C, and the function that a device in a shared library
//! exports. `include/radcomp.h` is written from this crate.
//!
//! Unsafe code stands here and nowhere else in the implementation. What C hands over is checked as far as it can be: null
//! pointers, short buffers, and values that are none are errors. That memory is valid for as many items as its length
//! says is the caller's promise.

#![cfg_attr(feature = "firmware", no_std)]
#![allow(non_camel_case_types, reason = "the types have their C names")]
#![allow(unsafe_code, reason = "the C boundary")]

mod block;
mod device;
mod profile;
mod state;
mod status;
mod step;

pub use block::*;
pub use device::*;
pub use profile::{parameters, ratio};
pub use state::*;
pub use status::*;
pub use step::*;

/// Where there is no std, a panic, which radcomp-impl does not have, stops the control.
#[cfg(all(feature = "firmware", not(test)))]
#[panic_handler]
fn stop(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// What the precompiled parts of Rust name for unwinding, which does not happen here.
#[cfg(all(feature = "firmware", not(test)))]
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
