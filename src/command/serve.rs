//! `radcomp serve`.

use std::io::Write;
use std::time::Duration;

use clap::Args;
use radcomp::workbench::{Limits, MOST_BLOCKS, Server};

use super::failure::{Failure, Verdict};
use super::terminal;

/// Open the workbench: a page that runs, draws and explains a program as it is typed
#[derive(Debug, Args)]
#[command(after_help = format!("\
The address of the page is printed. The page loads nothing from elsewhere and sends
nothing elsewhere; a link that it makes carries the program behind its #, which
browsers keep to themselves. A program has at most {MOST_BLOCKS} blocks there.

Whoever reaches the address may use the workbench: it has no password.

Examples:
  radcomp serve
  radcomp serve --listen 127.0.0.1:0"))]
pub struct Serve {
    /// Where to listen; port 0 is a free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:4044")]
    listen: String,

    /// How long a request may take to come, and to be computed
    #[arg(long, value_name = "SECONDS", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3600))]
    time_limit: u64,
}

impl Serve {
    /// Serves until Ctrl-C.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let time = Duration::from_secs(self.time_limit);
        let default = Limits::default();
        let connection = default.connection.max(4 * time);
        let limits = Limits { patience: time, computing: time, connection, ..default };
        let refused =
            |error| Failure::Input(format!("{} cannot be listened at: {error}; --listen takes another", self.listen));
        let server = Server::bind(&self.listen, limits).map_err(refused)?;
        let mut out = terminal::output();
        writeln!(out, "the workbench is at http://{}/ until Ctrl-C", server.address()?)?;
        out.flush()?;
        server.run().map_err(|error| Failure::Input(format!("the workbench cannot be served: {error}")))?;
        Ok(Verdict::Green)
    }
}
