//! Tool-radius compensation (G40, G41, G42) in f64, as the firmware of a control would do it: streaming, in fixed
//! memory, without allocation, without panics.
//!
//! The rules are the clauses of `radcomp-spec`, cited as `[TRC-…]`. An [`Engine`] takes blocks one by one and hands
//! each element of the path of the tool's centre to a [`Sink`] as soon as it is settled; it holds one element and
//! counts the blocks without movement behind it, never more. Where vectors of several blocks are compared ([TRC-INT-04]),
//! up to seven elements that are settled are held back behind it.
//!
//! # Exactness
//! Inputs are decimals rounded to f64. Every decision that a sign makes goes through [`sign::sign`], whose band is a
//! bound of rounding: geometry that is degenerate exactly (a tangent junction, a reversal, a tool that just fits,
//! curves that touch) is taken for what it is. The coordinates of vectors are off by some units in the last place of
//! the largest coordinate, times what the conditioning of an intersection makes of it. No input, of whatever bit
//! pattern, makes a coordinate that is not finite: numbers out of range are an alarm ([TRC-MODE-07]).

#![cfg_attr(not(test), no_std)]

mod arc_form;
mod corner;
mod element;
pub mod engine;
mod entry;
pub mod geometry;
mod held;
mod imaginary;
mod inner;
mod interference;
mod junction;
mod meet;
mod path;
mod plane;
mod rules;
mod scene;
mod side_change;
pub mod sign;
mod type_b;
mod wedge;
pub mod window;

pub use engine::{Engine, Sink};
