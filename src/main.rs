//! The command `radcomp`.
fn main() {}
