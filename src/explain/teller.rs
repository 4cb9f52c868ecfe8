//! Listens to the model and writes each block as soon as it is settled.

use std::cmp::Ordering;
use std::collections::VecDeque;
use std::io::{self, Write};

use radcomp_model::number::Real;
use radcomp_model::{Decision, Sink};
use radcomp_spec::{Advisory, Alarm, Block, Compensation, DecisionKind, Side, Step};
use rug::Rational;

use super::programmed::{Programmed, Shape, turn};
use super::section::{Section, Source};
use super::{Axes, Corner};

/// Which blocks are told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Choice {
    /// All.
    All,
    /// Those with this number in their N word; zeros in front do not count.
    Sequence(String),
    /// The one in this line.
    Line(u32),
    /// Those in these lines.
    Lines(Vec<u32>),
}

/// How a block is written.
#[derive(Clone, Copy, Debug)]
enum Form {
    Text { bold: bool },
    Json,
}

/// Writes what happens in each block. It holds the blocks that are not settled yet, no more.
///
/// Feed it a block with [`Teller::read`] before the engine is given the block, and hand it to the engine as the sink;
/// what writing says is kept until [`Teller::written`].
#[derive(Debug)]
pub struct Teller<W> {
    out: W,
    choice: Choice,
    digits: usize,
    form: Form,
    next: usize,
    program: Programmed,
    side: Option<Side>,
    open: VecDeque<Section>,
    told: usize,
    result: io::Result<()>,
}

impl<W: Write> Teller<W> {
    /// A teller at the start of a program; decimals have so many digits, headings are bold if asked.
    pub fn new(out: W, choice: Choice, digits: usize, bold: bool) -> Self {
        Teller {
            out,
            choice,
            digits,
            form: Form::Text { bold },
            next: 0,
            program: Programmed::new(),
            side: None,
            open: VecDeque::new(),
            told: 0,
            result: Ok(()),
        }
    }

    /// The same teller, but it writes each block as a JSON object on a line of its own: `block`, its index from 0; `line`;
    /// `n`; `text`; `rows`, each with `name`, `words` and, where there are any, `margin` (`decimal`, `exact`), `clause` and
    /// `exact`; `clauses`, those whose sentences the text would give.
    #[must_use]
    pub fn as_json(self) -> Self {
        Teller { form: Form::Json, ..self }
    }

    /// The next block, which the engine will read after this.
    pub fn read(&mut self, block: &Block<Rational>, source: Source, axes: Axes) {
        let programmed = self.program.next(block);
        match block.compensation {
            Some(Compensation::Off) => self.side = None,
            Some(Compensation::On(side)) => self.side = Some(side),
            None => {}
        }
        self.open.push_back(Section {
            index: self.next,
            source,
            axes,
            programmed,
            compensation: block.compensation,
            radius: block.radius.clone(),
            outer_corner: block.corner,
            side: self.side,
            checks: Vec::new(),
            corner: Vec::new(),
            steps: Vec::new(),
            advisories: Vec::new(),
            alarm: None,
        });
        self.next += 1;
    }

    /// What has been written so far.
    pub fn into_inner(self) -> W {
        self.out
    }

    /// How writing went so far.
    ///
    /// # Errors
    ///
    /// The first error of the output.
    pub fn written(&mut self) -> io::Result<()> {
        std::mem::replace(&mut self.result, Ok(()))
    }

    /// How many blocks have been written; with [`Choice::Line`] nothing follows the first.
    pub fn told(&self) -> usize {
        self.told
    }

    /// The program ends, or stops at an alarm: writes the blocks that are left.
    ///
    /// # Errors
    ///
    /// The first error of the output.
    pub fn finish(&mut self, alarm: Option<Alarm>) -> io::Result<()> {
        if let Some(alarm) = alarm
            && let Some(section) = self.section(alarm.block)
        {
            section.alarm = Some(alarm.kind);
        }
        self.close(usize::MAX);
        self.written()?;
        self.out.flush()
    }

    fn section(&mut self, index: usize) -> Option<&mut Section> {
        self.open.iter_mut().find(|section| section.index == index)
    }

    /// Writes the blocks before this one: path elements come in the order of blocks, so nothing more is said of them.
    fn close(&mut self, before: usize) {
        while self.open.front().is_some_and(|section| section.index < before) {
            let Some(section) = self.open.pop_front() else { return };
            if self.result.is_ok() && self.chosen(&section.source) {
                self.told += 1;
                let explanation = section.explanation(self.digits);
                self.result = match self.form {
                    Form::Text { bold } => self.out.write_all(explanation.text(bold).as_bytes()),
                    Form::Json => writeln!(self.out, "{}", explanation.json()),
                };
            }
        }
    }

    fn chosen(&self, source: &Source) -> bool {
        match &self.choice {
            Choice::All => true,
            Choice::Line(line) => source.line == *line,
            Choice::Lines(lines) => lines.contains(&source.line),
            Choice::Sequence(wanted) => {
                let bare = |digits: &str| digits.trim_start_matches('0').to_owned();
                source.sequence.as_deref().is_some_and(|sequence| bare(sequence) == bare(wanted))
            }
        }
    }

    /// The decision belongs to the corner at the end of the last block that moves before the one being read.
    fn at_corner(&mut self, decision: &Decision) {
        let Some(after) = self.open.iter().position(|section| section.index == decision.block) else { return };
        let moves = |section: &Section| {
            section
                .programmed
                .as_ref()
                .is_some_and(|programmed| !matches!(programmed.shape, Shape::Dummy(_) | Shape::Direction(_)))
        };
        let Some(before) = (0..after).rev().find(|index| moves(&self.open[*index])) else { return };
        let (line, side) = (self.open[after].source.line, self.open[after].side);
        let next_heading = self.open[after].programmed.as_ref().map(|next| next.first_heading());
        let section = &mut self.open[before];
        let last_heading = section.programmed.as_ref().map(|programmed| programmed.last_heading());
        let corner = Corner {
            turn: last_heading.zip(next_heading).map(|(last, next)| turn(last, next)),
            side_change: section.side != side,
            parallel: section
                .corner
                .iter()
                .any(|(_, _, earlier)| earlier.kind == DecisionKind::Turn && earlier.exact == Ordering::Equal),
        };
        section.corner.push((line, corner, decision.clone()));
    }
}

impl<W: Write> Sink for Teller<W> {
    fn step(&mut self, step: Step<Real>) {
        self.close(step.block);
        if let Some(section) = self.section(step.block) {
            section.steps.push(step);
        }
    }

    fn advisory(&mut self, advisory: Advisory<Real>) {
        if let Some(section) = self.section(advisory.block) {
            section.advisories.push(advisory);
        }
    }

    fn decide(&mut self, decision: Decision) -> Ordering {
        match decision.kind {
            DecisionKind::Moves
            | DecisionKind::CentreDistance
            | DecisionKind::ChordFits
            | DecisionKind::HalfTurn
            | DecisionKind::EndOnArc
            | DecisionKind::ToolFitsArc
            | DecisionKind::EntryLength
            | DecisionKind::EntryArc
            | DecisionKind::LineForward
            | DecisionKind::ArcForward => {
                if let Some(section) = self.section(decision.block) {
                    section.checks.push(decision.clone());
                }
            }
            _ => self.at_corner(&decision),
        }
        decision.exact
    }
}
