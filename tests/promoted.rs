//! Findings of fuzzing that became tests: programs that the built-in device once failed on, or came near to. Each file
//! tells its story; `radcomp promote` writes it.

use radcomp::device::Builtin;
use radcomp::judge::{Budget, Grade, judge};
use radcomp::vectors::Vector;

#[test]
fn no_promoted_program_is_red() {
    let mut judged = 0;
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/promoted")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.display();
        let vector: Vector =
            toml::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(!vector.story.is_empty() && vector.story != "To be told.", "{name} has no story");
        let profile = vector.profile().unwrap();
        let program = vector.read(&profile).unwrap().unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let blocks: Vec<_> = program.blocks.into_iter().map(|read| read.block).collect();
        let budget = Budget { grade: Grade::Binary64, least_increment: 0.001, delta: 1e-6 };
        let verdict = judge(&mut Builtin, &profile.parameters, &blocks, &budget).verdict;
        assert!(!verdict.is_red(), "{name}: {verdict:?}");
        judged += 1;
    }
    assert!(judged > 0, "there is nothing in tests/promoted");
}
