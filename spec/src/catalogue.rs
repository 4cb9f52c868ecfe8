//! The text of the clauses, taken from `spec/clauses/*.md` as the crate is built.
//!
//! A chapter file starts with its title and an introduction. Each clause is a heading `## [TRC-…] Title`, a line
//! `Source: …`, and its normative paragraphs; worked examples follow them, each a caption paragraph and a fenced block
//! with the info string `toml example`.

use std::sync::LazyLock;

use crate::clause::{self, Clause};

/// The specification.
#[derive(Debug)]
pub struct Catalogue {
    /// Its chapters, in order.
    pub chapters: Vec<Chapter>,
    /// Its clauses, in order.
    pub clauses: Vec<ClauseText>,
}

/// A chapter: one file of the specification.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chapter {
    /// The file's name in `spec/clauses`.
    pub file: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What stands before the first clause.
    pub introduction: &'static str,
}

/// A clause with its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClauseText {
    /// Its id.
    pub clause: Clause,
    /// Its title.
    pub title: &'static str,
    /// Where it comes from: `S:…`, `K`, `I` or `D`.
    pub sources: Vec<&'static str>,
    /// Its normative paragraphs, as Markdown.
    pub text: &'static str,
    /// Its worked examples.
    pub examples: Vec<Example>,
    /// The chapter, as an index into [`Catalogue::chapters`].
    pub chapter: usize,
    /// The line of its heading in the chapter's file, from 1.
    pub line: u32,
}

/// A worked example of a clause.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// What it shows.
    pub caption: &'static str,
    /// The text within the fences: TOML.
    pub text: &'static str,
    /// The line in the chapter's file where that text starts, from 1.
    pub line: u32,
}

/// The chapter files.
const FILES: [(&str, &str); 13] = [
    ("01-plane.md", include_str!("../clauses/01-plane.md")),
    ("02-mode.md", include_str!("../clauses/02-mode.md")),
    ("03-start-up.md", include_str!("../clauses/03-start-up.md")),
    ("04-corner.md", include_str!("../clauses/04-corner.md")),
    ("05-side.md", include_str!("../clauses/05-side.md")),
    ("06-cancel.md", include_str!("../clauses/06-cancel.md")),
    ("07-look-ahead.md", include_str!("../clauses/07-look-ahead.md")),
    ("08-dummy.md", include_str!("../clauses/08-dummy.md")),
    ("09-arc.md", include_str!("../clauses/09-arc.md")),
    ("10-wedge.md", include_str!("../clauses/10-wedge.md")),
    ("11-tip.md", include_str!("../clauses/11-tip.md")),
    ("12-vectors.md", include_str!("../clauses/12-vectors.md")),
    ("13-interference.md", include_str!("../clauses/13-interference.md")),
];

/// The fence that opens a worked example.
const EXAMPLE: &str = "```toml example";
/// The fence that closes it.
const FENCE: &str = "```";

impl Catalogue {
    /// The specification that this crate was built with.
    pub fn builtin() -> &'static Catalogue {
        static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(|| {
            // A test parses these constant texts.
            Catalogue::parse(&FILES).expect("the specification's chapters are well-formed")
        });
        &CATALOGUE
    }

    /// The text of a clause.
    pub fn text_of(&self, clause: Clause) -> Option<&ClauseText> {
        self.clauses.iter().find(|text| text.clause == clause)
    }

    /// The text of the clause with this id, such as `TRC-CORNER-03`; upper and lower case are the same.
    pub fn find(&self, id: &str) -> Option<&ClauseText> {
        self.clauses.iter().find(|text| text.clause.id().eq_ignore_ascii_case(id))
    }

    fn parse(files: &[(&'static str, &'static str)]) -> Result<Catalogue, String> {
        let mut catalogue = Catalogue { chapters: Vec::new(), clauses: Vec::new() };
        for (file, text) in files {
            catalogue.parse_chapter(file, text).map_err(|(line, reason)| format!("{file}:{line}: {reason}"))?;
        }
        Ok(catalogue)
    }

    fn parse_chapter(&mut self, file: &'static str, text: &'static str) -> Result<(), (u32, String)> {
        let sections = sections(text);
        let (_, opening) = sections.first().ok_or((1, "the chapter is empty".to_owned()))?;
        let (title, introduction) = opening
            .strip_prefix("# ")
            .and_then(|rest| rest.split_once('\n'))
            .ok_or((1, "the chapter has no title".to_owned()))?;
        self.chapters.push(Chapter { file, title: title.trim(), introduction: introduction.trim() });
        for (line, section) in &sections[1..] {
            self.clauses.push(parse_clause(section, *line, self.chapters.len() - 1)?);
        }
        Ok(())
    }
}

/// A chapter's text cut before each heading of a clause, each part with the line it starts at.
fn sections(text: &'static str) -> Vec<(u32, &'static str)> {
    let (mut sections, mut start, mut first_line) = (Vec::new(), 0, 1);
    let (mut offset, mut fenced) = (0, false);
    for (line, content) in (1..).zip(text.split_inclusive('\n')) {
        if content.starts_with(FENCE) {
            fenced = !fenced;
        }
        if content.starts_with("## ") && !fenced {
            sections.push((first_line, &text[start..offset]));
            (start, first_line) = (offset, line);
        }
        offset += content.len();
    }
    sections.push((first_line, &text[start..]));
    sections
}

fn parse_clause(section: &'static str, line: u32, chapter: usize) -> Result<ClauseText, (u32, String)> {
    let fault = |reason: &str| (line, reason.to_owned());
    let (heading, rest) = section.split_once('\n').ok_or(fault("the clause has no text"))?;
    let (id, title) = heading
        .strip_prefix("## [")
        .and_then(|rest| rest.split_once("] "))
        .ok_or(fault("a heading is not `## [TRC-…] Title`"))?;
    let clause = clause::ALL.iter().map(|(clause, _)| *clause).find(|clause| clause.id() == id);
    let clause = clause.ok_or_else(|| (line, format!("there is no clause {id} in `clause.rs`")))?;
    let (source, body) = rest.split_once('\n').ok_or(fault("the clause has no text"))?;
    let source = source.strip_prefix("Source: ").ok_or(fault("the heading is not followed by `Source: …`"))?;
    let end = match body.find(EXAMPLE) {
        // The paragraph before the first fence is its caption.
        Some(fence) => body[..fence].trim_end().rfind("\n\n").ok_or(fault("an example has no caption"))?,
        None => body.len(),
    };
    Ok(ClauseText {
        clause,
        title: title.trim(),
        sources: source.split(',').map(str::trim).collect(),
        text: body[..end].trim(),
        examples: examples(&body[end..], line + 2 + lines_in(&body[..end]))?,
        chapter,
        line,
    })
}

/// The fenced examples of a text that starts at this line of its file.
fn examples(text: &'static str, line: u32) -> Result<Vec<Example>, (u32, String)> {
    let mut examples = Vec::new();
    let mut offset = 0;
    while let Some(found) = text[offset..].find(EXAMPLE) {
        let fence = offset + found;
        let place = line + lines_in(&text[..fence]);
        let caption = text[offset..fence].trim();
        if caption.is_empty() || caption.contains("\n\n") {
            return Err((place, "a worked example has one paragraph before it, its caption".to_owned()));
        }
        let (_, after) = text[fence..].split_once('\n').ok_or((place, "the example has no end".to_owned()))?;
        let start = text.len() - after.len();
        let end = after.find("\n```").ok_or((place, "the example has no end".to_owned()))?;
        examples.push(Example { caption, text: &after[..=end], line: place + 1 });
        offset = start + end + "\n```".len();
    }
    match text[offset..].trim() {
        "" => Ok(examples),
        _ => Err((line, "only worked examples may follow a worked example".to_owned())),
    }
}

fn lines_in(text: &str) -> u32 {
    // The chapters are constants of a few hundred lines.
    text.matches('\n').count() as u32
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_chapters_hold_every_clause_once_and_in_order_with_its_title() {
        let catalogue = Catalogue::parse(&FILES).unwrap();
        let written: Vec<_> = catalogue.clauses.iter().map(|text| (text.clause, text.title)).collect();
        assert_eq!(written, clause::ALL);
        let ids: BTreeSet<_> = written.iter().map(|(clause, _)| clause.id()).collect();
        assert_eq!(ids.len(), written.len(), "an id stands twice");
    }

    #[test]
    fn every_citation_exists() {
        for (file, text) in FILES {
            for citation in text.split("[TRC-").skip(1) {
                let id = citation.split(']').next().unwrap();
                assert!(Catalogue::builtin().find(&format!("TRC-{id}")).is_some(), "{file} cites TRC-{id}");
            }
        }
    }

    #[test]
    fn every_clause_has_text_and_sources() {
        for text in &Catalogue::builtin().clauses {
            assert!(!text.text.is_empty() && !text.text.contains("```"), "{}", text.clause);
            for source in &text.sources {
                let tag = matches!(*source, "K" | "I" | "D") || source.starts_with("S:");
                assert!(tag, "{}: {source:?} is not a source tag", text.clause);
            }
        }
    }

    #[test]
    fn chapter_files_on_disk_are_all_embedded() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("clauses");
        let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let on_disk: BTreeSet<String> = names.map(|name| name.into_string().unwrap()).collect();
        let embedded: BTreeSet<String> = FILES.iter().map(|(file, _)| (*file).to_owned()).collect();
        assert_eq!(on_disk, embedded);
    }

    #[test]
    fn examples_are_found_with_their_lines() {
        let text = "# One\n\nWords.\n\n## [TRC-PLANE-01] T\nSource: K, S:x p.1\n\nNormative.\n\nMore.\n\n\
                    One:\n\n```toml example\na = 1\n## b\n```\n\nTwo:\n\n```toml example\nc = 2\n```\n";
        let catalogue = Catalogue::parse(&[("x.md", text)]).unwrap();
        let [clause] = &catalogue.clauses[..] else { panic!("one clause") };
        assert_eq!(clause.text, "Normative.\n\nMore.");
        assert_eq!(clause.sources, ["K", "S:x p.1"]);
        let examples = [
            Example { caption: "One:", text: "a = 1\n## b\n", line: 15 },
            Example { caption: "Two:", text: "c = 2\n", line: 22 },
        ];
        assert_eq!(clause.examples, examples);
        assert_eq!((catalogue.chapters[0].introduction, clause.line), ("Words.", 5));
    }

    #[test]
    fn faults_of_a_chapter_name_their_line() {
        let fault = |text| Catalogue::parse(&[("x.md", text)]).unwrap_err();
        assert_eq!(
            fault("# One\n\n## [TRC-NONE-01] T\nSource: K\n\nText.\n"),
            "x.md:3: there is no clause TRC-NONE-01 in `clause.rs`"
        );
        let late = "# One\n\n## [TRC-PLANE-01] T\nSource: K\n\nText.\n\nOne:\n\n```toml example\na\n```\nLate.\n";
        assert!(fault(late).ends_with("only worked examples may follow a worked example"));
    }
}
