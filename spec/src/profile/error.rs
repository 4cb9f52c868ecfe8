//! What can be wrong with a profile file.

use core::fmt;
use core::ops::Range;

use crate::clause::Clause;

/// A fault of a profile file, with its place. The fault is always the file's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProfileError {
    /// The file's name.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// How many characters of the line are meant; at least 1.
    pub length: u32,
    /// The text of the line.
    pub source_line: String,
    /// What is wrong.
    pub kind: Box<ProfileErrorKind>,
}

/// What is wrong with a profile file.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProfileErrorKind {
    /// The file cannot be read.
    Unreadable(String),
    /// It is not TOML.
    Malformed(String),
    /// A key that must be there is not.
    Missing {
        /// The key.
        key: String,
        /// Its allowed values.
        allowed: String,
    },
    /// A key that means nothing there.
    Unknown {
        /// The key.
        key: String,
        /// The keys that mean something there.
        allowed: String,
    },
    /// A value that the key cannot have.
    WrongValue {
        /// The key.
        key: String,
        /// The value as written.
        found: String,
        /// Its allowed values.
        allowed: String,
    },
    /// A clause that is not the one the parameter belongs to.
    WrongClause {
        /// The parameter.
        key: String,
        /// The clause as written.
        found: String,
        /// The parameter's clause.
        expected: Clause,
    },
    /// A source tag of no known form.
    WrongSource {
        /// The parameter.
        key: String,
        /// The source as written.
        found: String,
    },
    /// The name of a built-in profile that says something else.
    NameTaken(String),
}

impl ProfileError {
    pub(super) fn unreadable(file: &str, reason: &std::io::Error) -> Self {
        let kind = ProfileErrorKind::Unreadable(reason.to_string());
        ProfileError {
            file: file.to_owned(),
            line: 1,
            column: 1,
            length: 1,
            source_line: String::new(),
            kind: Box::new(kind),
        }
    }

    /// An error at a byte range of the file's text.
    pub(super) fn at(file: &str, text: &str, span: Range<usize>, kind: ProfileErrorKind) -> Self {
        let start = boundary(text, span.start);
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let source_line = text[line_start..].lines().next().unwrap_or_default();
        let line_end = line_start + source_line.len();
        let end = boundary(text, span.end).clamp(start, line_end.max(start));
        ProfileError {
            file: file.to_owned(),
            line: count(before.matches('\n').count()) + 1,
            column: count(text[line_start..start].chars().count()) + 1,
            length: count(text[start..end].chars().count()).max(1),
            source_line: source_line.to_owned(),
            kind: Box::new(kind),
        }
    }
}

/// The start of the character that this byte belongs to, or the end of the text.
fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|byte| text.is_char_boundary(*byte)).unwrap_or_default()
}

/// A count of characters or lines; a file of 2³² of them is not held in memory.
fn count(of: usize) -> u32 {
    u32::try_from(of).unwrap_or(u32::MAX)
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &*self.kind {
            ProfileErrorKind::Unreadable(_) => write!(f, "{}: {}", self.file, self.kind),
            kind => write!(f, "{}:{}:{}: {kind}", self.file, self.line, self.column),
        }
    }
}

impl fmt::Display for ProfileErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ProfileErrorKind::Unreadable(reason) => write!(f, "the profile cannot be read: {reason}"),
            ProfileErrorKind::Malformed(reason) => write!(f, "this is not TOML: {reason}"),
            ProfileErrorKind::Missing { key, allowed } => write!(f, "`{key}` is missing; it can be {allowed}"),
            ProfileErrorKind::Unknown { key, allowed } => {
                write!(f, "`{key}` is not a key of a profile; possible here: {allowed}")
            }
            ProfileErrorKind::WrongValue { key, found, allowed } => {
                write!(f, "`{key}` cannot be {found}; it can be {allowed}")
            }
            ProfileErrorKind::WrongClause { key, found, expected } => {
                write!(f, "`{key}` belongs to the clause {:?}, not to {found}", expected.id())
            }
            ProfileErrorKind::WrongSource { key, found } => {
                let tags = "\"S:…\" (read in that source), \"K\" (known), \"I\" (derived), \"D\" (decided)";
                write!(f, "`{key}` has the source {found}; sources are {tags}, separated by commas")
            }
            ProfileErrorKind::NameTaken(name) => {
                let why = "is a built-in profile that says something else";
                write!(f, "{name:?} {why}; give the profile a name of its own")
            }
        }
    }
}

impl core::error::Error for ProfileError {}

/// A value shown as the file writes it, cut if it is long.
pub(super) fn shown(text: &str) -> String {
    const MOST: usize = 40;
    let line = text.lines().next().unwrap_or_default();
    match line.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None if line.len() < text.trim_end().len() => format!("{line}…"),
        None => line.to_owned(),
    }
}
