//! A program told block by block, in the words of a machinist: what a block programs, which decisions its corner takes
//! and by what margin, which clause makes the point where it ends, and that point.
//!
//! [`Teller`] listens to the model and writes each block as soon as it is settled, in bounded memory.

mod axes;
mod coordinate;
mod decision;
mod event;
mod explanation;
mod programmed;
mod section;
mod sentence;
mod teller;

pub use axes::Axes;
pub use coordinate::{Coordinate, trimmed};
pub use decision::{Corner, in_words};
pub use event::{event, number};
pub use programmed::{Programmed, ProgrammedMove, Shape};
pub use section::Source;
pub use sentence::{first_sentence, wrapped};
pub use teller::{Choice, Teller};
