//! The page `spec/PARAMETERS.md`, made from the table of parameters and the built-in profiles.

use std::fmt::Write;
use std::path::Path;

use super::{BUILTIN, PARAMETERS, Profile};

fn page() -> String {
    let profiles: Vec<Profile> = BUILTIN.iter().filter_map(|(name, _)| Profile::builtin(name)).collect();
    let mut page = String::from(
        "# The parameters of a profile\n\n\
         Made from `spec/src/profile/table.rs` and the built-in profiles by `RADCOMP_BLESS=1 cargo test -p radcomp-spec\n\
         --features std`: do not edit. Source tags: S read in that source, K known from well-known manuals, I derived,\n\
         D decided by this project.\n",
    );
    let mut table = "";
    for parameter in PARAMETERS {
        if parameter.table() != table {
            table = parameter.table();
            writeln!(page, "\n## {table}\n").unwrap();
            let names: Vec<&str> = profiles.iter().map(|profile| profile.name.as_str()).collect();
            writeln!(page, "| parameter | meaning | values | clause | {} |", names.join(" | ")).unwrap();
            writeln!(page, "|---|---|---|---|{}", "---|".repeat(names.len())).unwrap();
        }
        let (name, allowed) = (parameter.name(), parameter.allowed().replace('"', "`"));
        write!(page, "| `{name}` | {} | {allowed} | {} |", parameter.meaning, parameter.clause).unwrap();
        for profile in &profiles {
            let entry = profile.provenance_of(parameter.key).unwrap();
            write!(page, " `{}` ({}) |", entry.value, entry.source).unwrap();
        }
        page.push('\n');
    }
    page
}

#[test]
fn the_page_on_disk_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("PARAMETERS.md");
    if std::env::var_os("RADCOMP_BLESS").is_some_and(|value| value == "1") {
        std::fs::write(&path, page()).unwrap();
    }
    let on_disk = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(on_disk == page(), "spec/PARAMETERS.md is stale: run the tests once with RADCOMP_BLESS=1");
}
