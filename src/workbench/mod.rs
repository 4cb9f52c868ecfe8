//! The workbench: a page, served to a browser, where a program is typed, run by the exact model, drawn and explained.
//!
//! The server holds nothing between two requests, writes nothing and opens nothing: what a request brings is answered and
//! forgotten. No request makes it start a device or read a file. [`Limits`] bound each request in size and time.
//!
//! | request | answer |
//! |---|---|
//! | `GET /` and the files beside it | the page |
//! | `GET /rules.json` | the profiles, the clauses with their first sentences, and the example programs |
//! | `POST /run` | the outcome of a program, see [`run`] |
//! | `POST /blocks` | what there is to tell of the blocks in some lines, see [`blocks`] |
//! | `POST /path` | the path in exact numbers, see [`path`] |
//! | `POST /radii` | with which of some radii the program ends in an alarm |
//! | `POST /request` | the program as one request of the pipe protocol, for a device |
//!
//! Whatever is wrong with a request is told as `{"error": "…"}`, with the status that fits.

mod asked;
mod drawing;
mod outcome;
mod overlay;
mod page;
mod radii;
mod route;
mod server;
mod study;
mod told;
mod trouble;

use std::time::Duration;

pub use asked::Asked;
pub use outcome::run;
pub use server::Server;
pub use study::Patience;
pub use told::{blocks, path};
pub use trouble::Trouble;

/// The most blocks of a program in the workbench.
pub const MOST_BLOCKS: usize = 10_000;
/// The most blocks of a program whose device's answer is judged by the rules, forks and all.
pub const MOST_JUDGED: usize = 500;

/// What bounds a request.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// The most bytes of a request's body.
    pub body: usize,
    /// The most bytes of a request's head.
    pub head: usize,
    /// The most connections that are open at a time; more wait.
    pub connections: usize,
    /// Requests that are computed at a time; more wait.
    pub workers: usize,
    /// How long a head, or a body, may take to come, and a request may wait for a worker.
    pub patience: Duration,
    /// How long a request may be computed.
    pub computing: Duration,
    /// How long one connection is kept.
    pub connection: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            body: 4 << 20,
            head: 16 << 10,
            connections: 256,
            workers: std::thread::available_parallelism().map_or(2, usize::from),
            patience: Duration::from_secs(10),
            computing: Duration::from_secs(10),
            connection: Duration::from_secs(120),
        }
    }
}
