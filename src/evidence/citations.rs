//! Who cites which clause: the sources, read line by line.

use std::fs;
use std::path::{Path, PathBuf};

use radcomp_spec::{AdvisoryKind, AlarmKind, DecisionKind, clause};
use serde::Serialize;

/// A place in the sources that cites a clause.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Citation {
    /// The clause.
    #[serde(skip)]
    pub clause: &'static str,
    /// Whose code it is.
    #[serde(skip)]
    pub place: Place,
    /// The file, from the root of the repository.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// The function, or other item, that it stands in; the file's stem outside all.
    pub item: String,
}

/// Whose code cites a clause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The model.
    Model,
    /// The implementation.
    Implementation,
    /// The program reader, and the toolkit's tool tip.
    Reader,
    /// A test.
    Tests,
    /// A harness.
    Proofs,
}

/// Where each kind of code stands.
const FOLDERS: [(&str, Place); 9] = [
    ("model/src", Place::Model),
    ("impl/src", Place::Implementation),
    ("src/gcode", Place::Reader),
    ("src/tip.rs", Place::Reader),
    ("tests", Place::Tests),
    ("model/tests", Place::Tests),
    ("impl/tests", Place::Tests),
    ("proofs/tests", Place::Tests),
    ("proofs/src", Place::Proofs),
];

/// Every citation of a clause that exists.
///
/// # Errors
///
/// If a folder or file cannot be read.
pub fn citations(root: &Path) -> Result<Vec<Citation>, String> {
    let mut found = Vec::new();
    for (folder, place) in FOLDERS {
        for path in files(&root.join(folder), &["rs"])? {
            let (text, file) = (read(&path)?, relative(root, &path));
            // The tests of this ledger and of the book are no evidence for a rule.
            if file != "tests/ledger.rs" && !file.starts_with("tests/book") {
                in_file(&file, &text, place, &mut found);
            }
        }
    }
    Ok(found)
}

/// Ids written anywhere in the repository that name no clause: each with file and line. A chapter `NONE` and the number 99
/// are made up, for tests of what is wrong.
///
/// # Errors
///
/// If a folder or file cannot be read.
pub fn unknown_citations(root: &Path) -> Result<Vec<String>, String> {
    const FOLDERS: [&str; 10] = [
        "spec",
        "model",
        "impl",
        "src",
        "tests",
        "proofs/src",
        "proofs/lemmas",
        "proofs/tests",
        "fuzz/src",
        "examples",
    ];
    let mut unknown = Vec::new();
    for folder in FOLDERS.map(|folder| root.join(folder)).into_iter().chain([root.join("README.md")]) {
        for path in files(&folder, &["rs", "md", "toml", "smt2", "nc", "html"])? {
            for (number, line) in (1..).zip(read(&path)?.lines()) {
                for id in ids(line).filter(|id| !id.starts_with("TRC-NONE-") && !id.ends_with("-99")) {
                    if !clause::ALL.iter().any(|(clause, _)| clause.id() == id) {
                        unknown.push(format!("{}:{number}: {id} is no clause", relative(root, &path)));
                    }
                }
            }
        }
    }
    Ok(unknown)
}

/// The ids in a text, `TRC-CORNER-08` or `TRC_CORNER_08`, as the specification writes them.
fn ids(text: &str) -> impl Iterator<Item = String> {
    text.match_indices("TRC").filter_map(|(start, _)| {
        let rest = text[start + 3..].replace('_', "-");
        let rest = rest.strip_prefix('-')?;
        let letters = rest.find(|character: char| !character.is_ascii_uppercase())?;
        let digits = rest[letters..].strip_prefix('-')?;
        let count = digits.bytes().take_while(u8::is_ascii_digit).count();
        (letters > 0 && count == 2).then(|| format!("TRC-{}-{}", &rest[..letters], &digits[..2]))
    })
}

/// The clauses that a line of code cites.
fn cited(line: &str) -> Vec<&'static str> {
    let known = |id: String| clause::ALL.iter().map(|(clause, _)| clause.id()).find(|known| *known == id);
    let mut found: Vec<_> = ids(line).filter_map(known).collect();
    let names = |kind: &str, name: String| {
        let wanted = format!("{kind}::{name}");
        line.match_indices(&wanted).any(|(start, _)| {
            !line[start + wanted.len()..].starts_with(|next: char| next.is_alphanumeric() || next == '_')
        })
    };
    let alarms = AlarmKind::ALL.iter().filter(|kind| names("AlarmKind", format!("{kind:?}"))).map(|kind| kind.clause());
    let advisories =
        AdvisoryKind::ALL.iter().filter(|kind| names("AdvisoryKind", format!("{kind:?}"))).map(|kind| kind.clause());
    let decisions =
        DecisionKind::ALL.iter().filter(|kind| names("DecisionKind", format!("{kind:?}"))).map(|kind| kind.clause());
    found.extend(alarms.chain(advisories).chain(decisions).map(|clause| clause.id()));
    found
}

fn in_file(file: &str, text: &str, place: Place, found: &mut Vec<Citation>) {
    let lines: Vec<&str> = text.lines().collect();
    let items = items(&lines);
    let stem = Path::new(file).file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let in_tests = file.contains("/tests/") || file.ends_with("/tests.rs") || place == Place::Tests;
    for (index, line) in lines.iter().enumerate() {
        for clause in cited(line) {
            let holding = || items.iter().filter(|item| item.first <= index && index <= item.last);
            let tested = in_tests || holding().any(|item| item.name == "tests" || item.is_test);
            // What a test's file says beside its tests, such as a list of exceptions, tests nothing.
            if tested && !holding().any(|item| item.is_test) {
                continue;
            }
            let innermost = holding().filter(|item| item.is_function).max_by_key(|item| item.first);
            let item = innermost.or_else(|| holding().max_by_key(|item| item.first));
            found.push(Citation {
                clause,
                place: if tested { Place::Tests } else { place },
                file: file.to_owned(),
                line: index + 1,
                item: item.map_or_else(|| stem.clone(), |item| item.name.clone()),
            });
        }
    }
}

/// An item with the lines of its documentation and its body.
struct Item {
    name: String,
    is_function: bool,
    is_test: bool,
    first: usize,
    last: usize,
}

/// The items of a file that rustfmt has set: an item ends at the brace that stands below its first letter.
fn items(lines: &[&str]) -> Vec<Item> {
    let mut items = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let Some((name, is_function)) = item_name(line) else { continue };
        let indent = &line[..line.len() - line.trim_start().len()];
        let closes = |line: &&str| {
            line.strip_prefix(indent).is_some_and(|rest| matches!(rest, "}" | "};" | ")" | ");" | "]" | "];"))
        };
        let whole = line.ends_with(';') || line.ends_with('}');
        let last = if whole {
            index
        } else {
            lines[index..].iter().position(closes).map_or(lines.len() - 1, |length| index + length)
        };
        let above = lines[..index].iter().rev().take_while(|line| {
            let line = line.trim_start();
            line.starts_with("//") && !line.starts_with("//!") || line.starts_with("#[")
        });
        let first = index - above.clone().count();
        let is_test = above.clone().any(|line| line.trim() == "#[test]");
        items.push(Item { name, is_function, is_test, first, last });
    }
    items
}

/// The name of the item that begins on a line.
fn item_name(line: &str) -> Option<(String, bool)> {
    let mut words = line.trim_start().split([' ', '(', '<', ':', ';', '{', '!']).filter(|word| !word.is_empty());
    loop {
        let word = words.next()?;
        let keyword = match word {
            "pub" | "crate)" | "super)" | "in" | "unsafe" | "extern" | "\"C\"" | "async" => continue,
            "const" => {
                let next = words.next()?;
                return match next {
                    "fn" => Some((words.next()?.to_owned(), true)),
                    name => Some((name.to_owned(), false)),
                };
            }
            "fn" => true,
            "struct" | "enum" | "trait" | "mod" | "static" | "type" | "macro_rules" | "impl" => false,
            _ => return None,
        };
        let name = words.next()?;
        let sensible = name.starts_with(|first: char| first.is_alphabetic() || first == '_');
        return sensible.then(|| (name.to_owned(), keyword));
    }
}

/// Every file with one of these extensions, in order; the path itself if it is a file.
pub(super) fn files(path: &Path, extensions: &[&str]) -> Result<Vec<PathBuf>, String> {
    let wrong = |reason: std::io::Error| format!("{}: {reason}", path.display());
    if path.is_file() {
        return Ok(vec![path.to_owned()]);
    }
    let mut entries = fs::read_dir(path).map_err(wrong)?.collect::<Result<Vec<_>, _>>().map_err(wrong)?;
    entries.sort_by_key(fs::DirEntry::file_name);
    let mut found = Vec::new();
    for entry in entries.iter().map(fs::DirEntry::path) {
        if entry.is_dir() {
            if !entry.ends_with("target") {
                found.extend(files(&entry, extensions)?);
            }
        } else if entry.extension().is_some_and(|known| extensions.iter().any(|wanted| known == *wanted)) {
            found.push(entry);
        }
    }
    Ok(found)
}

pub(super) fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|reason| format!("{}: {reason}", path.display()))
}

fn relative(root: &Path, path: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
//! A file. [TRC-PLANE-01]

/// Forms a corner ([TRC-CORNER-03]).
#[inline]
pub(crate) fn corner(a: u8) -> u8 {
    // [TRC-CORNER-04], [TRC-NONE-01]
    a
}

impl Path {
    pub const fn step(self) {
        decide(DecisionKind::RightAngle, AlarmKind::ReversedLine);
    }
}

const LIMIT: Clause = clause::TRC_ARC_01;

mod tests {
    #[test]
    fn corners() {
        assert_eq!(clause::TRC_SIDE_01, 1);
    }

    const EXEMPT: Clause = clause::TRC_SIDE_02;
}
";

    #[test]
    fn a_citation_belongs_to_the_innermost_function() {
        let mut found = Vec::new();
        in_file("model/src/x.rs", TEXT, Place::Model, &mut found);
        let short: Vec<_> =
            found.iter().map(|found| (found.clause, found.item.as_str(), found.line, found.place)).collect();
        let expected = [
            ("TRC-PLANE-01", "x", 1, Place::Model),
            ("TRC-CORNER-03", "corner", 3, Place::Model),
            ("TRC-CORNER-04", "corner", 6, Place::Model),
            ("TRC-WEDGE-02", "step", 12, Place::Model),
            ("TRC-CORNER-08", "step", 12, Place::Model),
            ("TRC-ARC-01", "LIMIT", 16, Place::Model),
            ("TRC-SIDE-01", "corners", 21, Place::Tests),
        ];
        assert_eq!(short, expected);
    }

    #[test]
    fn ids_are_two_digits_after_a_word() {
        let found: Vec<_> = ids("[TRC-CORNER-08] TRC_SIDE_01 TRC-… TRC-A-1 TRC-LOOK-02b").collect();
        assert_eq!(found, ["TRC-CORNER-08", "TRC-SIDE-01", "TRC-LOOK-02"]);
    }
}
