//! What is wrong with a program or a tool table, drawn with a caret under the place.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use radcomp_spec::Clause;
use radcomp_spec::clause;
use radcomp_spec::profile::ProfileError;

/// A fault of a file, with its place. `Display` draws it without colours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The file's name.
    pub file: String,
    /// Line, from 1; 0 if the fault is not in a line.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// How many characters are meant; at least 1.
    pub length: u32,
    /// The text of the line.
    pub source_line: String,
    /// What is wrong.
    pub kind: Kind,
    /// What was expected at this place.
    pub message: String,
    /// What could be done.
    pub help: Option<Box<str>>,
    /// The clause concerned.
    pub clause: Option<Clause>,
}

/// Who has to change something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fault {
    /// The author of the program or of the tool table.
    Program,
    /// The author of the profile.
    Profile,
    /// The toolkit: the program may be right, radcomp cannot judge it yet.
    Toolkit,
    /// The file system.
    System,
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident = $fault:ident, $title:literal;)*) => {
        /// The kinds of diagnostics.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[non_exhaustive]
        pub enum Kind {
            $($(#[$doc])* $name,)*
        }

        impl Kind {
            /// Every kind.
            pub const ALL: &[Kind] = &[$(Kind::$name),*];

            /// The title of the message.
            pub const fn title(self) -> &'static str {
                match self { $(Kind::$name => $title,)* }
            }

            /// Who has to change something.
            pub const fn fault(self) -> Fault {
                match self { $(Kind::$name => Fault::$fault,)* }
            }
        }
    };
}

kinds! {
    /// The file cannot be read.
    Unreadable = System, "the file cannot be read";
    /// Bytes that are not UTF-8.
    NotText = Program, "not text";
    /// A line beyond the limit.
    LineTooLong = Program, "line too long";
    /// A character that starts nothing.
    UnexpectedCharacter = Program, "unexpected character";
    /// A comment without its end.
    UnclosedComment = Program, "comment without an end";
    /// A letter without its number.
    MissingNumber = Program, "number missing";
    /// A dwell without its time.
    MissingTime = Program, "dwell without a time";
    /// A number of a form that the word cannot have.
    WrongNumber = Program, "number of the wrong form";
    /// A number beyond the limit of digits.
    TooManyDigits = Program, "too many digits";
    /// A letter that is no address.
    UnknownLetter = Program, "unknown letter";
    /// A letter twice in one block.
    RepeatedWord = Program, "letter given twice";
    /// Two codes that exclude each other.
    ConflictingCodes = Program, "two codes of one group";
    /// A word that has no meaning in its block.
    MisplacedWord = Program, "word without a meaning here";
    /// A code that radcomp does not know.
    UnsupportedCode = Toolkit, "code not supported";
    /// A word that radcomp does not know.
    UnsupportedWord = Toolkit, "word not supported";
    /// A code that the profile does not declare.
    UndeclaredCode = Profile, "code not declared";
    /// A code that the profile says the control does not have.
    AbsentCode = Program, "code that the control does not have";
    /// Axis words before any motion code.
    NoMotion = Program, "movement without a motion code";
    /// An arc with both forms of centre.
    CentreAndRadius = Program, "arc with centre and radius";
    /// An arc with no form of centre.
    NoCentre = Program, "arc without a centre";
    /// A centre word of another plane.
    CentreOffPlane = Program, "centre word of another plane";
    /// A dummy block where there can be none.
    DummyRefused = Program, "no dummy block possible here";
    /// A movement in another plane than the movements before.
    PlaneChange = Toolkit, "movement in another plane";
    /// A code in offset mode whose rule the profile's sources do not tell.
    NotInMode = Profile, "code that the profile does not tell in offset mode";
    /// Compensation before an offset was selected.
    NoOffset = Program, "compensation without an offset";
    /// An offset number that the table does not have.
    UnknownOffset = Program, "offset not in the tool table";
    /// Offset number 0 while compensation is in force, where the profile's sources do not tell what it does.
    OffsetZero = Profile, "offset 0 while compensation is in force";
    /// A tool table that is not one.
    WrongTable = Program, "tool table not understood";
    /// A tip orientation that the profile says the control does not have.
    AbsentOrientation = Program, "tip orientation that the control does not have";
    /// A profile that is not one.
    WrongProfile = Profile, "profile not understood";
}

/// A fault within a line, before the line has a place in a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LineFault {
    kind: Kind,
    /// Bytes of the line.
    span: Range<usize>,
    message: String,
    help: Option<Box<str>>,
    clause: Option<Clause>,
}

impl LineFault {
    pub(super) fn new(kind: Kind, span: Range<usize>, message: impl Into<String>) -> Self {
        LineFault { kind, span, message: message.into(), help: None, clause: None }
    }

    pub(super) fn citing(self, clause: Clause) -> Self {
        LineFault { clause: Some(clause), ..self }
    }

    pub(super) fn helping(self, help: impl Into<Box<str>>) -> Self {
        LineFault { help: Some(help.into()), ..self }
    }

    /// The same fault at that line of a file.
    pub(super) fn in_line(self, file: &str, line: u32, source_line: &str) -> Diagnostic {
        let start = boundary(source_line, self.span.start);
        let end = boundary(source_line, self.span.end).max(start);
        Diagnostic {
            file: file.to_owned(),
            line,
            column: count(source_line[..start].chars().count()) + 1,
            length: count(source_line[start..end].chars().count()).max(1),
            source_line: source_line.to_owned(),
            kind: self.kind,
            message: self.message,
            help: self.help,
            clause: self.clause,
        }
    }

    /// The same fault in the text of a whole file, the span being one of that text.
    pub(super) fn in_text(mut self, file: &str, text: &str) -> Diagnostic {
        let start = boundary(text, self.span.start);
        let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
        let source_line = text[line_start..].lines().next().unwrap_or_default();
        let line = count(text[..line_start].matches('\n').count()) + 1;
        self.span = start - line_start..self.span.end.saturating_sub(line_start).min(source_line.len());
        self.in_line(file, line, source_line)
    }
}

/// The start of the character that this byte belongs to, or the end of the text.
fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|byte| text.is_char_boundary(*byte)).unwrap_or_default()
}

/// A count of characters or lines, which are far fewer than 2³² wherever they are held in memory.
fn count(of: usize) -> u32 {
    u32::try_from(of).unwrap_or(u32::MAX)
}

impl Diagnostic {
    /// The fault with the renderer given, for instance one with colours.
    pub fn render(&self, renderer: &Renderer) -> String {
        let title = Level::ERROR.primary_title(self.kind.title());
        let byte = |column: u32| {
            let mut characters = self.source_line.char_indices().map(|(byte, _)| byte);
            characters.nth(column as usize).unwrap_or(self.source_line.len())
        };
        let column = self.column.saturating_sub(1);
        let span = byte(column)..byte(column.saturating_add(self.length));
        let mark = AnnotationKind::Primary.span(span).label(&*self.message);
        let snippet = Snippet::source(&*self.source_line).path(&*self.file).line_start(self.line as usize);
        let mut group = match self.line {
            0 => title.element(Level::ERROR.with_name("file").message(format!("{}: {}", self.file, self.message))),
            _ => title.element(snippet.annotation(mark)),
        };
        if let Some(clause) = self.clause {
            let title = clause::ALL.iter().find(|(known, _)| *known == clause).map_or("", |(_, title)| title);
            group = group.element(Level::NOTE.message(format!("[{clause}] {title}")));
        }
        if let Some(help) = &self.help {
            group = group.element(Level::HELP.message(&**help));
        }
        renderer.render(&[group])
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(&Renderer::plain()))
    }
}

impl std::error::Error for Diagnostic {}

impl From<ProfileError> for Diagnostic {
    fn from(error: ProfileError) -> Self {
        let message = error.kind.to_string();
        let unreadable = matches!(*error.kind, radcomp_spec::profile::ProfileErrorKind::Unreadable(_));
        Diagnostic {
            file: error.file,
            line: if unreadable { 0 } else { error.line },
            column: error.column,
            length: error.length,
            source_line: error.source_line,
            kind: if unreadable { Kind::Unreadable } else { Kind::WrongProfile },
            message,
            help: None,
            clause: None,
        }
    }
}
