//! Every worked example of the specification, every vector, and those of `rules.toml`, run through the model alone and met exactly.
//!
//! The reader of programs here is small: it knows the words of the examples, in millimetres, and refuses nothing. What
//! the project's own program reader refuses is that reader's to test.

mod example;
mod expect;
mod reader;

use example::Example;
use radcomp_model::run;
use radcomp_spec::catalogue::Catalogue;

/// Every example with a name for messages.
fn all() -> Vec<(String, Example)> {
    let mut examples = Vec::new();
    for clause in &Catalogue::builtin().clauses {
        for example in &clause.examples {
            let name = format!("{} line {}: {}", clause.clause, example.line, example.caption);
            examples.push((name, Example::read(example.text)));
        }
    }
    examples.extend(example::vectors(include_str!("rules.toml")));
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/vectors");
    for entry in std::fs::read_dir(folder).expect("the folder of vectors") {
        let path = entry.expect("a readable entry").path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            let text = std::fs::read_to_string(&path).expect("a readable vector file");
            examples.extend(example::vectors(&text));
        }
    }
    examples
}

#[test]
fn every_example_is_met_exactly() {
    let (mut failures, mut met, mut refused) = (Vec::new(), 0, 0);
    for (name, example) in all() {
        if example.error.is_some() {
            // The program reader refuses it; no block reaches the model.
            refused += 1;
            continue;
        }
        let profile = example.profile();
        let program = reader::read(&example, &profile);
        let outcome = run(&profile.parameters, &program.blocks);
        let faults = expect::faults(&example, &profile, &program.lines, &outcome);
        if faults.is_empty() {
            met += 1;
        } else {
            failures.push(format!("{name}\n    {}", faults.join("\n    ")));
        }
    }
    println!("{met} examples met, {refused} that the program reader refuses");
    assert!(failures.is_empty(), "{} not met, {met} met:\n{}", failures.len(), failures.join("\n"));
    assert!(met > 300, "only {met} examples were found");
}
