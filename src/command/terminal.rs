//! Where text goes, with colours on a terminal only.

use std::io::{self, BufWriter, IsTerminal, Write};

use annotate_snippets::Renderer;

/// The standard output: in large pieces to a file or a pipe, line by line to a terminal.
pub fn output() -> Box<dyn Write> {
    let stdout = io::stdout();
    match stdout.is_terminal() {
        true => Box::new(stdout),
        false => Box::new(BufWriter::with_capacity(1 << 16, stdout)),
    }
}

/// Whether the standard output takes colours.
pub fn is_colourful() -> bool {
    io::stdout().is_terminal() && wants_colours()
}

/// The renderer of diagnostics for the standard error output.
pub fn renderer() -> Renderer {
    if complains_in_colour() { Renderer::styled() } else { Renderer::plain() }
}

/// Writes to the standard error output. Nothing can be done if that fails.
pub fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// A word in red, if the standard error output takes colours.
pub fn red(word: &str) -> String {
    if complains_in_colour() { format!("\u{1b}[1;31m{word}\u{1b}[0m") } else { word.to_owned() }
}

/// A word in bold, if the standard output takes colours.
pub fn bold(word: &str) -> String {
    if is_colourful() { format!("\u{1b}[1m{word}\u{1b}[0m") } else { word.to_owned() }
}

fn complains_in_colour() -> bool {
    io::stderr().is_terminal() && wants_colours()
}

/// https://no-color.org
fn wants_colours() -> bool {
    std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}
