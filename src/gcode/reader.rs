//! The reader: lines in, blocks out, one at a time.

use std::io::{self, BufRead, Read};

use radcomp_spec::parameters::Plane;
use radcomp_spec::profile::Profile;

use super::ReadBlock;
use super::arrange::Command;
use super::codes::Meaning;
use super::diagnostic::{Diagnostic, Kind, LineFault};
use super::state::State;
use super::tools::Tools;
use super::word::{self, Line, Word};

/// The most bytes that a line may have, its end not counted.
pub const MOST_LINE_BYTES: usize = 4096;

/// Reads a program block by block, in the memory of one line.
///
/// An iterator: it ends at M02 or M30, at the closing `%`, at the end of the file, and after the first fault.
#[derive(Debug)]
pub struct Reader<'p, R> {
    source: R,
    name: String,
    line: u32,
    buffer: Vec<u8>,
    state: State<'p>,
    skip_deleted: bool,
    /// A `%` or a block has been read: the next `%` ends the program.
    begun: bool,
    /// An O word has been read.
    numbered: bool,
    ended: bool,
}

impl<'p, R: BufRead> Reader<'p, R> {
    /// A reader at the start of a program; `name` is the file's name in messages.
    pub fn new(name: &str, source: R, profile: &'p Profile, tools: &'p Tools) -> Self {
        Reader {
            source,
            name: name.to_owned(),
            line: 0,
            buffer: Vec::new(),
            state: State::new(profile, tools),
            skip_deleted: false,
            begun: false,
            numbered: false,
            ended: false,
        }
    }

    /// Whether blocks that start with `/` are skipped (block delete on); they are executed if nothing is said.
    pub fn skip_deleted(self, skip: bool) -> Self {
        Reader { skip_deleted: skip, ..self }
    }

    /// The plane of the movements of the blocks read so far; before the first of them the plane in force.
    pub fn plane(&self) -> Plane {
        self.state.plane()
    }

    #[cfg(test)]
    pub(super) fn buffer_capacity(&self) -> usize {
        self.buffer.capacity()
    }

    /// Reads lines up to the next block.
    fn next_block(&mut self) -> Result<Option<ReadBlock>, Diagnostic> {
        while !self.ended && self.read_line()? {
            // The buffer is taken out while the state changes, and put back to be used again.
            let buffer = std::mem::take(&mut self.buffer);
            let block = self.execute(&buffer);
            self.buffer = buffer;
            if let Some(block) = block? {
                return Ok(Some(block));
            }
        }
        Ok(None)
    }

    /// Reads one line into the buffer; false at the end of the file.
    fn read_line(&mut self) -> Result<bool, Diagnostic> {
        self.line = self.line.saturating_add(1);
        self.buffer.clear();
        // Two bytes more than a line may have are its end, CR LF, or prove that it is too long.
        let most = MOST_LINE_BYTES as u64 + 2;
        match self.source.by_ref().take(most).read_until(b'\n', &mut self.buffer) {
            Ok(read) => {
                for end in [b'\n', b'\r'] {
                    self.buffer.pop_if(|last| *last == end);
                }
                Ok(read > 0)
            }
            Err(reason) => Err(self.unreadable(&reason)),
        }
    }

    /// Executes a line; none if it holds no block.
    fn execute(&mut self, line: &[u8]) -> Result<Option<ReadBlock>, Diagnostic> {
        if line.len() > MOST_LINE_BYTES {
            let message = format!("a line has at most {MOST_LINE_BYTES} bytes");
            let fault = LineFault::new(Kind::LineTooLong, MOST_LINE_BYTES..line.len(), message);
            return Err(fault.in_line(&self.name, self.line, &String::from_utf8_lossy(line)));
        }
        let text = match std::str::from_utf8(line) {
            Ok(text) => text,
            Err(error) => {
                let start = error.valid_up_to();
                let message = "this byte is not UTF-8 text";
                let fault = LineFault::new(Kind::NotText, start..start + 1, message);
                return Err(fault.in_line(&self.name, self.line, &String::from_utf8_lossy(line)));
            }
        };
        let text = if self.line == 1 { text.trim_start_matches('\u{feff}') } else { text };
        self.execute_text(text).map_err(|fault| fault.in_line(&self.name, self.line, text))
    }

    fn execute_text(&mut self, text: &str) -> Result<Option<ReadBlock>, LineFault> {
        if self.skip_deleted && word::is_deletable(text) {
            return Ok(None);
        }
        let words = match word::line(text)? {
            Line::Words(words) if words.is_empty() => return Ok(None),
            Line::Words(words) => words,
            Line::Percent => {
                (self.ended, self.begun) = (self.begun, true);
                return Ok(None);
            }
        };
        self.begun = true;
        if let Some(number) = words.iter().find(|word| word.letter == 'O') {
            self.program_number(number, words.len())?;
            return Ok(None);
        }
        self.block(Command::arrange(words)?).map(Some)
    }

    fn block(&mut self, command: Command<'_>) -> Result<ReadBlock, LineFault> {
        let sequence = command.word('N').map(|word| word.whole_or_fault("a sequence number").map(|_| word.number));
        let sequence = sequence.transpose()?.map(str::to_owned);
        let block = self.state.execute(&command)?;
        self.ended = command.codes().any(|given| given.code.meaning == Meaning::End);
        let (normal, nose) = (self.state.normal().clone(), self.state.nose().cloned());
        Ok(ReadBlock { block, line: self.line, sequence, normal, nose, orientation: self.state.orientation() })
    }

    /// A program number names the program; it is no block.
    fn program_number(&mut self, number: &Word<'_>, words: usize) -> Result<(), LineFault> {
        number.whole_or_fault("a program number")?;
        let fault = |message| Err(LineFault::new(Kind::MisplacedWord, number.span.clone(), message));
        if words > 1 {
            return fault("a program number stands alone in its line");
        }
        if self.numbered {
            return fault("a second program starts here: a file holds one");
        }
        self.numbered = true;
        Ok(())
    }

    fn unreadable(&self, reason: &io::Error) -> Diagnostic {
        let mut diagnostic = LineFault::new(Kind::Unreadable, 0..0, reason.to_string()).in_line(&self.name, 0, "");
        diagnostic.help = (self.line > 1).then(|| format!("lines before {} were read", self.line).into());
        diagnostic
    }
}

impl<R: BufRead> Iterator for Reader<'_, R> {
    type Item = Result<ReadBlock, Diagnostic>;

    fn next(&mut self) -> Option<Self::Item> {
        let next = self.next_block().transpose();
        if !matches!(next, Some(Ok(_))) {
            self.ended = true;
        }
        next
    }
}

impl<R: BufRead> std::iter::FusedIterator for Reader<'_, R> {}
