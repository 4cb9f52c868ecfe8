//! A program as it is read: its blocks, their places, and the line that stopped the reader.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use radcomp_model::{Engine, Sink, Stop};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Alarm, Block};
use rug::Rational;
use serde_json::{Value, json};

use super::{Asked, MOST_BLOCKS, Trouble};
use crate::explain::{Axes, Source};
use crate::gcode::{Diagnostic, Reader};

/// How long a computation may go on.
#[derive(Clone, Debug)]
pub struct Patience {
    until: Instant,
    time: Duration,
    abandoned: Arc<AtomicBool>,
}

impl Patience {
    /// So long from now on, and as long as nobody sets `abandoned`.
    pub fn new(time: Duration, abandoned: Arc<AtomicBool>) -> Self {
        Patience { until: Instant::now() + time, time, abandoned }
    }

    /// Whether time is left, in the line that is worked on.
    pub(super) fn check(&self, line: u32) -> Result<(), Trouble> {
        if self.abandoned.load(Ordering::Relaxed) {
            return Err(Trouble::too_long("nobody waits for the answer"));
        }
        if Instant::now() > self.until {
            let seconds = self.time.as_secs();
            return Err(Trouble::too_long(format!(
                "stopped in line {line}: the workbench computes for {seconds} s at most; `radcomp run` has no limit"
            )));
        }
        Ok(())
    }
}

/// A program as it is run.
#[derive(Debug)]
pub(super) struct Study {
    /// Its blocks.
    pub(super) blocks: Vec<Block<Rational>>,
    /// Their places.
    pub(super) sources: Vec<Source>,
    /// The axes of the last block's plane.
    pub(super) axes: Axes,
    /// The line that stopped the reader.
    pub(super) refused: Option<Diagnostic>,
}

impl Study {
    /// Reads the program up to its end or its first fault.
    ///
    /// # Errors
    ///
    /// A tool table that is none, and what is beyond a limit.
    pub(super) fn read(asked: &Asked, profile: &Profile, patience: &Patience) -> Result<Study, Trouble> {
        let tools = asked.table()?;
        let lines: Vec<&str> = asked.program.lines().collect();
        let mut reader =
            Reader::new("program", asked.program.as_bytes(), profile, &tools).skip_deleted(asked.block_delete);
        let machine = &profile.machine;
        let axes = Axes { plane: machine.plane, x_words: machine.x_words };
        let mut study = Study { blocks: Vec::new(), sources: Vec::new(), axes, refused: None };
        while let Some(next) = reader.next() {
            let block = match next {
                Ok(block) => block,
                Err(diagnostic) => {
                    study.refused = Some(diagnostic);
                    break;
                }
            };
            if study.blocks.len() == MOST_BLOCKS {
                return Err(Trouble::too_large(format!(
                    "a program in the workbench has at most {MOST_BLOCKS} blocks; `radcomp run` has no limit"
                )));
            }
            patience.check(block.line)?;
            study.axes.plane = reader.plane();
            let text =
                lines.get(block.line.saturating_sub(1) as usize).map_or(String::new(), |line| (*line).to_owned());
            study.sources.push(Source { line: block.line, sequence: block.sequence, text });
            study.blocks.push(block.block);
        }
        Ok(study)
    }

    /// Runs the blocks exactly; the alarm that stops the tool, if there is one.
    ///
    /// # Errors
    ///
    /// No time left, and a fault of the model.
    pub(super) fn run(
        &self,
        profile: &Profile,
        patience: &Patience,
        sink: &mut impl Sink,
    ) -> Result<Option<Alarm>, Trouble> {
        let mut engine = Engine::new(&profile.parameters);
        let mut stopped = Ok(());
        for (block, source) in self.blocks.iter().zip(&self.sources) {
            patience.check(source.line)?;
            stopped = stopped.and_then(|()| engine.push(block, sink));
        }
        // A line that cannot be read leaves the corner before it open.
        if self.refused.is_none() {
            stopped = stopped.and_then(|()| engine.finish(sink));
        }
        alarm_of(stopped)
    }

    /// Where a block stands.
    pub(super) fn place(&self, block: usize) -> Value {
        let source = self.sources.get(block);
        json!({ "block": block, "line": source.map(|at| at.line), "n": source.and_then(|at| at.sequence.clone()) })
    }

    /// The last line that was read.
    pub(super) fn last_line(&self) -> u32 {
        self.sources.last().map_or(0, |source| source.line)
    }
}

/// The alarm that the model stopped at, if it did.
pub(super) fn alarm_of(stopped: Result<(), Stop>) -> Result<Option<Alarm>, Trouble> {
    match stopped {
        Ok(()) => Ok(None),
        Err(Stop::Alarm(alarm)) => Ok(Some(alarm)),
        Err(Stop::Contradiction) => Err(Trouble::own("its exact answers contradict each other")),
    }
}
