//! The rules of tool-radius compensation, executed exactly.
//!
//! [`Engine`] takes blocks with rational coordinates one at a time and hands out the path of the tool's centre, every
//! coordinate an exact constructible number ([`number::Real`]). Every branch that geometry decides is one named
//! [`Decision`] with an exact sign and a margin in millimetres; a [`Sink`] sees each of them and may take another
//! branch, which is how a judge finds the outcomes that a device working in floating point may reach.
//!
//! One file of [`rules`](crate) stands for each chapter of the specification.

pub mod number;
pub mod tower;

mod decision;
mod element;
mod engine;
mod geometry;
mod rules;
mod run;
mod sweep;

pub use decision::{Decision, Sink, Stop};
pub use engine::Engine;
pub use geometry::Vector;
pub use rules::tip::tip;
pub use run::{Run, run, run_on_inputs, run_with};
