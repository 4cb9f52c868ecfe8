//! Lemmas and harnesses: what `proofs/` says of itself.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

use super::citations::{Citation, files, read};

/// A harness for Kani.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Harness {
    /// Its name.
    pub name: String,
    /// The bound, as `proofs/README.md` states it.
    pub bound: String,
    /// The module of its property, whose citations are its own.
    #[serde(skip)]
    module: String,
}

impl Harness {
    /// Whether its module is among the places that cite a clause.
    pub(super) fn covers(&self, citations: &[Citation]) -> bool {
        let in_module = |file: &str| {
            let rest = file.strip_prefix("proofs/src/").unwrap_or(file);
            rest.split(['/', '.']).next() == Some(self.module.as_str())
        };
        citations.iter().any(|citation| in_module(&citation.file))
    }
}

/// Each lemma with the clauses that its header names.
pub(super) fn lemmas(root: &Path) -> Result<BTreeMap<String, Vec<String>>, String> {
    let mut lemmas = BTreeMap::new();
    for path in files(&root.join("proofs/lemmas"), &["smt2"])? {
        let text = read(&path)?;
        let clauses = text.lines().find_map(|line| line.strip_prefix("; Clauses: ")).unwrap_or_default();
        let ids = clauses.split(", ").map(|id| id.trim().trim_matches(['[', ']']).to_owned()).collect();
        let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        lemmas.insert(name, ids);
    }
    Ok(lemmas)
}

/// The harnesses that `proofs/src/harnesses.rs` declares, a line each, with the bounds of the table in the README.
pub(super) fn harnesses(root: &Path) -> Result<Vec<Harness>, String> {
    let source = read(&root.join("proofs/src/harnesses.rs"))?;
    let readme = read(&root.join("proofs/README.md"))?;
    let bound = |name: &str| {
        let row = readme.lines().find(|line| line.starts_with(&format!("| `{name}` |")))?;
        Some(row.split('|').nth(3)?.trim().to_owned())
    };
    let declared = source.split_once("\nproofs! {\n").map_or("", |(_, list)| list);
    let mut harnesses = Vec::new();
    for line in declared.lines() {
        let Some((name, rest)) = line.trim().split_once(": ") else { continue };
        let Some((before, _)) = rest.split_once("::") else { continue };
        let module = before.rsplit(|character: char| !(character.is_alphanumeric() || character == '_')).next();
        let bound = bound(name).ok_or_else(|| format!("proofs/README.md has no row for the harness {name}"))?;
        harnesses.push(Harness { name: name.to_owned(), bound, module: module.unwrap_or_default().to_owned() });
    }
    Ok(harnesses)
}
