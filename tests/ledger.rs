//! The evidence ledger has no holes: every clause has code, a test and an example, every citation names a clause, and the
//! normative text changes only together with a line of `spec/CHANGES.md`.
//!
//! `RADCOMP_BLESS=1 cargo test --release --test ledger` agrees to a changed text that `spec/CHANGES.md` names.

use std::path::Path;
use std::sync::LazyLock;
use std::{env, fs};

use radcomp::evidence::{EXCUSES, Ledger, Lock, gaps, unknown_citations};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

static LEDGER: LazyLock<Ledger> = LazyLock::new(|| Ledger::gather(root(), &[]).unwrap());

#[test]
fn no_clause_lacks_code_a_test_or_an_example() {
    assert_eq!(gaps(&LEDGER), Vec::<String>::new());
    for excuse in EXCUSES {
        assert!(!excuse.reason.is_empty(), "{excuse:?}");
    }
}

#[test]
fn a_gap_is_found() {
    let mut ledger = LEDGER.clone();
    let row = |id: &str| ledger.rows.iter().position(|row| row.clause == id).unwrap();
    let [corner, mitre, squared, entry] = ["TRC-CORNER-03", "TRC-CORNER-06", "TRC-CORNER-08", "TRC-START-07"].map(row);
    ledger.rows[corner].model.clear();
    ledger.rows[mitre].implementation.clear();
    ledger.rows[squared].exercise.examples = 0;
    ledger.rows[entry].exercise.used = false;
    ledger.rows[entry].tests.clear();
    let found = gaps(&ledger);
    for lacks in [
        "has no model function",
        "has no function of the reader",
        "has no implementation",
        "has no example",
        "has no test by name",
    ] {
        assert!(found.iter().any(|gap| gap.contains(lacks)), "{lacks}: {found:?}");
    }
}

#[test]
fn every_citation_names_a_clause() {
    assert_eq!(unknown_citations(root()).unwrap(), Vec::<String>::new());
}

#[test]
fn a_citation_of_no_clause_is_found() {
    let folder = tempfile::tempdir().unwrap();
    for part in
        ["spec", "model", "impl", "src", "tests", "proofs/src", "proofs/lemmas", "proofs/tests", "fuzz/src", "examples"]
    {
        fs::create_dir_all(folder.path().join(part)).unwrap();
    }
    fs::write(folder.path().join("README.md"), "").unwrap();
    assert!(unknown_citations(folder.path()).unwrap().is_empty());
    let id = ["TRC", "NOWHERE", "07"].join("-");
    fs::write(folder.path().join("model/a.rs"), format!("// one\n// [{id}]\n")).unwrap();
    assert_eq!(unknown_citations(folder.path()).unwrap(), [format!("model/a.rs:2: {id} is no clause")]);
}

#[test]
fn the_normative_text_changes_only_with_a_line_that_says_so() {
    let file = root().join("spec/clauses.lock");
    let changes = fs::read_to_string(root().join("spec/CHANGES.md")).unwrap();
    let now = Lock::current(&changes);
    let agreed = fs::read_to_string(&file).map(|text| Lock::parse(&text).unwrap());
    if env::var_os("RADCOMP_BLESS").is_some_and(|value| value == "1") {
        // Without a file there is nothing that was agreed to.
        let unnamed = agreed.as_ref().map_or_else(|_| Vec::new(), |agreed| agreed.unnamed_changes(&now));
        assert_eq!(unnamed, Vec::<String>::new());
        fs::write(&file, now.to_text()).unwrap();
        return;
    }
    let agreed = agreed.expect("spec/clauses.lock");
    assert_eq!(agreed.unnamed_changes(&now), Vec::<String>::new());
    let differences = agreed.differences(&now);
    assert!(differences.is_empty(), "spec/CHANGES.md names these; now run with RADCOMP_BLESS=1: {differences:?}");
}

#[test]
fn what_the_ledger_gathers_is_there() {
    let row = LEDGER.row("TRC-CORNER-08").unwrap();
    assert!(row.model.iter().any(|citation| citation.file == "model/src/rules/outer.rs"), "{:?}", row.model);
    assert!(row.implementation.iter().all(|citation| citation.file.starts_with("impl/src/")));
    assert!(row.lemmas.iter().any(|lemma| lemma == "squared-off-clear"), "{:?}", row.lemmas);
    assert!(row.exercise.vectors.len() > 5 && row.campaign.is_none() && row.mutants.is_none());
    let angle = row.exercise.decisions.iter().find(|closest| closest.decision == "right-angle").unwrap();
    let (below, above) = (angle.below.as_ref().unwrap(), angle.above.as_ref().unwrap());
    assert!(below.mm < 0.0 && below.mm > -0.01 && above.mm > 0.0 && above.mm < 0.01 && angle.exactly > 0, "{angle:?}");
    let look = LEDGER.row("TRC-LOOK-02").unwrap();
    assert!(look.harnesses.iter().any(|harness| harness.name == "look_ahead_of_four_events"), "{:?}", look.harnesses);
}

#[test]
fn what_linuxcnc_does_otherwise_stands_in_the_rows_of_its_clauses() {
    let told: std::collections::BTreeSet<&str> =
        LEDGER.rows.iter().flat_map(|row| &row.linuxcnc).map(String::as_str).collect();
    let page = fs::read_to_string(root().join("spec/LINUXCNC.md")).unwrap();
    let titles: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    assert_eq!(told.into_iter().collect::<Vec<_>>(), titles);
    let row = LEDGER.row("TRC-MODE-10").unwrap();
    assert_eq!(row.linuxcnc.len(), 1, "{:?}", row.linuxcnc);
}
