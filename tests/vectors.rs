//! Every vector and every worked example of a clause, run through reader and model; the numbers were worked out by
//! hand from the clauses, and must be met exactly.

use radcomp::vectors;

#[test]
fn vectors_and_worked_examples_hold_exactly() {
    let mut failures = Vec::new();
    for vector in vectors::all() {
        match vector {
            Err(fault) => failures.push(fault.clone()),
            Ok(vector) => {
                if let Some(mismatch) = vectors::mismatch(vector) {
                    failures.push(format!("{}: {mismatch}", vector.name));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), vectors::all().len(), failures.join("\n"));
}

/// A file that is not listed would be tested here and there, and certify nothing.
#[test]
fn every_file_of_vectors_is_among_them() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/vectors");
    for file in std::fs::read_dir(folder).expect("the folder is there") {
        let path = file.expect("a file").path();
        let text = std::fs::read_to_string(&path).expect("a text");
        let name =
            text.lines().find_map(|line| line.strip_prefix("name = ")).expect("a vector has a name").trim_matches('"');
        assert!(vectors::all().iter().flatten().any(|vector| vector.name == name), "{}", path.display());
    }
}
