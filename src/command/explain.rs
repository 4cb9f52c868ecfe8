//! `radcomp explain`.

use clap::Args;
use radcomp::explain::{Choice, Teller};
use radcomp_model::Engine;

use super::failure::{Failure, Verdict};
use super::ledger::Ledger;
use super::options::Options;
use super::{alarm, terminal};

/// Tell block by block what the program does, which clause applies and by what margin
#[derive(Debug, Args)]
#[command(after_help = "\
A margin is how far, exactly and in millimetres, a decision is from going the
other way.

Examples:
  radcomp explain examples/first.nc --profile seed-mill --tools examples/tools.toml
  radcomp explain examples/turning.nc -p yasnac-lx -t examples/tools.toml --block 60
  radcomp explain part.nc --profile seed-mill --radius 5 --line 12")]
pub struct Explain {
    #[command(flatten)]
    options: Options,

    /// Tell the blocks with this N number only
    #[arg(long, value_name = "N", conflicts_with = "line", value_parser = sequence)]
    block: Option<String>,

    /// Tell the block in this line of the file only
    #[arg(long, value_name = "L")]
    line: Option<u32>,

    /// Digits after the decimal point
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u16).range(0..=1000))]
    digits: u16,
}

impl Explain {
    /// Runs the program and tells it.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let choice = match (&self.block, self.line) {
            (Some(number), _) => Choice::Sequence(number.clone()),
            (None, Some(line)) => Choice::Line(line),
            (None, None) => Choice::All,
        };
        let (control, source) = self.options.open()?;
        let mut teller =
            Teller::new(terminal::output(), choice.clone(), usize::from(self.digits), terminal::is_colourful());
        let mut engine = Engine::new(&control.profile.parameters);
        let mut ledger = Ledger::default();
        let (mut stopped, mut enough) = (Ok(()), false);
        for block in control.blocks(source) {
            let block = match block {
                Ok(block) => block,
                Err(diagnostic) => {
                    teller.finish(None)?;
                    return Err(diagnostic.into());
                }
            };
            teller.read(&block.read.block, block.source.clone(), block.axes);
            stopped = engine.push(&block.read.block, &mut teller);
            ledger.add(block);
            // The engine holds no more blocks than these.
            ledger.forget_before(ledger.count().saturating_sub(HELD));
            teller.written()?;
            enough = matches!(choice, Choice::Line(_)) && teller.told() > 0;
            if stopped.is_err() || enough {
                break;
            }
        }
        if stopped.is_ok() && !enough {
            stopped = engine.finish(&mut teller);
        }
        let raised = alarm::of(stopped)?;
        teller.finish(raised)?;
        if teller.told() == 0 && choice != Choice::All {
            return Err(Failure::Input(match choice {
                Choice::Sequence(number) => format!("no block N{number} was reached"),
                _ => "no block in that line was reached".to_owned(),
            }));
        }
        match raised {
            None => Ok(Verdict::Green),
            Some(raised) => {
                if let Some(block) = ledger.block(raised.block) {
                    alarm::report(&control, raised, &block.source);
                }
                Ok(Verdict::Red)
            }
        }
    }
}

/// The blocks that can still raise an alarm: one that moves, the blocks without movement after it, and the next.
const HELD: usize = radcomp_spec::parameters::MOST_NON_MOVING as usize + 3;

/// The number of an N word, with or without the letter.
fn sequence(text: &str) -> Result<String, String> {
    let digits = text.trim_start_matches(['N', 'n']);
    match !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) {
        true => Ok(digits.to_owned()),
        false => Err("a block is named by the number of its N word".to_owned()),
    }
}
