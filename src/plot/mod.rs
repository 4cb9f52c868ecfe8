//! A picture of a program: the programmed contour, the path of the tool's centre, the tool at its vectors.
//!
//! Coordinates are drawn as doubles; nothing is decided here.

mod comparison;
mod draw;
mod figure;
mod frame;
mod labels;
mod legend;
mod piece;
mod scene;

pub use comparison::comparison;
pub use draw::svg;
pub use figure::figure;
pub use piece::{Form, Piece, Trace};
pub use scene::{Mark, MarkKind, Scene};
