//! `radcomp safety`.

use std::io::Write;

use clap::{Args, ValueEnum};
use radcomp::device::{Answer, Builtin, Device, DeviceFault};
use radcomp::safety::{Contour, Finding, Gouge, SafetyVerdict, check};
use radcomp_model::run;

use super::failure::{Failure, Verdict};
use super::options::Options;
use super::program::{Control, Placed};
use super::{alarm, terminal};

/// Prove that the tool never enters the part, or show where it does worst
#[derive(Debug, Args)]
#[command(after_help = "\
The verdict knows no rules: it looks at the programmed contour, its sides, the tool
radius and the path alone. A proof holds along the whole path, lines and arcs. Moves
of start-up and cancel blocks are judged apart; they, and material left uncut, do
not change the exit status.

Exit status: 0 safe; 1 it gouges, or it may, or an alarm stops the program.

Examples:
  radcomp safety examples/first.nc --profile seed-mill --tools examples/tools.toml
  radcomp safety part.nc -p yasnac-lx -t tools.toml --engine impl --budget 0.0001")]
pub struct Safety {
    #[command(flatten)]
    options: Options,

    /// What runs the program
    #[arg(long, value_enum, default_value_t = Engine::Model)]
    engine: Engine,

    /// How deep the tool may enter the part, and how much may be left uncut, in millimetres
    #[arg(long, value_name = "MM", default_value_t = 1e-6, value_parser = budget)]
    budget: f64,
}

/// What runs the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Engine {
    /// The exact reference model
    Model,
    /// The implementation in f64
    Impl,
}

/// A length in millimetres that is not negative.
fn budget(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|value: &f64| value.is_finite() && *value >= 0.0);
    value.ok_or_else(|| "a budget is a decimal, 0 or greater".to_owned())
}

impl Safety {
    /// Runs the program and judges the path.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let (control, source) = self.options.open()?;
        let placed = control.blocks(source).collect::<Result<Vec<Placed>, _>>()?;
        let blocks: Vec<_> = placed.iter().map(|each| each.read.block.clone()).collect();
        let answer = match self.engine {
            Engine::Model => exact(&control, &blocks)?,
            Engine::Impl => Builtin.answer(&control.profile.parameters, &blocks).map_err(fault)?,
        };
        let mut contour = Contour::of(&blocks);
        if let Some(raised) = answer.alarm {
            contour = contour.before(raised.block);
        }
        let verdict = check(&contour, &answer.steps, self.budget);
        self.print(&verdict, &placed, contour.len())?;
        if let Some(raised) = answer.alarm
            && let Some(block) = placed.get(raised.block)
        {
            alarm::report(&control, raised, &block.source);
            return Ok(Verdict::Red);
        }
        Ok(if verdict.is_safe() { Verdict::Green } else { Verdict::Red })
    }

    fn print(&self, verdict: &SafetyVerdict, placed: &[Placed], elements: usize) -> Result<(), Failure> {
        let mut out = terminal::output();
        match &verdict.path {
            Finding::Safe { .. } if elements == 0 => writeln!(out, "safe: the program compensates nothing")?,
            Finding::Safe { at_most } => {
                writeln!(out, "safe: the tool enters the part by no more than {} mm", self.budget)?;
                writeln!(out, "  proved depth: {at_most:.3e} mm at most, along {elements} elements of the contour")?;
            }
            finding => writeln!(out, "{}", sentence(finding, placed))?,
        }
        for (finding, moves) in [(&verdict.start_up, "start-up"), (&verdict.cancel, "cancel")] {
            if matches!(finding, Finding::Gouges(_) | Finding::Undecided(_)) {
                writeln!(out, "{moves} block, as programmed: {}", sentence(finding, placed))?;
            }
        }
        if let Some(uncut) = &verdict.uncut {
            let (block, axes) = (name(placed, uncut.contour_block), placed.get(uncut.contour_block).map(|at| at.axes));
            let words = |point| axes.map_or(String::new(), |axes| axes.words::<f64>(&point, 6));
            let (from, to) = (words(uncut.from), words(uncut.to));
            writeln!(
                out,
                "left uncut: {:.6} mm of {block}, from {from} to {to}, where the tool has room",
                uncut.length
            )?;
            writeln!(out, "  {:.6} mm thick in the middle", uncut.thickness)?;
        }
        if verdict.crossings > 0 {
            writeln!(out, "not judged: {} moves that cross the contour where the side changes", verdict.crossings)?;
        }
        Ok(out.flush()?)
    }
}

/// The exact model's answer, rounded.
fn exact(control: &Control, blocks: &[radcomp_spec::Block<rug::Rational>]) -> Result<Answer, Failure> {
    let outcome = run(&control.profile.parameters, blocks);
    if outcome.contradiction {
        return Err(Failure::Input("radcomp itself is at fault: its exact answers contradict each other".to_owned()));
    }
    Ok(Answer::from(&outcome))
}

fn fault(fault: DeviceFault) -> Failure {
    Failure::Input(format!("the implementation gave no answer: {fault}"))
}

/// What a finding that is not safe says, in words.
fn sentence(finding: &Finding, placed: &[Placed]) -> String {
    match finding {
        Finding::Safe { .. } => "safe".to_owned(),
        Finding::Gouges(gouge) => {
            let Gouge { depth: (low, high), .. } = gouge;
            format!("gouges by {low:.3} mm {}\n  depth proved: {low:.9} to {high:.9} mm", place(gouge, placed))
        }
        Finding::Undecided(gouge) => {
            let Gouge { depth: (low, high), .. } = gouge;
            format!("undecided: between {low:.3e} and {high:.3e} mm deep {}", place(gouge, placed))
        }
        Finding::OutOfRange { block } => {
            format!("undecided: {} holds a number that is not finite or out of range", name(placed, *block))
        }
    }
}

fn place(gouge: &Gouge, placed: &[Placed]) -> String {
    let (contour, path) = (name(placed, gouge.contour_block), name(placed, gouge.path_block));
    let axes = placed.get(gouge.contour_block).map(|at| at.axes);
    let words = |point| axes.map_or(String::new(), |axes| axes.words::<f64>(&point, 6));
    let (point, centre) = (words(gouge.contour), words(gouge.centre));
    format!("at {contour}, point {point}: the tool stands at {centre} in {path}")
}

/// A block as people find it.
fn name(placed: &[Placed], block: usize) -> String {
    let Some(at) = placed.get(block) else { return format!("block {block}") };
    match &at.source.sequence {
        Some(sequence) => format!("N{sequence}"),
        None => format!("line {}", at.source.line),
    }
}
