//! The command `radcomp`, end to end.

#[path = "command/broken.rs"]
mod broken;
#[path = "command/explain.rs"]
mod explain;
#[path = "command/large.rs"]
mod large;
#[path = "command/lookup.rs"]
mod lookup;
#[path = "command/plot.rs"]
mod plot;
#[path = "command/run.rs"]
mod run;

use std::path::Path;

use assert_cmd::Command;

/// The command, in the repository's root, where `examples/` is.
fn radcomp(arguments: &[&str]) -> Command {
    // assert_cmd finds the binary that cargo built for these tests.
    let mut command = Command::cargo_bin("radcomp").unwrap();
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(arguments);
    command
}

/// The command with a program on its standard input, on seed-mill with a tool radius of 5 mm.
fn mill(subcommand: &str, more: &[&str], program: &str) -> Command {
    let mut command = radcomp(&[subcommand, "-", "--profile", "seed-mill", "--radius", "5"]);
    command.args(more).write_stdin(program.to_owned());
    command
}

/// What a command that ends well prints.
fn printed(mut command: Command) -> String {
    let output = command.assert().success().stderr("").get_output().stdout.clone();
    String::from_utf8(output).unwrap()
}

/// What a command that ends with this status complains of.
fn complaint(mut command: Command, status: i32) -> String {
    let output = command.assert().code(status).get_output().stderr.clone();
    String::from_utf8(output).unwrap()
}

/// Whether every line of a text is fit to read in a terminal.
fn is_short(text: &str) -> bool {
    text.lines().count() <= 8
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    std::fs::read_to_string(path).unwrap()
}
