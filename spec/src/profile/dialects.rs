//! The page `spec/DIALECTS.md`: how the built-in profiles differ, made from them.

use std::fmt::Write;
use std::path::Path;

use super::{AlarmNumber, BUILTIN, Profile, Provenance};
use crate::outcome::AlarmKind;

/// The rows of the page: what people ask of a control, and the parameters that answer.
const ROWS: &[(&str, &[&str])] = &[
    ("arc as entry", &["start-up-arc"]),
    ("start-up", &["start-up", "start-up-b", "start-up-without-movement"]),
    ("start-up without a next element", &["start-up-lost"]),
    ("cancel", &["cancel", "cancel-without-movement"]),
    ("outer corner", &["outer-corner", "arc-extension"]),
    ("who owns the corner", &["corner-owner"]),
    ("reversal", &["reversal"]),
    ("side change", &["side-change", "side-change-after-start-up"]),
    ("the same code again", &["same-code"]),
    ("blocks without movement", &["non-moving-allowed", "zero-length-move"]),
    ("dummy block", &["dummy"]),
    ("G38 and G39", &["vector-codes"]),
    ("I, J, K beside G41 and G42", &["side-code-vector"]),
    ("I, J, K beside G40", &["cancel-vector"]),
    ("offset value changed in mode", &["offset-change"]),
    ("path run backwards", &["reversed-path"]),
    ("interference", &["interference", "interference-blocks"]),
    ("arc radius equal to the tool's", &["equal-radius"]),
    ("negative radius", &["negative-radius"]),
    ("offset 0", &["offset-zero"]),
    ("plane change in mode", &["plane-change"]),
    ("reference return in mode", &["reference-return"]),
    ("tool change in mode", &["tool-change"]),
    ("canned cycle in mode", &["canned-cycle"]),
];

fn page() -> String {
    let profiles: Vec<Profile> = BUILTIN.iter().filter_map(|(name, _)| Profile::builtin(name)).collect();
    let mut page = String::from(
        "# How the controls differ\n\n\
         Made from the built-in profiles by `RADCOMP_BLESS=1 cargo test -p radcomp-spec --features std`: do not edit.\n\
         `PARAMETERS.md` says what each value means, which sources it has, and which clause. Source tags: S read in a\n\
         source, K known from well-known manuals, I derived, D decided by this project.\n\n## Rules\n\n",
    );
    let names: Vec<&str> = profiles.iter().map(|profile| profile.name.as_str()).collect();
    writeln!(page, "| rule | {} |\n|---|{}", names.join(" | "), "---|".repeat(names.len())).unwrap();
    for (rule, parameters) in ROWS {
        write!(page, "| {rule} |").unwrap();
        for profile in &profiles {
            let cells: Vec<String> = parameters.iter().map(|name| cell(entry(profile, name))).collect();
            write!(page, " {} |", cells.join(", ")).unwrap();
        }
        page.push('\n');
    }
    page += "\n## Alarms\n\n";
    writeln!(page, "| alarm | {} |\n|---|{}", names.join(" | "), "---|".repeat(names.len())).unwrap();
    for kind in AlarmKind::ALL {
        write!(page, "| `{}` |", kind.id()).unwrap();
        for profile in &profiles {
            let alarm = profile.alarms.iter().find(|alarm| alarm.kind == *kind).unwrap();
            match alarm {
                AlarmNumber { number: Some(number), source, .. } => {
                    write!(page, " {number} {} |", tags(source)).unwrap()
                }
                AlarmNumber { number: None, .. } => page += " – |",
            }
        }
        page.push('\n');
    }
    page
}

/// The value of the parameter of this name, in whatever table.
fn entry<'a>(profile: &'a Profile, name: &str) -> &'a Provenance {
    profile.provenance.iter().find(|entry| entry.parameter.split('.').nth(1) == Some(name)).unwrap()
}

fn cell(entry: &Provenance) -> String {
    format!("`{}` {}", entry.value, tags(&entry.source))
}

/// The letters of the source tags alone.
fn tags(source: &str) -> String {
    let mut tags = String::new();
    for tag in source.split(',').filter_map(|tag| tag.trim().chars().next()).filter(|tag| "SKID".contains(*tag)) {
        if !tags.contains(tag) {
            tags.push(tag);
        }
    }
    tags
}

#[test]
fn the_page_on_disk_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("DIALECTS.md");
    if std::env::var_os("RADCOMP_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, page()).unwrap();
    }
    let on_disk = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(on_disk == page(), "spec/DIALECTS.md is stale: run the tests once with RADCOMP_BLESS=1");
}
