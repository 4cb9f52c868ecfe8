//! impl
#![no_std]
