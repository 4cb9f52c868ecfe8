//! Tool-radius compensation in f64.
#![no_std]
