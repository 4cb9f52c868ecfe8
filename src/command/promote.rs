//! `radcomp promote`.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use radcomp::certify::group;
use radcomp::device::Builtin;
use radcomp::edited::Edited;
use radcomp::gcode::print_blocks;
use radcomp::judge::{Budget, Grade, Verdict as Judgement, judge};
use radcomp::minimise::minimise;
use radcomp_model::number::format_decimal;
use radcomp_spec::Block;
use radcomp_spec::profile::Profile;
use rug::Rational;

use super::failure::{Failure, Verdict};
use super::terminal;

/// Make a test of the repository out of an input that a fuzz target crashed on
#[derive(Debug, Args)]
#[command(after_help = "\
The input is one of a target over programs (model_and_implementation, metamorphic,
round_trip, safety, planted). If the built-in device fails on it, it is made smaller
first, as long as it fails in the same way.

Examples:
  radcomp promote fuzz/artifacts/model_and_implementation/crash-1f2e > tests/promoted/NAME.toml")]
pub struct Promote {
    /// The fuzzer's file
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The test's name; the file's by default
    #[arg(long)]
    name: Option<String>,
    /// What went wrong, and why
    #[arg(long, default_value = "To be told.")]
    story: String,
}

/// As in fuzzing, in millimetres.
const BUDGET: Budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };

impl Promote {
    /// Prints the test; red when the built-in device fails on it.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let name = self.file.display();
        let bytes = std::fs::read(&self.file).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        let Some(Edited { profile, blocks }) = Edited::from_bytes(&bytes) else {
            return Err(Failure::Input(format!("{name}: too short for a fuzzer's program")));
        };
        let blocks = smaller(&profile, blocks);
        let judgement = verdict(&profile, &blocks);
        let text = self.test(&profile, &blocks, &judgement)?;
        let mut out = terminal::output();
        out.write_all(text.as_bytes())?;
        out.flush()?;
        Ok(if judgement.is_red() { Verdict::Red } else { Verdict::Green })
    }

    fn test(&self, profile: &Profile, blocks: &[Block<Rational>], verdict: &Judgement) -> Result<String, Failure> {
        let listing = print_blocks(blocks, profile)
            .map_err(|error| Failure::Input(format!("the program has no G-code under {}: {error}", profile.name)))?;
        let stem = self.file.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let name = self.name.clone().or(stem).unwrap_or_default();
        let mut text = format!("# The built-in device was {} when this was promoted.\n", verdict.id());
        text += &format!("name = {name:?}\nstory = {:?}\nprofile = {:?}\n", self.story, profile.name);
        let radius = |number| listing.tools.tool(number).and_then(|tool| format_decimal(&tool.radius()));
        let others: Vec<_> = (2..=blocks.len() as u32 + 1)
            .filter_map(|number| Some(format!("{number} = \"{}\"", radius(number)?)))
            .collect();
        text += &radius(1).map_or(String::new(), |radius| format!("radius = \"{radius}\"\n"));
        if !others.is_empty() {
            text += &format!("tools = {{ {} }}\n", others.join(", "));
        }
        Ok(text + &format!("program = \"\"\"\n{}\"\"\"\n", listing.program))
    }
}

fn verdict(profile: &Profile, blocks: &[Block<Rational>]) -> Judgement {
    judge(&mut Builtin, &profile.parameters, blocks, &BUDGET).verdict
}

/// The smallest program found that fails in the same way, if the program fails.
fn smaller(profile: &Profile, blocks: Vec<Block<Rational>>) -> Vec<Block<Rational>> {
    let failed = |blocks: &[Block<Rational>]| {
        let verdict = verdict(profile, blocks);
        (verdict.is_red() && print_blocks(blocks, profile).is_ok()).then(|| group(&verdict))
    };
    match failed(&blocks) {
        None => blocks,
        Some(group) => minimise(&blocks, |blocks| failed(blocks).as_ref() == Some(&group)),
    }
}
