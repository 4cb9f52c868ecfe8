//! Runs the cases of `tests/gcode/*.toml`.

use std::path::Path;

use radcomp_spec::profile::Profile;
use serde::Deserialize;

use super::{describe, tools};
use crate::gcode::{Diagnostic, Reader, Tools};

/// A file of cases.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    case: Vec<Case>,
}

/// A program, or a tool table if it says so, with what it reads as.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    /// What is shown.
    name: String,
    /// The profile, a built-in one.
    #[serde(default = "mill")]
    profile: String,
    /// Lines that make a profile of one's own, which extends the profile.
    #[serde(default)]
    changes: String,
    /// Blocks with `/` are skipped.
    #[serde(default)]
    skip_deleted: bool,
    /// The text is a tool table.
    #[serde(default)]
    table: bool,
    /// The program.
    text: String,
    /// Its blocks, up to a fault if there is one; of a tool table `number radius`.
    #[serde(default)]
    blocks: Vec<String>,
    /// The fault: `line:column+length title [clause]`.
    error: Option<String>,
    /// The fault as drawn.
    drawn: Option<String>,
}

fn mill() -> String {
    "seed-mill".to_owned()
}

fn run(case: &Case) -> (Vec<String>, Option<Diagnostic>) {
    if case.table {
        return match Tools::parse(&case.text, "tools.toml") {
            Ok(tools) => (tools.to_toml().unwrap().lines().map(str::to_owned).collect(), None),
            Err(fault) => (Vec::new(), Some(fault)),
        };
    }
    let mut profile = Profile::builtin(&case.profile).unwrap();
    if !case.changes.is_empty() {
        let extends = &case.profile;
        let text = format!("name = \"own\"\ntitle = \"own\"\nextends = \"{extends}\"\n{}", case.changes);
        profile = Profile::parse(&text, "own.toml").unwrap();
    }
    let tools = tools();
    let (mut blocks, mut fault) = (Vec::new(), None);
    for read in Reader::new("part.nc", case.text.as_bytes(), &profile, &tools).skip_deleted(case.skip_deleted) {
        assert!(fault.is_none(), "the reader goes on after a fault");
        match read {
            Ok(block) => blocks.push(describe(&block)),
            Err(diagnostic) => fault = Some(diagnostic),
        }
    }
    (blocks, fault)
}

/// The differences between what a case says and what happens; empty if there are none.
fn differences(case: &Case) -> String {
    let (blocks, fault) = run(case);
    let place = |fault: &Diagnostic| {
        let clause = fault.clause.map(|clause| format!(" [{clause}]")).unwrap_or_default();
        format!("{}:{}+{} {}{clause}", fault.line, fault.column, fault.length, fault.kind.title())
    };
    let mut text = String::new();
    if blocks != case.blocks {
        text += &format!("  blocks {blocks:#?}\n");
    }
    if fault.as_ref().map(place) != case.error {
        text += &format!("  error = {:?}\n", fault.as_ref().map(place));
        text += &fault.as_ref().map(Diagnostic::to_string).unwrap_or_default();
    }
    if let (Some(drawn), Some(fault)) = (&case.drawn, &fault)
        && fault.to_string().trim_end() != drawn.trim_end()
    {
        text += &format!("{fault}\n");
    }
    text
}

#[test]
fn programs_read_as_their_cases_say() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/gcode");
    let mut files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty());
    let mut report = String::new();
    for file in files.iter().filter(|file| file.extension().is_some_and(|extension| extension == "toml")) {
        let text = std::fs::read_to_string(file).unwrap();
        let cases: Cases = toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        for case in &cases.case {
            let differences = differences(case);
            if !differences.is_empty() {
                report += &format!("{}: {}\n{differences}\n", file.display(), case.name);
            }
        }
    }
    assert!(report.is_empty(), "\n{report}");
}
