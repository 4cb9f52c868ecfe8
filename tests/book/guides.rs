//! The commands of the guides that are marked `sh run` are run, in the order of each guide, in a folder of its own.
//!
//! A command ends with status 0; one that is to end otherwise has the comment `# exit 1`.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The lines of a guide's `sh run` blocks, with the status that each is to end with.
fn commands(text: &str) -> Vec<(String, i32)> {
    let mut commands = Vec::new();
    for block in text.split("```sh run\n").skip(1) {
        for line in block.split("```").next().unwrap_or_default().lines().filter(|line| !line.trim().is_empty()) {
            let (command, status) = line.split_once("# exit ").unwrap_or((line, "0"));
            commands.push((command.trim().to_owned(), status.trim().parse().unwrap()));
        }
    }
    commands
}

#[test]
fn the_commands_of_the_guides_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let binaries = Path::new(env!("CARGO_BIN_EXE_radcomp")).parent().unwrap();
    let path = format!("{}:{}", binaries.display(), std::env::var("PATH").unwrap_or_default());
    let mut count = 0;
    for guide in ["readers.md", "vendors.md", "contributors.md"] {
        let text = fs::read_to_string(root.join("spec/guides").join(guide)).unwrap();
        let folder = tempfile::tempdir().unwrap();
        // The guides speak from the root of the repository; what they write goes elsewhere.
        for part in ["examples", "spec", "model", "impl", "src", "tests", "proofs", "fuzz", "README.md"] {
            std::os::unix::fs::symlink(root.join(part), folder.path().join(part)).unwrap();
        }
        for (command, status) in commands(&text) {
            let output =
                Command::new("bash").args(["-c", &command]).current_dir(folder.path()).env("PATH", &path).output();
            let output = output.unwrap();
            let told = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(status), "{guide}: {command}\n{told}");
            count += 1;
        }
    }
    println!("{count} commands of the guides ran");
    assert!(count > 10, "{count} commands");
}
