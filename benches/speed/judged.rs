//! Programs from the generator to a verdict.

/// Nanoseconds per ten-block program judged against the builtin device, or why there is no figure.
pub fn builtin(_: usize) -> Result<f64, &'static str> {
    Err("no judge yet")
}

/// Nanoseconds per ten-block program judged against LinuxCNC, or why there is no figure.
pub fn linuxcnc() -> Result<f64, &'static str> {
    Err("no judge yet")
}
