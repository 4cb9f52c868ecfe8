//! The page's files, and the rules that it shows.

use std::sync::LazyLock;

use radcomp_spec::profile::{BUILTIN, Profile};
use radcomp_spec::{Clause, clause};
use serde_json::{Value, json};

use super::{MOST_BLOCKS, MOST_JUDGED};
use crate::explain::first_sentence;

/// A file of the page, with its type; none if there is no such file.
pub(super) fn file(path: &str) -> Option<(&'static str, &'static str)> {
    const HTML: &str = "text/html; charset=utf-8";
    const CSS: &str = "text/css; charset=utf-8";
    const SCRIPT: &str = "text/javascript; charset=utf-8";
    Some(match path {
        "/" => (HTML, include_str!("page/workbench.html")),
        "/workbench.css" => (CSS, include_str!("page/workbench.css")),
        "/drawing.css" => (CSS, include_str!("page/drawing.css")),
        "/workbench.js" => (SCRIPT, include_str!("page/workbench.js")),
        "/drawing.js" => (SCRIPT, include_str!("page/drawing.js")),
        "/story.js" => (SCRIPT, include_str!("page/story.js")),
        "/editor.js" => (SCRIPT, include_str!("page/editor.js")),
        "/link.js" => (SCRIPT, include_str!("page/link.js")),
        "/icon.svg" => ("image/svg+xml", include_str!("page/icon.svg")),
        _ => return None,
    })
}

/// What the page shows of the rules, as JSON.
pub(super) fn rules() -> &'static str {
    static RULES: LazyLock<String> = LazyLock::new(|| {
        let profiles = BUILTIN.iter().filter_map(|(name, _)| Profile::builtin(name));
        let clauses = clause::ALL.iter().map(|(clause, title)| (clause.id().to_owned(), text(*clause, title)));
        json!({
            "radcomp": env!("CARGO_PKG_VERSION"),
            "profiles": profiles.map(|profile| json!({ "name": profile.name, "title": profile.title })).collect::<Vec<_>>(),
            "clauses": Value::Object(clauses.collect()),
            "examples": examples(),
            "most_blocks": MOST_BLOCKS,
            "most_judged": MOST_JUDGED,
        })
        .to_string()
    });
    &RULES
}

fn text(of: Clause, title: &str) -> Value {
    json!({ "title": title, "sentence": first_sentence(of) })
}

fn examples() -> Value {
    json!([
        {
            "title": "A contour with corners of every kind",
            "program": include_str!("../../examples/first.nc"),
            "profile": "seed-mill", "offset": 1, "radius": "5",
        },
        {
            "title": "A pocket",
            "program": include_str!("../../examples/pocket.nc"),
            "profile": "seed-mill", "offset": 1, "radius": "5",
        },
        {
            "title": "Turning",
            "program": include_str!("../../examples/turning.nc"),
            "profile": "yasnac-lx", "offset": 2, "radius": "0.8",
        },
        {
            "title": "A slot that is narrower than the tool",
            "program": include_str!("page/slot.nc"),
            "profile": "fanuc-30i", "offset": 1, "radius": "7",
        },
    ])
}
