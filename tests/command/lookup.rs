//! `radcomp profiles`, `radcomp clause`, `radcomp completions`, and the command's own help.

use super::{complaint, printed, radcomp};

#[test]
fn profiles_are_listed() {
    let text = printed(radcomp(&["profiles"]));
    let names: Vec<&str> = text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let known: Vec<&str> = radcomp_spec::profile::BUILTIN.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, known);
}

#[test]
fn a_profile_shows_every_parameter_with_its_source_and_clause() {
    let text = printed(radcomp(&["profiles", "yasnac-lx"]));
    let row = text.lines().find(|line| line.starts_with("compensation.non-moving-allowed")).unwrap();
    let words: Vec<&str> = row.split_whitespace().collect();
    assert_eq!(words[1..4], ["2", "S:seed003", "TRC-LOOK-02"]);
    let (alarms, rows): (Vec<&str>, Vec<&str>) =
        text.lines().filter(|line| line.contains("TRC-")).partition(|line| line.starts_with("alarm "));
    assert_eq!(rows.len(), radcomp_spec::profile::PARAMETERS.len());
    assert_eq!(alarms.len(), radcomp_spec::AlarmKind::ALL.len());
    let text = printed(radcomp(&["profiles", "haas-b"]));
    assert!(text.lines().any(|line| line.starts_with("alarm arc-at-cancel") && line.ends_with("341 (K)")), "{text}");
}

#[test]
fn a_profile_file_is_shown_and_used() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let text = "name = \"mine\"\ntitle = \"T\"\nextends = \"seed-mill\"\n[compensation]\n\
                outer-corner = { value = \"arc\", source = \"D\", clause = \"TRC-CORNER-11\" }\n";
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap();
    assert!(printed(radcomp(&["profiles", path])).starts_with("mine\nT\n"));
    let path_of = printed(radcomp(&["run", "examples/first.nc", "-p", path, "-r", "5"]));
    assert!(path_of.contains("TRC-CORNER-10"), "{path_of}");
    std::fs::write(path, "name = \"mine\"\ntitle = 5\n").unwrap();
    let complaint = complaint(radcomp(&["profiles", path]), 2);
    assert!(complaint.contains("profile not understood") && complaint.contains("mine.toml"), "{complaint}");
}

#[test]
fn a_clause_is_shown_with_its_source_and_examples() {
    for id in ["TRC-CORNER-08", "trc-corner-08", "corner-08", "[TRC-CORNER-08]"] {
        let text = printed(radcomp(&["clause", id]));
        assert!(text.starts_with("[TRC-CORNER-08] Outer acute corner: squared off\n"), "{text}");
        for part in ["Source: K, S:FLT p.253", "spec/clauses/04-corner.md", "Example 1", "profile = \"seed-mill\""] {
            assert!(text.contains(part), "{part} is not in:\n{text}");
        }
    }
}

#[test]
fn clauses_are_listed_and_near_ones_suggested() {
    let text = printed(radcomp(&["clause"]));
    for (clause, title) in radcomp_spec::clause::ALL {
        assert!(text.lines().any(|line| line.contains(clause.id()) && line.contains(title)), "{clause}");
    }
    let complaint = complaint(radcomp(&["clause", "TRC-CORNR-8"]), 2);
    assert!(complaint.contains("there is no clause TRC-CORNR-8; did you mean TRC-CORNER-08"), "{complaint}");
}

#[test]
fn completions_name_the_subcommands() {
    for shell in ["bash", "zsh", "fish"] {
        let script = printed(radcomp(&["completions", shell]));
        assert!(script.contains("explain") && script.contains("profiles"), "{shell}");
    }
    complaint(radcomp(&["completions", "no-shell"]), 2);
}

#[test]
fn help_and_version_are_conventional() {
    assert_eq!(printed(radcomp(&["--version"])), format!("radcomp {}\n", env!("CARGO_PKG_VERSION")));
    assert!(printed(radcomp(&["--help"])).contains("Exit status: 0"));
    assert!(complaint(radcomp(&[]), 2).contains("Usage: radcomp"));
    assert!(complaint(radcomp(&["runn"]), 2).contains("similar subcommand"));
    assert!(complaint(radcomp(&["run", "a.nc"]), 2).contains("--profile"));
}
