//! The pages beside the chapters: the first one, the vectors, the seed documents, the guides.

use std::collections::BTreeMap;

use minijinja::context;
use radcomp_spec::catalogue::Catalogue;

use super::exhibit::{Place, exhibit};
use super::index::{Index, Kind};
use super::links::page_of;
use super::profiles::without_title;
use super::prose::slug;
use super::site::Site;
use crate::evidence::Ledger;
use crate::vectors::{self, Vector};

/// A guide.
pub(super) struct Guide {
    /// Its file in `spec/guides`.
    pub(super) file: &'static str,
    /// Its title.
    pub(super) title: &'static str,
    text: &'static str,
}

/// The guides in the order of the contents.
pub(super) const GUIDES: [Guide; 3] = [
    Guide { file: "readers.md", title: "For readers", text: include_str!("../../spec/guides/readers.md") },
    Guide { file: "vendors.md", title: "For vendors", text: include_str!("../../spec/guides/vendors.md") },
    Guide {
        file: "contributors.md",
        title: "For contributors",
        text: include_str!("../../spec/guides/contributors.md"),
    },
];

/// The vectors of `tests/vectors`, by their names.
///
/// # Errors
///
/// A file of vectors that cannot be read.
pub(super) fn vectors() -> Result<Vec<Vector>, String> {
    let mut found = Vec::new();
    for vector in vectors::all() {
        match vector {
            Err(fault) => return Err(fault.clone()),
            Ok(vector) if vector.name.starts_with("TRC-") => {}
            Ok(vector) => found.push(vector.clone()),
        }
    }
    Ok(found)
}

/// Adds the first page.
pub(super) fn front(site: &mut Site<'_>, ledger: &Ledger) -> Result<(), String> {
    let catalogue = Catalogue::builtin();
    let chapters: Vec<_> = catalogue
        .chapters
        .iter()
        .enumerate()
        .map(|(number, chapter)| {
            let clauses = catalogue.clauses.iter().filter(|clause| clause.chapter == number).count();
            BTreeMap::from([
                ("page", page_of(chapter.file)),
                ("title", chapter.title.to_owned()),
                ("clauses", clauses.to_string()),
            ])
        })
        .collect();
    let values = context! { chapters, clauses => ledger.rows.len(), examples => vectors::all().len() };
    site.page("index.html", "Tool-radius compensation, rule by rule", "front.html", values)
}

/// Adds `spec/README.md`: how to read a clause and an example, and the sources.
pub(super) fn reading(site: &mut Site<'_>, index: &mut Index) -> Result<(), String> {
    let text = include_str!("../../spec/README.md");
    index_sections(index, "reading.html", "How to read a clause", text);
    let body = site.documents().html(without_title(text));
    site.page("reading.html", "How to read a clause", "document.html", context! { body })
}

/// Adds `spec/CHANGES.md`.
pub(super) fn changes(site: &mut Site<'_>) -> Result<(), String> {
    let body = site.documents().html(without_title(include_str!("../../spec/CHANGES.md")));
    site.page("changes.html", "Changes of the normative text", "document.html", context! { body })
}

/// Adds the guides.
pub(super) fn guides(site: &mut Site<'_>, index: &mut Index) -> Result<(), String> {
    for guide in &GUIDES {
        let page = page_of(guide.file);
        index_sections(index, &page, guide.title, guide.text);
        let body = site.documents().html(without_title(guide.text));
        site.page(&page, guide.title, "document.html", context! { body })?;
    }
    Ok(())
}

/// Each section of a document is found by its words.
fn index_sections(index: &mut Index, page: &str, title: &str, text: &str) {
    for section in text.split("\n## ").skip(1) {
        let (heading, body) = section.split_once('\n').unwrap_or((section, ""));
        let plain = body.replace(['`', '|', '#', '*'], " ");
        index.add(Kind::Guide, &format!("{title}: {heading}"), &format!("{page}#{}", slug(heading)), &plain);
    }
}

/// Adds the page of the vectors, each executed and drawn.
///
/// # Errors
///
/// The first that does not hold.
pub(super) fn vector_page(site: &mut Site<'_>, index: &mut Index, vectors: &[Vector]) -> Result<(), String> {
    let mut exhibits = Vec::new();
    for vector in vectors {
        let place = Place { file: "tests/vectors", line: None, id: &vector.name };
        exhibits.push(exhibit(vector, &vector.story, "", place, &[], site.clauses())?);
        site.executed();
        index.add(Kind::Vector, &vector.name, &format!("vectors.html#{}", vector.name), &vector.story.replace('`', ""));
    }
    site.page("vectors.html", "Vectors", "vectors.html", context! { exhibits })
}

/// Adds the table of the seed documents' sentences, each with the figures that show it.
pub(super) fn seeds(site: &mut Site<'_>, index: &mut Index) -> Result<(), String> {
    let text = include_str!("../../spec/SEEDS.md");
    let (mut out, mut document, mut number) = (String::new(), String::new(), 0);
    for line in without_title(text).lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            document = heading.to_owned();
        }
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [sentence, clauses, tests] = cells[..] else {
            out += line;
            out.push('\n');
            continue;
        };
        if sentence == "sentence" || sentence.starts_with("---") {
            out += line;
            out.push('\n');
            continue;
        }
        number += 1;
        let figures = figures(site, tests);
        let target = format!("seeds.html#sentence-{number}");
        let more = figures
            .iter()
            .filter(|(_, target)| !target.is_empty())
            .map(|(name, target)| [name.clone(), target.clone()]);
        index.add_with(Kind::Sentence, sentence, &target, &format!("{document} {clauses}"), more.collect());
        let linked = figures.iter().map(|(name, target)| match target.is_empty() {
            true => name.clone(),
            false => format!("[{name}]({target})"),
        });
        let linked = linked.collect::<Vec<_>>().join(", ");
        out += &format!("| <span id=\"sentence-{number}\">{sentence}</span> | {clauses} | {linked} |\n");
    }
    let body = site.documents().html(&out);
    site.page("seeds.html", "The seed documents, sentence by sentence", "document.html", context! { body })
}

/// The examples and vectors that a cell of the table names, with their anchors: `TRC-SIDE-02#1 to #3` is three.
fn figures(site: &Site<'_>, tests: &str) -> Vec<(String, String)> {
    let (mut figures, mut clause) = (Vec::new(), String::new());
    let target = |name: &str| site.links().clause(name).or(site.links().vector(name)).unwrap_or_default().to_owned();
    for part in tests.split(", ") {
        let (first, last) = part.split_once(" to #").unwrap_or((part, ""));
        let (base, number) = first.split_once('#').unwrap_or((first, ""));
        if base.starts_with("TRC-") {
            base.clone_into(&mut clause);
        }
        match (number.parse::<usize>(), last.parse::<usize>()) {
            (Ok(number), last) => {
                for number in number..=last.unwrap_or(number) {
                    let name = format!("{clause}#{number}");
                    let target = target(&name);
                    figures.push((name, target));
                }
            }
            (Err(_), _) => figures.push((part.to_owned(), target(base))),
        }
    }
    figures
}
