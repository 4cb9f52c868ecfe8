//! The evidence for each clause, gathered from the sources, the proofs, the examples and a campaign's report: one row a
//! clause.
//!
//! Nothing is kept by hand. Functions and tests are those that cite the clause (`[TRC-…]`, `TRC_…`, or an alarm, advisory
//! or decision that is the clause's); examples and vectors count where the exact model, running them, uses it.

mod citations;
mod exercise;
mod gaps;
mod lock;
mod proofs;

use std::fs;
use std::path::Path;

use radcomp_spec::catalogue::Catalogue;
use serde::Serialize;

use crate::report::{Report, sha256};

pub use citations::{Citation, Place, citations, unknown_citations};
pub use exercise::{Closest, Exercise};
pub use gaps::{EXCUSES, Excuse, gaps};
pub use lock::{Lock, normative_hash};
pub use proofs::Harness;

/// The ledger.
#[derive(Clone, Debug, Serialize)]
pub struct Ledger {
    /// The version of the toolkit.
    pub radcomp: &'static str,
    /// The reports that the counts of campaigns are taken from; empty: no campaign was given.
    pub campaigns: Vec<Campaign>,
    /// A row for each clause, in the order of the specification.
    pub rows: Vec<Row>,
}

/// A report that was given.
#[derive(Clone, Debug, Serialize)]
pub struct Campaign {
    /// The device.
    pub device: String,
    /// The profile.
    pub profile: String,
    /// The level, if one was run.
    pub level: Option<u8>,
    /// The seed of its programs.
    pub seed: u64,
    /// How many programs were judged.
    pub programs: u64,
    /// How many of them passed.
    pub pass: u64,
    /// The commit of the toolkit that wrote it.
    pub commit: String,
}

/// What is known of a clause.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Its id.
    pub clause: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its file, from the root of the repository, and the line of its heading.
    pub file: String,
    /// The line of its heading, from 1.
    pub line: u32,
    /// Its normative text, as Markdown.
    pub text: &'static str,
    /// SHA-256 of title and text, whatever their line breaks.
    pub sha256: String,
    /// Where it comes from, with its tags.
    pub sources: Vec<&'static str>,
    /// Functions of the model that cite it.
    pub model: Vec<Citation>,
    /// Functions of the program reader that cite it.
    pub reader: Vec<Citation>,
    /// Functions of the implementation that cite it.
    pub implementation: Vec<Citation>,
    /// Tests that cite it.
    pub tests: Vec<Citation>,
    /// What examples and vectors exercise of it.
    pub exercise: Exercise,
    /// Harnesses for Kani whose code cites it, with their bounds.
    pub harnesses: Vec<Harness>,
    /// Lemmas that name it.
    pub lemmas: Vec<String>,
    /// Programs of the campaigns that use it, and what came of them; none if no campaign was given.
    pub campaign: Option<Counts>,
    /// Differences of LinuxCNC at this clause: those that `spec/LINUXCNC.md` tells, and those of the campaigns with that
    /// device.
    pub linuxcnc: Vec<String>,
    /// Mutants of its code that the tests kill: none while nothing measures it.
    pub mutants: Option<u64>,
}

/// What campaigns counted of a clause, added up.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Counts {
    /// Programs whose exact outcome uses it.
    pub programs: u64,
    /// Of these, judged exact or admissible.
    pub passed: u64,
    /// Programs whose first divergence lies at it.
    pub failed: u64,
    /// The same, waived.
    pub expected_failures: u64,
    /// Path elements that it made.
    pub elements: u64,
    /// Decisions taken by its sentence.
    pub decisions: u64,
    /// Alarms that it raised.
    pub alarms: u64,
}

impl Ledger {
    /// Gathers the evidence in a source tree of this version, and from reports.
    ///
    /// # Errors
    ///
    /// If the folder is no source tree, or its clauses are not those that this toolkit was built with.
    pub fn gather(root: &Path, reports: &[Report]) -> Result<Ledger, String> {
        check_tree(root)?;
        let cited = citations(root)?;
        let exercises = exercise::exercises();
        let lemmas = proofs::lemmas(root)?;
        let harnesses = proofs::harnesses(root)?;
        let known = differences(root)?;
        let catalogue = Catalogue::builtin();
        let rows = catalogue.clauses.iter().map(|text| {
            let id = text.clause.id();
            let of = |place: Place| -> Vec<Citation> {
                let here = cited.iter().filter(|citation| citation.clause == id && citation.place == place);
                let mut found: Vec<Citation> = Vec::new();
                for citation in here {
                    // An item that cites a clause several times stands once.
                    if !found.iter().any(|known| known.file == citation.file && known.item == citation.item) {
                        found.push(citation.clone());
                    }
                }
                found
            };
            let in_proofs: Vec<_> = of(Place::Proofs);
            Row {
                clause: id,
                title: text.title,
                file: format!("spec/clauses/{}", catalogue.chapters[text.chapter].file),
                line: text.line,
                text: text.text,
                sha256: normative_hash(&format!("{} {}", text.title, text.text)),
                sources: text.sources.clone(),
                model: of(Place::Model),
                reader: of(Place::Reader),
                implementation: of(Place::Implementation),
                tests: of(Place::Tests),
                exercise: exercises.get(id).cloned().unwrap_or_default(),
                harnesses: harnesses.iter().filter(|harness| harness.covers(&in_proofs)).cloned().collect(),
                lemmas: lemmas
                    .iter()
                    .filter(|(_, ids)| ids.iter().any(|known| known == id))
                    .map(|(name, _)| name.clone())
                    .collect(),
                campaign: counts(id, reports),
                linuxcnc: [told(id, &known), linuxcnc(id, reports)].concat(),
                mutants: None,
            }
        });
        Ok(Ledger {
            radcomp: env!("CARGO_PKG_VERSION"),
            campaigns: reports.iter().map(campaign).collect(),
            rows: rows.collect(),
        })
    }

    /// The row of a clause.
    pub fn row(&self, id: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.clause == id)
    }
}

/// Whether a folder is the source tree that the toolkit was built from, as far as the clauses tell.
fn check_tree(root: &Path) -> Result<(), String> {
    let built = Catalogue::builtin();
    for chapter in &built.chapters {
        let path = root.join("spec/clauses").join(chapter.file);
        let text = fs::read_to_string(&path)
            .map_err(|reason| format!("{}: {reason}; --root names a source tree of radcomp", path.display()))?;
        let same = text.contains(chapter.introduction)
            && built
                .clauses
                .iter()
                .filter(|clause| built.chapters[clause.chapter].file == chapter.file)
                .all(|clause| text.contains(clause.text));
        if !same {
            let path = path.display();
            return Err(format!("{path} is not the text that this command was built with: build it again"));
        }
    }
    Ok(())
}

fn campaign(report: &Report) -> Campaign {
    Campaign {
        device: report.device.clone(),
        profile: report.profile.clone(),
        level: report.level,
        seed: report.seed,
        programs: report.tally.programs,
        pass: report.counts.pass,
        commit: report.commit.clone(),
    }
}

fn counts(id: &str, reports: &[Report]) -> Option<Counts> {
    if reports.is_empty() {
        return None;
    }
    let mut sum = Counts::default();
    for tally in reports.iter().filter_map(|report| report.tally.clauses.get(id)) {
        sum.programs += tally.programs;
        sum.passed += tally.passed;
        sum.failed += tally.failed;
        sum.expected_failures += tally.expected_failures;
        sum.elements += tally.elements;
        sum.decisions += tally.decisions;
        sum.alarms += tally.alarms;
    }
    Some(sum)
}

/// The differences of `spec/LINUXCNC.md`: the title of each, and the line of its clauses below.
fn differences(root: &Path) -> Result<Vec<(String, String)>, String> {
    let path = root.join("spec/LINUXCNC.md");
    let text = fs::read_to_string(&path).map_err(|reason| format!("{}: {reason}", path.display()))?;
    let mut lines = text.lines();
    let mut found = Vec::new();
    while let Some(line) = lines.next() {
        if let Some(title) = line.strip_prefix("## LCNC-") {
            found.push((format!("LCNC-{title}"), lines.next().unwrap_or_default().to_owned()));
        }
    }
    Ok(found)
}

/// Those of the differences that name the clause.
fn told(id: &str, differences: &[(String, String)]) -> Vec<String> {
    let here = differences.iter().filter(|(_, clauses)| clauses.contains(&format!("[{id}]")));
    here.map(|(title, _)| title.clone()).collect()
}

fn linuxcnc(id: &str, reports: &[Report]) -> Vec<String> {
    let mut differences = Vec::new();
    for report in reports.iter().filter(|report| report.device.starts_with("linuxcnc")) {
        for waiver in report.expected_failures.iter().filter(|waiver| waiver.clause.0.id() == id) {
            differences.push(format!("{} ({} programs, {})", waiver.reason, waiver.programs, report.profile));
        }
        let failed = report.tally.clauses.get(id).map_or(0, |tally| tally.failed);
        if failed > 0 {
            differences.push(format!("{failed} programs differ first at this clause ({})", report.profile));
        }
    }
    differences
}

/// The hash of words, whatever stands between them.
fn hash_of_words(text: &str) -> String {
    sha256(text.split_whitespace().collect::<Vec<_>>().join(" ").as_bytes())
}
