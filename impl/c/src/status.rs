//! What functions return.

/// All is well.
pub const RADCOMP_OK: i32 = 0;
/// The program has raised an alarm, which ends it.
pub const RADCOMP_ALARM: i32 = 1;
/// The device does not take such a program.
pub const RADCOMP_UNSUPPORTED: i32 = 2;
/// A pointer is null.
pub const RADCOMP_NULL: i32 = -1;
/// A buffer is too short.
pub const RADCOMP_SHORT: i32 = -2;
/// The profile names a parameter or a value that there is not, or leaves a parameter out.
pub const RADCOMP_PROFILE: i32 = -3;
/// A block holds a value that is none.
pub const RADCOMP_BLOCK: i32 = -4;
/// The memory does not hold a state.
pub const RADCOMP_STATE: i32 = -5;
