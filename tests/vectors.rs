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
