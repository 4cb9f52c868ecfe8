//! `radcomp explain` on the programs of the seed documents names, for each of them, the clauses that the vector expects.

use std::fs;

use assert_cmd::Command;
use radcomp::vectors;

#[test]
fn explain_names_the_clauses_of_the_seed_documents() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut explained = 0;
    for vector in vectors::all().iter().flatten() {
        // Worked examples of clauses have no story; vectors that change a parameter run under no named profile.
        if vector.story.is_empty() || !vector.set.is_empty() {
            continue;
        }
        let (program, tools) = (folder.path().join("program.nc"), folder.path().join("tools.toml"));
        fs::write(&program, &vector.program).expect("a writable folder");
        let radius = vector.radius.as_deref().unwrap_or("0");
        let mut table = format!("[[tool]]\nnumber = 1\nradius = \"{radius}\"\n");
        for (number, radius) in &vector.tools {
            table += &format!("[[tool]]\nnumber = {number}\nradius = \"{radius}\"\n");
        }
        fs::write(&tools, table).expect("a writable folder");
        let mut command = Command::cargo_bin("radcomp").expect("the command");
        command.arg("explain").arg(&program).args(["--profile", &vector.profile, "--tools"]).arg(&tools);
        let output = command.output().expect("the command runs");
        let text = String::from_utf8(output.stdout).expect("text") + &String::from_utf8_lossy(&output.stderr);
        let code = output.status.code();
        match (&vector.error, &vector.alarm) {
            (Some(error), _) => {
                let part = error.split_once(':').map_or("", |(_, part)| part.trim());
                assert_eq!(code, Some(2), "{}: {text}", vector.name);
                assert!(text.contains(part), "{}: no `{part}` in\n{text}", vector.name);
            }
            (None, Some(alarm)) => {
                assert_eq!(code, Some(1), "{}: {text}", vector.name);
                let kind = alarm.split(' ').nth(1).unwrap_or("");
                assert!(text.contains(kind), "{}: no {kind} in\n{text}", vector.name);
            }
            (None, None) => assert_eq!(code, Some(0), "{}: {text}", vector.name),
        }
        for step in &vector.path {
            let clause = step.split(' ').next_back().unwrap_or("");
            assert!(text.contains(&format!("[{clause}]")), "{}: {clause} is not named in\n{text}", vector.name);
        }
        explained += 1;
    }
    assert!(explained >= 25, "{explained} programs");
}
