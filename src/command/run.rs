//! `radcomp run`.

mod canon;
mod implementation;
mod json;
mod model;
mod text;

use std::io::{self, Write};

use clap::{Args, ValueEnum};
use radcomp::explain::Coordinate;
use radcomp::gcode::Diagnostic;
use radcomp_model::number::Real;
use radcomp_spec::{Advisory, Alarm, Step};

use super::failure::{Failure, Verdict};
use super::ledger::Ledger;
use super::options::Options;
use super::program::{Control, Placed};
use super::{alarm, terminal};

/// Run a program and print the path of the tool's centre, each element as soon as it is settled
#[derive(Debug, Args)]
#[command(after_help = "\
Formats:
  text   a line for each path element: line, N number, kind, end point in the axes
         and measures of the program, the clause that made it; where the decimals
         do not tell all, closed forms such as X = 10 + 5·√2
  json   one document: \"events\" holds path elements (kind line, arc or hold) and
         advisories in order, one a line; \"alarm\" and \"refused\" after them are null
         or say what stopped the program; coordinates are, by axis,
         {\"decimal\": \"17.071067811865\", \"exact\": \"10 + 5·√2\"}, exact null if long
  canon  the canonical calls of LinuxCNC's rs274; X is a radius value

An alarm goes to the standard error output.

Examples:
  radcomp run examples/first.nc --profile seed-mill --tools examples/tools.toml
  radcomp run examples/turning.nc -p yasnac-lx -t examples/tools.toml -f json --tip
  generate | radcomp run - --profile seed-mill --radius 5 --format canon | less")]
pub struct Run {
    #[command(flatten)]
    options: Options,

    /// What runs the program; the implementation gives no advisories
    #[arg(long, value_enum, default_value_t = Engine::Model)]
    engine: Engine,

    /// What is printed
    #[arg(long, short, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Digits after the decimal point: 6 in text, 12 in json; canon has 17 significant digits
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(0..=1000))]
    digits: Option<u16>,

    /// Give the imaginary tool tip of a lathe too, at the end of each element; not in canon
    #[arg(long)]
    tip: bool,
}

/// What runs a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Engine {
    /// The exact reference model
    Model,
    /// The implementation in f64
    Impl,
}

/// How the outcome is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs
    Json,
    /// The canonical calls of rs274
    Canon,
}

/// How a run ended.
enum Ending {
    /// With the program.
    Complete,
    /// At an alarm.
    Alarm(Alarm),
    /// At a line that cannot be read.
    Refused(Box<Diagnostic>),
}

/// Prints an outcome as it comes.
trait Print<N> {
    /// A path element.
    fn step(&mut self, out: &mut dyn Write, step: &Step<N>, block: &Placed) -> io::Result<()>;

    /// A warning.
    fn advisory(&mut self, out: &mut dyn Write, advisory: &Advisory<N>, block: &Placed) -> io::Result<()>;

    /// The end.
    fn end(&mut self, out: &mut dyn Write, ending: &Ending, ledger: &Ledger) -> io::Result<()>;
}

/// Where an engine's answers go.
struct Outlet<'p, N> {
    out: Box<dyn Write>,
    print: Box<dyn Print<N> + 'p>,
    ledger: Ledger,
    result: io::Result<()>,
}

impl Run {
    /// Runs the program and prints it.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let (control, source) = self.options.open()?;
        let blocks = control.blocks(source);
        match self.engine {
            Engine::Model => model::run(&control, blocks, self.outlet(&control, Real::zero())),
            Engine::Impl => implementation::run(&control, blocks, self.outlet(&control, 0.0)),
        }
    }

    fn outlet<'p, N: Coordinate + 'p>(&self, control: &'p Control, zero: N) -> Outlet<'p, N> {
        let digits = |default| self.digits.map_or(default, usize::from);
        let print: Box<dyn Print<N> + 'p> = match self.format {
            Format::Text => {
                let tip = self.tip.then_some(&control.profile.parameters);
                Box::new(text::Text { digits: digits(6), tip, count: 0 })
            }
            Format::Json => Box::new(json::Json::new(control, self.engine, digits(12), self.tip)),
            Format::Canon => Box::new(canon::CanonCalls::new(zero, self.digits.map(usize::from))),
        };
        Outlet { out: terminal::output(), print, ledger: Ledger::default(), result: Ok(()) }
    }
}

impl<N> Outlet<'_, N> {
    /// Prints a path element; the blocks before its own are settled.
    fn step(&mut self, step: &Step<N>) {
        self.ledger.forget_before(step.block);
        if let (Ok(()), Some(block)) = (&self.result, self.ledger.block(step.block)) {
            self.result = self.print.step(&mut self.out, step, block);
        }
    }

    /// Prints a warning.
    fn advisory(&mut self, advisory: &Advisory<N>) {
        if let (Ok(()), Some(block)) = (&self.result, self.ledger.block(advisory.block)) {
            self.result = self.print.advisory(&mut self.out, advisory, block);
        }
    }

    /// How printing went so far.
    fn printed(&mut self) -> io::Result<()> {
        std::mem::replace(&mut self.result, Ok(()))
    }

    /// Prints the end, and tells what stopped the program.
    fn end(mut self, control: &Control, ending: Ending) -> Result<Verdict, Failure> {
        self.printed()?;
        self.print.end(&mut self.out, &ending, &self.ledger)?;
        self.out.flush()?;
        match ending {
            Ending::Complete => Ok(Verdict::Green),
            Ending::Refused(diagnostic) => Err(Failure::Diagnostic(diagnostic)),
            Ending::Alarm(raised) => {
                if let Some(block) = self.ledger.block(raised.block) {
                    alarm::report(control, raised, &block.source);
                }
                Ok(Verdict::Red)
            }
        }
    }
}
