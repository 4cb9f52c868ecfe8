//! `radcomp plot`.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use radcomp::explain::{Axes, Coordinate};
use radcomp::plot::{Scene, svg};
use radcomp_model::Engine;

use super::failure::{Failure, Verdict};
use super::options::Options;
use super::program::Control;
use super::{alarm, terminal};

/// Draw the programmed contour and the path of the tool's centre as an SVG picture
#[derive(Debug, Args)]
#[command(after_help = "\
A program with an alarm is drawn too: the tool's path up to where it stops, and the
whole contour.

Examples:
  radcomp plot examples/first.nc --profile seed-mill --tools examples/tools.toml -o first.svg
  radcomp plot examples/turning.nc -p yasnac-lx -t examples/tools.toml -o turning.svg")]
pub struct Plot {
    #[command(flatten)]
    options: Options,

    /// The picture; - writes to the standard output
    #[arg(long, short, value_name = "FILE.svg")]
    output: PathBuf,
}

/// A program of more blocks is too large for a picture.
const MOST_BLOCKS: usize = 100_000;

impl Plot {
    /// Runs the program and draws it.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let (control, source) = self.options.open()?;
        let machine = &control.profile.machine;
        let mut scene = Scene::new(Axes { plane: machine.plane, x_words: machine.x_words });
        let mut engine = Engine::new(&control.profile.parameters);
        let (mut raised, mut count) = (None, 0);
        // The source of the blocks that can still raise an alarm are few; all are kept beside what is drawn of them.
        let mut sources = Vec::new();
        for block in control.blocks(source) {
            let block = block?;
            count += 1;
            if count > MOST_BLOCKS {
                return Err(Failure::Input(format!("a picture holds at most {MOST_BLOCKS} blocks")));
            }
            scene.read(&block.read.block, &block.source, block.axes);
            sources.push(block.source);
            if raised.is_none() {
                raised = alarm::of(engine.push(&block.read.block, &mut scene))?;
            }
        }
        if raised.is_none() {
            raised = alarm::of(engine.finish(&mut scene))?;
        }
        if let Some(alarm) = raised {
            scene.alarm(alarm);
        }
        self.write(&svg(&scene, &control.name, &subtitle(&control, &scene)))?;
        if let Some(raised) = raised
            && let Some(source) = sources.get(raised.block)
        {
            alarm::report(&control, raised, source);
            return Ok(Verdict::Red);
        }
        Ok(Verdict::Green)
    }

    fn write(&self, picture: &str) -> Result<(), Failure> {
        if self.output.as_os_str() == "-" {
            let mut out = terminal::output();
            out.write_all(picture.as_bytes())?;
            return Ok(out.flush()?);
        }
        fs::write(&self.output, picture)
            .map_err(|reason| Failure::Input(format!("{} cannot be written: {reason}", self.output.display())))
    }
}

fn subtitle(control: &Control, scene: &Scene) -> String {
    let [first, second] = scene.axes.letters();
    let radius = scene.radius.short(9);
    let plane = scene.axes.code();
    format!("profile {}, plane {plane} ({first}, {second}), tool radius {radius} mm", control.profile.name)
}
