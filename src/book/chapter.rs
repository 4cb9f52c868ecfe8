//! The chapters, a page each, and the page that finds a clause by its id.

use std::collections::BTreeMap;

use minijinja::context;
use radcomp_spec::catalogue::{Catalogue, ClauseText};
use radcomp_spec::profile::PARAMETERS;
use serde::Serialize;

use super::exhibit::{Exhibit, Place, exhibit};
use super::index::{Index, Kind};
use super::links::page_of;
use super::prose::without_tags;
use super::site::Site;
use crate::evidence::Ledger;
use crate::vectors::Vector;

/// A clause as its chapter shows it.
#[derive(Serialize)]
struct Section {
    id: &'static str,
    title: &'static str,
    sources: Vec<Source>,
    text: String,
    /// The profile's choices that it speaks of.
    parameters: Vec<&'static str>,
    exhibits: Vec<Exhibit>,
    /// Its row of the ledger, short.
    evidence: String,
}

#[derive(Serialize)]
struct Source {
    tag: &'static str,
    meaning: &'static str,
}

/// Adds a page for each chapter.
///
/// # Errors
///
/// The first worked example that does not hold.
pub(super) fn chapters(site: &mut Site<'_>, index: &mut Index, ledger: &Ledger) -> Result<(), String> {
    let catalogue = Catalogue::builtin();
    for (number, chapter) in catalogue.chapters.iter().enumerate() {
        let page = page_of(chapter.file);
        let prose = site.clauses();
        let mut sections = Vec::new();
        for clause in catalogue.clauses.iter().filter(|clause| clause.chapter == number) {
            let section = section(site, clause, chapter.file, ledger)?;
            let plain = format!("{} {}", without_tags(&section.text), captions(clause));
            index.add(
                Kind::Clause,
                &format!("{} {}", section.id, section.title),
                &format!("{page}#{}", section.id),
                &plain,
            );
            sections.push(section);
        }
        let introduction = prose.html(chapter.introduction);
        index.add(Kind::Chapter, chapter.title, &page, &without_tags(&introduction));
        let file = format!("spec/clauses/{}", chapter.file);
        site.page(&page, chapter.title, "chapter.html", context! { introduction, sections, file })?;
    }
    let clauses: Vec<_> = catalogue
        .clauses
        .iter()
        .map(|clause| {
            let target = site.links().clause(clause.clause.id()).unwrap_or_default();
            BTreeMap::from([("id", clause.clause.id()), ("title", clause.title), ("target", target)])
        })
        .collect();
    site.page("clause.html", "Clauses by id", "lookup.html", context! { clauses })
}

fn captions(clause: &ClauseText) -> String {
    clause.examples.iter().map(|example| example.caption.replace(['`', '[', ']'], "")).collect::<Vec<_>>().join(" ")
}

fn section(site: &mut Site<'_>, clause: &ClauseText, file: &str, ledger: &Ledger) -> Result<Section, String> {
    let prose = site.clauses();
    let parameters = parameters_of(clause);
    let mut exhibits = Vec::new();
    let file = format!("spec/clauses/{file}");
    for (number, example) in (1..).zip(&clause.examples) {
        let id = format!("{}-{number}", clause.clause.id());
        let vector: Vector =
            toml::from_str(example.text).map_err(|error| format!("{file}:{}: {error}", example.line))?;
        let place = Place { file: &file, line: Some(example.line), id: &id };
        exhibits.push(exhibit(&vector, example.caption, example.text, place, &parameters, prose)?);
        site.executed();
    }
    Ok(Section {
        id: clause.clause.id(),
        title: clause.title,
        sources: clause.sources.iter().map(|tag| Source { tag, meaning: meaning(tag) }).collect(),
        text: prose.html(clause.text),
        parameters,
        exhibits,
        evidence: ledger.summary(clause.clause.id()),
    })
}

/// The parameters of the compensation that a clause defines or names, or that have a value which it describes.
fn parameters_of(clause: &ClauseText) -> Vec<&'static str> {
    let named = |name: &str| clause.text.contains(&format!("`{name}`"));
    let described = described_by(clause.clause.id());
    PARAMETERS
        .iter()
        .filter(|parameter| parameter.table() == "compensation")
        .filter(|parameter| {
            let name = parameter.name();
            parameter.clause == clause.clause || named(name) || described.iter().any(|known| known == name)
        })
        .map(|parameter| parameter.name())
        .collect()
}

/// The parameters whose values cite a clause in the words of `spec/src/parameters.rs`: the type `OuterCorner` is that of
/// `outer-corner`.
fn described_by(id: &str) -> Vec<String> {
    let (mut described, mut above, mut parameter) = (Vec::new(), false, String::new());
    for line in include_str!("../../spec/src/parameters.rs").lines().map(str::trim) {
        if line.starts_with("///") {
            above |= line.contains(&format!("[{id}]"));
            continue;
        }
        let ends = line.strip_suffix(" {").filter(|name| name.chars().all(char::is_alphabetic));
        if let Some(name) = ends {
            parameter = kebab(name);
        }
        if std::mem::take(&mut above) && !described.contains(&parameter) {
            described.push(parameter.clone());
        }
    }
    described
}

fn kebab(name: &str) -> String {
    let mut kebab = String::new();
    for character in name.chars() {
        if character.is_uppercase() && !kebab.is_empty() {
            kebab.push('-');
        }
        kebab.extend(character.to_lowercase());
    }
    kebab
}

/// What a source tag means.
pub(super) fn meaning(tag: &str) -> &'static str {
    match tag.chars().next() {
        Some('S') => "read in this source",
        Some('K') => "known from well-known manuals, not read again",
        Some('I') => "derived from the geometry",
        Some('D') => "decided by this project: sources are silent or disagree",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_values_of_a_parameter_name_the_clauses_that_describe_them() {
        assert_eq!(described_by("TRC-CORNER-08"), ["outer-corner"]);
        assert_eq!(described_by("TRC-START-06"), ["start-up", "start-up-b"]);
        assert!(described_by("TRC-PLANE-02").is_empty());
    }
}
