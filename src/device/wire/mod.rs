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

/// The number of this protocol; it changes when a device of the old one would misread a request of the new one.
pub const PROTOCOL: u64 = 1;

/// The JSON Schema of requests and answers.
pub const SCHEMA: &str = include_str!("../pipe.schema.json");
