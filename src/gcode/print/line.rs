//! The words of one line.

use std::fmt::Write;

use radcomp_model::number::format_decimal;
use rug::Rational;

use super::PrintError;
use crate::gcode::word::MOST_DIGITS;

/// The line of one block.
pub(super) struct Words {
    text: String,
    /// The block's index.
    block: usize,
}

impl Words {
    /// An empty line for the block of this index.
    pub(super) fn of_block(block: usize) -> Self {
        Words { text: String::new(), block }
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The block's index, for errors.
    pub(super) fn block(&self) -> usize {
        self.block
    }

    pub(super) fn code(&mut self, code: &str) {
        let space = if self.text.is_empty() { "" } else { " " };
        // Writing to a string cannot fail.
        let _ = write!(self.text, "{space}{code}");
    }

    pub(super) fn word(&mut self, letter: char, number: &str) {
        self.code(&format!("{letter}{number}"));
    }

    pub(super) fn number(&mut self, letter: char, value: &Rational) -> Result<(), PrintError> {
        let number = self.decimal(value)?;
        self.word(letter, &number);
        Ok(())
    }

    /// The number, if the reader takes it.
    pub(super) fn decimal(&self, value: &Rational) -> Result<String, PrintError> {
        let readable = |text: &String| {
            let (whole, decimals) =
                text.trim_start_matches('-').split_once('.').unwrap_or((text.trim_start_matches('-'), ""));
            whole.len() <= MOST_DIGITS && decimals.len() <= MOST_DIGITS
        };
        let error = || PrintError::Number { block: self.block, value: value.clone() };
        format_decimal(value).filter(readable).ok_or_else(error)
    }
}
