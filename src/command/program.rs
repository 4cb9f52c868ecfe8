//! A program on its control, block by block, each with the text of its line.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::io::{self, BufRead, Read};
use std::rc::Rc;

use radcomp::explain::{Axes, Source};
use radcomp::gcode::{Diagnostic, ReadBlock, Reader, Tools};
use radcomp_spec::profile::Profile;

/// A control, its tools, and how it reads the program.
#[derive(Debug)]
pub struct Control {
    /// The program's name, for messages.
    pub name: String,
    /// The profile.
    pub profile: Profile,
    /// The tool table.
    pub tools: Tools,
    /// Whether blocks that start with `/` are skipped.
    pub skip_deleted: bool,
}

/// A block with all that is known of its place.
#[derive(Clone, Debug)]
pub struct Placed {
    /// The block.
    pub read: ReadBlock,
    /// Its line.
    pub source: Source,
    /// The axes of its plane.
    pub axes: Axes,
}

/// The blocks of a program; an iterator in bounded memory.
pub struct Blocks<'c> {
    reader: Reader<'c, Listening>,
    lines: Rc<RefCell<Lines>>,
    control: &'c Control,
}

impl Control {
    /// The blocks of a program's text.
    pub fn blocks(&self, source: Box<dyn BufRead>) -> Blocks<'_> {
        let lines = Rc::new(RefCell::new(Lines::default()));
        let listening = Listening { source, lines: lines.clone() };
        let reader = Reader::new(&self.name, listening, &self.profile, &self.tools).skip_deleted(self.skip_deleted);
        Blocks { reader, lines, control: self }
    }
}

impl Iterator for Blocks<'_> {
    type Item = Result<Placed, Diagnostic>;

    fn next(&mut self) -> Option<Self::Item> {
        let read = match self.reader.next()? {
            Ok(read) => read,
            Err(diagnostic) => return Some(Err(diagnostic)),
        };
        let text = self.lines.borrow().text(read.line);
        let source = Source { line: read.line, sequence: read.sequence.clone(), text };
        let axes = Axes { plane: self.reader.plane(), x_words: self.control.profile.machine.x_words };
        Some(Ok(Placed { read, source, axes }))
    }
}

/// The last lines that went by.
#[derive(Debug, Default)]
struct Lines {
    /// Lines that are complete, with the number of the first of them less 1 in `before`.
    complete: VecDeque<Vec<u8>>,
    before: u32,
    current: Vec<u8>,
}

/// Lines that are kept: the reader takes one at a time.
const KEPT_LINES: usize = 2;
/// Bytes that are kept of a line.
const KEPT_BYTES: usize = 4096;

impl Lines {
    fn pass(&mut self, bytes: &[u8]) {
        for piece in bytes.split_inclusive(|byte| *byte == b'\n') {
            let ends = piece.ends_with(b"\n");
            let room = KEPT_BYTES.saturating_sub(self.current.len());
            self.current.extend_from_slice(&piece[..piece.len().min(room)]);
            if ends {
                // The oldest line's memory is used again.
                let mut next = if self.complete.len() == KEPT_LINES {
                    self.before = self.before.saturating_add(1);
                    self.complete.pop_front().unwrap_or_default()
                } else {
                    Vec::new()
                };
                next.clear();
                self.complete.push_back(std::mem::replace(&mut self.current, next));
            }
        }
    }

    fn text(&self, line: u32) -> String {
        let index = line.saturating_sub(self.before).saturating_sub(1) as usize;
        let bytes = self.complete.get(index).unwrap_or(&self.current);
        let text = String::from_utf8_lossy(bytes);
        // A terminal obeys control characters.
        let shown = |character: char| if character.is_control() { ' ' } else { character };
        text.trim_start_matches('\u{feff}').trim_end().chars().map(shown).collect()
    }
}

/// A source that remembers the last lines that were read from it.
struct Listening {
    source: Box<dyn BufRead>,
    lines: Rc<RefCell<Lines>>,
}

impl BufRead for Listening {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.source.fill_buf()
    }

    fn consume(&mut self, amount: usize) {
        // After `fill_buf` the same bytes are there without reading.
        if amount > 0
            && let Ok(buffer) = self.source.fill_buf()
        {
            self.lines.borrow_mut().pass(&buffer[..amount.min(buffer.len())]);
        }
        self.source.consume(amount);
    }
}

impl Read for Listening {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let buffer = self.fill_buf()?;
        let amount = buffer.len().min(into.len());
        into[..amount].copy_from_slice(&buffer[..amount]);
        self.consume(amount);
        Ok(amount)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_block_comes_with_the_text_of_its_line() {
        let profile = Profile::builtin("seed-mill").unwrap();
        let control = Control { name: "a.nc".to_owned(), profile, tools: Tools::empty(), skip_deleted: true };
        let text = "\u{feff}%\n(start)\nN1 G01 X1 F1 (one)\r\n\n/ X5\n\n\n\n\tX2\nX3";
        let blocks: Vec<Placed> = control.blocks(Box::new(text.as_bytes())).map(Result::unwrap).collect();
        let lines: Vec<(u32, &str)> = blocks.iter().map(|block| (block.source.line, &*block.source.text)).collect();
        assert_eq!(lines, [(3, "N1 G01 X1 F1 (one)"), (9, " X2"), (10, "X3")]);
        assert_eq!(blocks[0].source.sequence.as_deref(), Some("1"));
    }
}
