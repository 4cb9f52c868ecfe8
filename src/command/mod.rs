//! The command line: one file for each subcommand.

mod alarm;
mod answer;
mod book;
mod certificate;
mod certify;
mod check;
mod clause;
mod compare;
mod completions;
mod device;
mod device_kit;
mod evidence;
mod explain;
mod failure;
mod r#gen;
mod judging;
mod ledger;
mod merge;
mod nearest;
mod options;
mod ping;
mod plot;
mod profiles;
mod program;
mod promote;
mod replay;
mod results;
mod run;
mod safety;
mod serve;
mod terminal;
mod verify_witness;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::{Failure, Verdict};

/// Where the tool goes when a CNC control compensates for its radius, exactly.
#[derive(Debug, Parser)]
#[command(name = "radcomp", version, about, max_term_width = 100, arg_required_else_help = true, after_help = EXAMPLES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  radcomp run examples/first.nc --profile seed-mill --tools examples/tools.toml
  radcomp explain examples/first.nc --profile seed-mill --tools examples/tools.toml --block 40
  radcomp plot examples/first.nc --profile seed-mill --tools examples/tools.toml -o first.svg
  radcomp certify builtin --profile yasnac-lx --level 1
  radcomp device-kit python
  radcomp ping \"pipe:python3 adapter.py\"
  radcomp verify-witness report.json
  radcomp replay report.json
  radcomp compare before.json after.json
  radcomp certificate report.json --make-key key.pem --output certificate.json
  radcomp serve
  radcomp profiles yasnac-lx
  radcomp clause TRC-CORNER-08

Exit status: 0 all is well; 1 an alarm or a red verdict; 2 wrong usage or input.";

// A subcommand is one variant here and one file beside this one.
#[derive(Debug, Subcommand)]
enum Command {
    Run(run::Run),
    Explain(explain::Explain),
    Plot(plot::Plot),
    Safety(safety::Safety),
    Profiles(profiles::Profiles),
    Certify(certify::Certify),
    Ping(ping::Ping),
    DeviceKit(device_kit::DeviceKit),
    Gen(r#gen::Gen),
    Check(check::Check),
    Merge(merge::Merge),
    Serve(serve::Serve),
    Answer(answer::Answer),
    VerifyWitness(verify_witness::VerifyWitness),
    Replay(replay::Replay),
    Compare(compare::Compare),
    Certificate(certificate::Certificate),
    VerifyCertificate(certificate::VerifyCertificate),
    Promote(promote::Promote),
    Clause(clause::Clauses),
    Book(book::Book),
    Ledger(evidence::Ledger),
    Completions(completions::Completions),
}

/// Runs the command that the arguments ask for.
pub fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Run(command) => command.execute(),
        Command::Explain(command) => command.execute(),
        Command::Plot(command) => command.execute(),
        Command::Safety(command) => command.execute(),
        Command::Profiles(command) => command.execute(),
        Command::Certify(command) => command.execute(),
        Command::Ping(command) => command.execute(),
        Command::DeviceKit(command) => command.execute(),
        Command::Gen(command) => command.execute(),
        Command::Check(command) => command.execute(),
        Command::Merge(command) => command.execute(),
        Command::Serve(command) => command.execute(),
        Command::Answer(command) => command.execute(),
        Command::VerifyWitness(command) => command.execute(),
        Command::Replay(command) => command.execute(),
        Command::Compare(command) => command.execute(),
        Command::Certificate(command) => command.execute(),
        Command::VerifyCertificate(command) => command.execute(),
        Command::Promote(command) => command.execute(),
        Command::Clause(command) => command.execute(),
        Command::Book(command) => command.execute(),
        Command::Ledger(command) => command.execute(),
        Command::Completions(command) => command.execute(),
    };
    match result {
        Ok(Verdict::Green) => ExitCode::SUCCESS,
        Ok(Verdict::Red) => ExitCode::from(1),
        Err(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            failure.report();
            ExitCode::from(2)
        }
    }
}
