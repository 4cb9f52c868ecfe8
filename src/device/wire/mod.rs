//! The pipe protocol: JSON Lines, one request or answer a line ([`SCHEMA`]).
//!
//! A request holds all that a device may need, so that an adapter needs no state: the profile's parameters, the program
//! as G-code with its tool table, and the same program as blocks. Numbers of a program are exact decimals in strings. An
//! answer has the request's id, and gives the path of the tool's centre and the alarm, or says that the program is not
//! supported. Lengths are in millimetres, coordinates in the plane `(a, b)` of [TRC-PLANE-01]; blocks are counted from
//! 0, and the tool starts at (0, 0).

mod reply;
mod request;
mod serve;

pub(crate) use reply::shown;
pub use reply::{Reply, ReplyError};
pub use request::{ProfileRecord, Request, request};
pub use serve::{Asked, answer_line, serve};

/// The number of this protocol. It rises when a device that reads past what it does not know would answer another program
/// than the one it was asked: with every new field of a block and every new movement. A new parameter of the profile does
/// not change it, nor does a field that says the same in other words.
///
/// 2: vectors given by the program (`vector`, `held-vector`, `new-vector`, `corner-arc`) and `approach`.
pub const PROTOCOL: u64 = 2;

/// The JSON Schema of requests and answers.
pub const SCHEMA: &str = include_str!("../pipe.schema.json");
