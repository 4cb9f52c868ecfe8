//! The page of the evidence.

use std::collections::BTreeMap;

use minijinja::context;

use super::site::Site;
use crate::evidence::{Closest, EXCUSES, Ledger, Row};

/// Adds the page.
pub(super) fn page(site: &mut Site<'_>, ledger: &Ledger) -> Result<(), String> {
    let target = |row: &Row| (row.clause, site.links().clause(row.clause).unwrap_or_default().to_owned());
    let targets: BTreeMap<_, _> = ledger.rows.iter().map(target).collect();
    let excuses: Vec<_> = EXCUSES
        .iter()
        .map(|excuse| BTreeMap::from([("clause", excuse.clause), ("lacks", excuse.lacks), ("reason", excuse.reason)]))
        .collect();
    site.page("ledger.html", "The evidence ledger", "ledger.html", context! { ledger, targets, excuses })
}

impl Ledger {
    /// A clause's row in a few words; empty if there is no such clause.
    pub(super) fn summary(&self, id: &str) -> String {
        let Some(row) = self.row(id) else { return String::new() };
        let many = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
        let mut parts = vec![
            many(row.model.len() + row.reader.len() + row.implementation.len(), "place") + " in code",
            many(row.exercise.examples + row.exercise.other_examples, "example"),
            many(row.exercise.vectors.len(), "vector"),
        ];
        if !row.lemmas.is_empty() {
            parts.push(many(row.lemmas.len(), "lemma"));
        }
        let both = |closest: &Closest| closest.below.is_some() && closest.above.is_some();
        if row.exercise.decisions.iter().any(both) {
            parts.push("both sides of a boundary".to_owned());
        }
        parts.join(", ")
    }
}
