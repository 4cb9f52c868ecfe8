//! The words of one line, checked against each other: no letter twice, no two codes of one group.

use std::ops::Range;

use radcomp_spec::AlarmKind;

use super::codes::{self, Code, Group, Meaning};
use super::diagnostic::{Kind, LineFault};
use super::word::{NAMED, Word};

/// The words of a block.
#[derive(Debug)]
pub(super) struct Command<'a> {
    /// All words but the G and M codes; no letter twice.
    words: Vec<Word<'a>>,
    /// The G and M codes; no group twice.
    codes: Vec<Given>,
}

/// A code where a block gives it.
#[derive(Clone, Debug)]
pub(super) struct Given {
    /// The code.
    pub(super) code: &'static Code,
    /// The bytes of the line that it takes.
    pub(super) span: Range<usize>,
}

/// Letters that are refused, and why.
const REFUSED_LETTERS: &[(char, Kind, &str)] = &[
    ('A', Kind::UnsupportedWord, "rotary axes are not supported"),
    ('B', Kind::UnsupportedWord, "rotary axes are not supported"),
    ('C', Kind::UnsupportedWord, "rotary axes are not supported"),
    ('E', Kind::UnknownLetter, "E is no address"),
    ('H', Kind::UnsupportedWord, "tool length offsets are not supported"),
    ('V', Kind::UnsupportedWord, "incremental axis words are not supported: G91 with Y says the same"),
    ('W', Kind::UnsupportedWord, "incremental axis words are not supported: G91 with Z says the same"),
];

/// Letters that canned cycles alone have.
const CYCLE_LETTERS: [char; 2] = ['L', 'Q'];

/// Codes that are refused, and what they are: from, to.
const REFUSED_CODES: &[(char, u32, u32, &str)] = &[
    ('G', 5, 6, "other curves than arcs"),
    ('G', 10, 11, "offsets set by the program"),
    ('G', 27, 27, "reference points"),
    ('G', 31, 31, "measuring moves"),
    ('G', 32, 34, "threads"),
    ('G', 45, 48, "offsets along an axis"),
    ('G', 51, 51, "scaling"),
    ('G', 52, 52, "other coordinate systems"),
    ('G', 55, 59, "other work offsets than the first"),
    ('G', 60, 64, "how the tool comes to a stop, or does not, at the end of a move"),
    ('G', 65, 67, "macros"),
    ('G', 68, 69, "rotation"),
    ('M', 98, 99, "subprograms"),
];

impl<'a> Command<'a> {
    /// Checks the words of a line.
    pub(super) fn arrange(given: Vec<Word<'a>>) -> Result<Self, LineFault> {
        let mut command = Command { words: Vec::with_capacity(given.len()), codes: Vec::new() };
        for (index, word) in given.into_iter().enumerate() {
            match word.letter {
                'G' | 'M' | NAMED => command.add_code(&word)?,
                'N' if index > 0 => {
                    let message = "the sequence number stands first in its block";
                    return Err(LineFault::new(Kind::MisplacedWord, word.span, message));
                }
                _ => command.add_word(word)?,
            }
        }
        command.check_cycle_letters()?;
        Ok(command)
    }

    /// Words that only a cycle has stand beside its code.
    fn check_cycle_letters(&self) -> Result<(), LineFault> {
        let of_cycle = Meaning::NotInMode(AlarmKind::CannedCycleInMode);
        let cycle = self.codes().any(|given| given.code.meaning == of_cycle);
        match self.words.iter().find(|word| CYCLE_LETTERS.contains(&word.letter)) {
            Some(word) if !cycle => {
                let message = format!("{} is no address", word.letter);
                Err(LineFault::new(Kind::UnknownLetter, word.span.clone(), message))
            }
            _ => Ok(()),
        }
    }

    fn add_word(&mut self, word: Word<'a>) -> Result<(), LineFault> {
        let letter = word.letter;
        if let Some((_, kind, message)) = REFUSED_LETTERS.iter().find(|(refused, ..)| *refused == letter) {
            return Err(LineFault::new(*kind, word.span, *message));
        }
        if self.word(letter).is_some() {
            let message = format!("this block has a word {letter} already");
            return Err(LineFault::new(Kind::RepeatedWord, word.span, message));
        }
        self.words.push(word);
        Ok(())
    }

    fn add_code(&mut self, word: &Word<'_>) -> Result<(), LineFault> {
        let found = match word.letter {
            NAMED => codes::named(word.number),
            letter => word.whole().and_then(|number| codes::find(letter, number)),
        };
        let Some(code) = found else { return Err(unsupported(word)) };
        if let Some(other) = self.code(code.group) {
            let message = match other.code.meaning == code.meaning && other.code.number == code.number {
                true => format!("{code} stands in this block already"),
                false => format!("{} and {code} exclude each other in one block", other.code),
            };
            return Err(LineFault::new(Kind::ConflictingCodes, word.span.clone(), message));
        }
        self.codes.push(Given { code, span: word.span.clone() });
        Ok(())
    }

    /// The word of a letter other than G and M.
    pub(super) fn word(&self, letter: char) -> Option<&Word<'a>> {
        self.words.iter().find(|word| word.letter == letter)
    }

    /// The words of three letters.
    pub(super) fn words_of(&self, letters: [char; 3]) -> [Option<&Word<'a>>; 3] {
        letters.map(|letter| self.word(letter))
    }

    /// All words but the G and M codes.
    pub(super) fn words(&self) -> impl Iterator<Item = &Word<'a>> {
        self.words.iter()
    }

    /// The code of a group.
    pub(super) fn code(&self, group: Group) -> Option<&Given> {
        self.codes.iter().find(|given| given.code.group == group)
    }

    /// All G and M codes.
    pub(super) fn codes(&self) -> impl Iterator<Item = &Given> {
        self.codes.iter()
    }
}

fn unsupported(word: &Word<'_>) -> LineFault {
    let name = match word.whole() {
        Some(number) => format!("{}{number:02}", word.letter),
        None => format!("{}{}", word.letter, word.number),
    };
    let about = |(letter, from, to, _): &&(char, u32, u32, &str)| {
        *letter == word.letter && word.whole().is_some_and(|number| (*from..=*to).contains(&number))
    };
    match REFUSED_CODES.iter().find(about) {
        Some((.., what)) => not_supported(&name, what, word.span.clone()),
        None => refused(format!("{name} is not a code that radcomp knows"), word.span.clone()),
    }
}

/// The refusal of a code whose meaning is known.
pub(super) fn not_supported(name: &str, what: &str, span: Range<usize>) -> LineFault {
    refused(format!("{name} ({what}) is not supported"), span)
}

fn refused(message: String, span: Range<usize>) -> LineFault {
    LineFault::new(Kind::UnsupportedCode, span, message)
        .helping("no code is passed over, as it could move the tool; take it out if it does not")
}
