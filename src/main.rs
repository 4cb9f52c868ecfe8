//! The command `radcomp`.

mod command;

fn main() -> std::process::ExitCode {
    command::main()
}
