//! Runs z3 on every lemma. A lemma denies its claim, and z3 must find that denial unsatisfiable: the claim holds for all
//! reals. Two checks keep it from holding for want of a model: its assumptions alone must be satisfiable, and its twin,
//! the same file with one mutation that its header names, must be refuted by a model.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The most that z3 may take for one question, in seconds; each takes well under one.
const LIMIT: u32 = 60;

/// Where the denied claim begins.
const CLAIM: &str = "(assert (not\n";

#[test]
fn every_lemma_holds_and_every_twin_is_refuted() {
    let mut slowest = (Duration::ZERO, String::new());
    let lemmas = lemmas();
    for (name, text) in &lemmas {
        let start = Instant::now();
        let (old, new) = twin(name, text);
        let (assumptions, _) = text.split_once(CLAIM).unwrap_or_else(|| panic!("{name}: no line {CLAIM:?}"));
        assert_eq!(z3(name, text), "unsat", "{name}: the lemma does not hold");
        assert_eq!(z3(name, &format!("{assumptions}(check-sat)\n")), "sat", "{name}: its assumptions contradict");
        assert_eq!(z3(name, &logic(text).replace(old, new)), "sat", "{name}: its twin is not refuted");
        slowest = slowest.max((start.elapsed(), name.clone()));
    }
    println!("{} lemmas hold, and as many twins are refuted; the slowest: {slowest:?}", lemmas.len());
    assert!(lemmas.len() >= 65, "the folder of lemmas has shrunk: {}", lemmas.len());
}

#[test]
fn every_lemma_names_clauses_of_the_specification() {
    for (name, text) in lemmas() {
        let line = header(&name, &text, "Clauses");
        assert!(!line.is_empty());
        for id in line.split(", ") {
            let id = id.trim_start_matches('[').trim_end_matches(']');
            assert!(radcomp_spec::clause::ALL.iter().any(|(clause, _)| clause.id() == id), "{name}: {id}");
        }
    }
}

#[test]
fn the_readme_lists_every_lemma() {
    let readme = fs::read_to_string(folder().join("README.md")).unwrap();
    let mut listed: Vec<_> =
        readme.lines().filter_map(|line| Some(line.strip_prefix("| `")?.split_once('`')?.0)).collect();
    listed.sort_unstable();
    assert_eq!(listed, lemmas().keys().map(String::as_str).collect::<Vec<_>>());
}

fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/lemmas"))
}

/// The lemmas by name.
fn lemmas() -> BTreeMap<String, String> {
    let files = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    files
        .filter(|path| path.extension().is_some_and(|extension| extension == "smt2"))
        .map(|path| (path.file_stem().unwrap().to_string_lossy().into_owned(), fs::read_to_string(&path).unwrap()))
        .collect()
}

/// A line of the header.
fn header<'a>(name: &str, text: &'a str, key: &str) -> &'a str {
    let lines = text.lines().filter_map(|line| line.strip_prefix("; ")?.strip_prefix(key)?.strip_prefix(':'));
    let mut lines = lines.map(str::trim);
    let line = lines.next().unwrap_or_else(|| panic!("{name}: no line `; {key}:`"));
    assert_eq!(lines.next(), None, "{name}: `; {key}:` twice");
    line
}

/// The mutation: what it replaces, which stands once in the logic, and by what.
fn twin<'a>(name: &str, text: &'a str) -> (&'a str, &'a str) {
    let (old, new) = (header(name, text, "Twin replaces"), header(name, text, "Twin has"));
    assert_eq!(logic(text).matches(old).count(), 1, "{name}: the twin replaces a text that stands once");
    assert_ne!(old, new, "{name}");
    (old, new)
}

/// The text without its header.
fn logic(text: &str) -> String {
    text.lines().filter(|line| !line.starts_with(';')).fold(String::new(), |all, line| all + line + "\n")
}

/// What z3 prints: `sat`, `unsat`, `unknown`, `timeout`, or errors.
fn z3(name: &str, question: &str) -> String {
    let run = Command::new("z3")
        .args([&format!("-T:{LIMIT}"), "-in"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .and_then(|mut z3| {
            z3.stdin.take().expect("its standard input is a pipe").write_all(question.as_bytes())?;
            z3.wait_with_output()
        });
    let output =
        run.unwrap_or_else(|error| panic!("{name}: z3 does not run ({error}); scripts/setup --test installs it"));
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}
