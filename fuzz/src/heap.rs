//! A heap of its own for targets that are safe Rust and GMP throughout.
//!
//! The address sanitizer keeps account of every allocation, with the stack that asked for it, and exact numbers live on the
//! heap. GMP is not built with the sanitizer, so that nothing of its use of that memory is checked anyway; and safe Rust
//! does not reach beyond what it asked for. The targets with C interfaces, and `kernels`, which has all the same numbers,
//! keep the sanitizer's heap.

use std::alloc::{Layout, alloc, handle_alloc_error, realloc};
use std::ffi::c_void;

/// Makes GMP ask Rust's global allocator for its memory.
///
/// # Safety
///
/// GMP must not have been used before.
pub unsafe fn give_to_gmp() {
    // SAFETY: the three functions agree on where memory comes from, and nothing has been given out yet.
    unsafe {
        gmp_mpfr_sys::gmp::set_memory_functions(Some(give), Some(give_again), Some(take));
    }
}

/// As GMP asks: aligned for any of its types, and never null.
fn layout(size: usize) -> Layout {
    Layout::from_size_align(size.max(1), align_of::<u128>()).unwrap_or_else(|_| std::process::abort())
}

extern "C" fn give(size: usize) -> *mut c_void {
    // SAFETY: no layout has a size of 0.
    let given = unsafe { alloc(layout(size)) };
    if given.is_null() {
        handle_alloc_error(layout(size));
    }
    given.cast()
}

unsafe extern "C" fn give_again(at: *mut c_void, old: usize, new: usize) -> *mut c_void {
    // SAFETY: GMP hands back what `give` or this function gave, with its size.
    let given = unsafe { realloc(at.cast(), layout(old), layout(new).size()) };
    if given.is_null() {
        handle_alloc_error(layout(new));
    }
    given.cast()
}

unsafe extern "C" fn take(at: *mut c_void, size: usize) {
    // SAFETY: as above.
    unsafe { std::alloc::dealloc(at.cast(), layout(size)) }
}
