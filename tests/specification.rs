//! The specification hangs together: clauses, code, vectors and the table of the seed documents name each other.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use radcomp::vectors;
use radcomp_spec::AlarmKind;
use radcomp_spec::catalogue::Catalogue;
use radcomp_spec::clause;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every Rust file below a folder, as one text.
fn sources(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).expect("a folder of this repository") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            text += &sources(&path);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text += &fs::read_to_string(&path).expect("a source file");
        }
    }
    text
}

/// Clauses that are the program reader's, so that model and implementation only see what they lead to.
const OF_THE_READER: [&str; 7] =
    ["TRC-PLANE-01", "TRC-PLANE-03", "TRC-PLANE-05", "TRC-DUMMY-05", "TRC-CANCEL-07", "TRC-TIP-02", "TRC-MODE-09"];

/// Clauses of warnings alone, which the implementation does not give.
const OF_ADVISORIES: [&str; 3] = ["TRC-LOOK-06", "TRC-DUMMY-03", "TRC-WEDGE-01"];

/// Clauses of the tip, which the implementation does not follow: it gives the path of the nose centre.
const OF_THE_TIP: [&str; 2] = ["TRC-TIP-01", "TRC-TIP-03"];

/// Clauses that a text cites neither by id nor by the alarm that is theirs.
fn uncited(text: &str, exempt: &[&str]) -> Vec<&'static str> {
    let by_alarm = |id: &str| {
        let of_clause = AlarmKind::ALL.iter().filter(|kind| kind.clause().id() == id);
        of_clause.into_iter().any(|kind| text.contains(&format!("AlarmKind::{kind:?}")))
    };
    let cited = |id: &str| text.contains(&format!("[{id}]")) || text.contains(&id.replace('-', "_")) || by_alarm(id);
    let exempt = |id: &str| OF_THE_READER.contains(&id) || exempt.contains(&id);
    clause::ALL.iter().map(|(clause, _)| clause.id()).filter(|id| !exempt(id) && !cited(id)).collect()
}

#[test]
fn every_clause_is_cited_by_the_model() {
    assert_eq!(uncited(&sources(&root().join("model/src")), &[]), Vec::<&str>::new());
}

#[test]
fn every_clause_is_cited_by_the_implementation() {
    assert_eq!(
        uncited(&sources(&root().join("impl/src")), &[&OF_ADVISORIES[..], &OF_THE_TIP].concat()),
        Vec::<&str>::new()
    );
}

#[test]
fn citations_in_code_name_clauses_that_exist() {
    let known: BTreeSet<_> = clause::ALL.iter().map(|(clause, _)| clause.id()).collect();
    for folder in ["spec/src", "model/src", "impl/src", "src"] {
        for citation in sources(&root().join(folder)).split("[TRC-").skip(1) {
            let Some((id, _)) = citation.split_once(']') else { continue };
            let is_id = id.len() < 16 && id.ends_with(|last: char| last.is_ascii_digit());
            // Test texts may hold made-up ids such as NONE-01.
            let made_up = id.starts_with("NONE");
            assert!(!is_id || made_up || known.contains(format!("TRC-{id}").as_str()), "{folder} cites [TRC-{id}]");
        }
    }
}

#[test]
fn every_clause_has_a_worked_example() {
    let without: Vec<_> = Catalogue::builtin()
        .clauses
        .iter()
        .filter(|text| text.examples.is_empty())
        .map(|text| text.clause.id())
        .collect();
    assert_eq!(without, Vec::<&str>::new());
}

#[test]
fn the_table_of_the_seed_documents_names_clauses_and_vectors_that_exist() {
    let table = fs::read_to_string(root().join("spec/SEEDS.md")).expect("spec/SEEDS.md");
    let names: BTreeSet<_> = vectors::all().iter().flatten().map(|vector| vector.name.as_str()).collect();
    let mut rows = 0;
    for row in
        table.lines().filter(|line| line.starts_with('|') && !line.contains("---") && !line.contains("| clauses |"))
    {
        let cells: Vec<_> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [sentence, clauses, tests] = cells[..] else { panic!("three cells: {row}") };
        assert!(!sentence.is_empty());
        let mut ids =
            clauses.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-')).filter(|id| id.starts_with("TRC-"));
        assert!(ids.clone().next().is_some(), "no clause: {row}");
        assert!(ids.all(|id| Catalogue::builtin().find(id).is_some()), "an unknown clause: {row}");
        let first = tests.split(", ").next().unwrap_or("");
        assert!(!first.is_empty(), "no test: {row}");
        for test in tests.split(", ") {
            let base = test.split(['#', ' ']).next().unwrap_or("");
            let known = base.is_empty() || names.contains(base) || Catalogue::builtin().find(base).is_some();
            assert!(known, "no vector {test}: {row}");
        }
        rows += 1;
    }
    assert!(rows >= 30, "{rows} rows");
}

#[test]
fn normative_changes_are_recorded() {
    let changes = fs::read_to_string(root().join("spec/CHANGES.md")).expect("spec/CHANGES.md");
    assert!(changes.contains(env!("CARGO_PKG_VERSION")), "spec/CHANGES.md has no entry for this version");
}
