//! The rules of tool-radius compensation, executed exactly.

pub mod number;
