//! Where in the book a clause, a parameter, an alarm, a profile or a vector stands.

use std::collections::BTreeMap;

use radcomp_spec::AlarmKind;
use radcomp_spec::catalogue::Catalogue;
use radcomp_spec::profile::{BUILTIN, PARAMETERS};

/// The addresses of the book, all relative: every page stands in one folder.
#[derive(Clone, Debug)]
pub(super) struct Links {
    targets: BTreeMap<String, String>,
}

impl Links {
    /// The addresses of the specification; `vectors` are the names of those that have a figure.
    pub(super) fn new<'a>(vectors: impl IntoIterator<Item = &'a str>) -> Self {
        let catalogue = Catalogue::builtin();
        let mut targets = BTreeMap::new();
        for clause in &catalogue.clauses {
            let (id, page) = (clause.clause.id(), page_of(catalogue.chapters[clause.chapter].file));
            targets.insert(id.to_owned(), format!("{page}#{id}"));
            for number in 1..=clause.examples.len() {
                targets.insert(format!("{id}#{number}"), format!("{page}#{id}-{number}"));
            }
        }
        for (name, _) in BUILTIN {
            targets.insert(format!("profile {name}"), format!("profile-{name}.html"));
        }
        for parameter in PARAMETERS {
            targets.insert(format!("parameter {}", parameter.name()), format!("parameters.html#{}", parameter.name()));
        }
        for kind in AlarmKind::ALL {
            targets.insert(format!("alarm {}", kind.id()), format!("alarms.html#{}", kind.id()));
        }
        for name in vectors {
            targets.insert(format!("vector {name}"), format!("vectors.html#{name}"));
        }
        Links { targets }
    }

    /// The clause with this id, or its example as `TRC-…#2`.
    pub(super) fn clause(&self, id: &str) -> Option<&str> {
        self.targets.get(id).map(String::as_str)
    }

    /// The parameter of this name.
    pub(super) fn parameter(&self, name: &str) -> Option<&str> {
        self.of("parameter", name)
    }

    /// The alarm with this id.
    pub(super) fn alarm(&self, id: &str) -> Option<&str> {
        self.of("alarm", id)
    }

    /// The built-in profile of this name.
    pub(super) fn profile(&self, name: &str) -> Option<&str> {
        self.of("profile", name)
    }

    /// The vector of this name.
    pub(super) fn vector(&self, name: &str) -> Option<&str> {
        self.of("vector", name)
    }

    fn of(&self, what: &str, name: &str) -> Option<&str> {
        self.targets.get(&format!("{what} {name}")).map(String::as_str)
    }
}

/// The page of a chapter's or guide's file: `04-corner.md` is `04-corner.html`.
pub(super) fn page_of(file: &str) -> String {
    format!("{}.html", file.trim_end_matches(".md"))
}

/// The page that a Markdown file of `spec` becomes, by its path from there; none for what the book does not hold.
pub(super) fn page_of_document(path: &str) -> Option<String> {
    let bare = path.trim_start_matches("../").trim_start_matches("./");
    let page = match bare {
        "README.md" | "spec/README.md" => "reading.html".to_owned(),
        "PARAMETERS.md" | "spec/PARAMETERS.md" => "parameters.html".to_owned(),
        "DIALECTS.md" | "spec/DIALECTS.md" => "dialects.html".to_owned(),
        "SEEDS.md" | "spec/SEEDS.md" => "seeds.html".to_owned(),
        "CHANGES.md" | "spec/CHANGES.md" => "changes.html".to_owned(),
        // The page has no Markdown of its own.
        "src/book/pass.rs" => "pass.html".to_owned(),
        other => {
            let file = other.trim_start_matches("spec/").strip_prefix("clauses/").or(other.strip_prefix("guides/"))?;
            file.ends_with(".md").then(|| page_of(file))?
        }
    };
    Some(page)
}
