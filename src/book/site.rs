//! The pages as they are made: templates, contents, files.

use std::collections::BTreeMap;

use minijinja::{Environment, Value, context};
use radcomp_spec::catalogue::Catalogue;
use serde::Serialize;

use super::Book;
use super::documents::GUIDES;
use super::links::{Links, page_of};
use super::prose::Prose;

/// The book while it is built.
pub(super) struct Site<'a> {
    environment: Environment<'static>,
    files: BTreeMap<String, String>,
    contents: Vec<Group>,
    links: &'a Links,
    examples: usize,
}

/// A part of the table of contents.
#[derive(Clone, Debug, Serialize)]
struct Group {
    title: &'static str,
    entries: Vec<Entry>,
}

#[derive(Clone, Debug, Serialize)]
struct Entry {
    page: String,
    title: String,
}

const TEMPLATES: [(&str, &str); 13] = [
    ("base.html", include_str!("pages/base.html")),
    ("exhibit.html", include_str!("pages/exhibit.html")),
    ("legend.html", include_str!("pages/legend.html")),
    ("front.html", include_str!("pages/front.html")),
    ("chapter.html", include_str!("pages/chapter.html")),
    ("lookup.html", include_str!("pages/lookup.html")),
    ("parameters.html", include_str!("pages/parameters.html")),
    ("profile.html", include_str!("pages/profile.html")),
    ("alarms.html", include_str!("pages/alarms.html")),
    ("vectors.html", include_str!("pages/vectors.html")),
    ("pass.html", include_str!("pages/pass.html")),
    ("ledger.html", include_str!("pages/ledger.html")),
    ("document.html", include_str!("pages/document.html")),
];

impl<'a> Site<'a> {
    /// A site without pages.
    pub(super) fn new(links: &'a Links) -> Result<Self, String> {
        let mut environment = Environment::new();
        environment.set_trim_blocks(true);
        environment.set_lstrip_blocks(true);
        for (name, text) in TEMPLATES {
            environment.add_template(name, text).map_err(|error| format!("{error:#}"))?;
        }
        let mut site = Site { environment, files: BTreeMap::new(), contents: contents(), links, examples: 0 };
        site.add("book.css", include_str!("pages/book.css").to_owned());
        site.add("book.js", include_str!("pages/book.js").to_owned());
        Ok(site)
    }

    /// Where names lead.
    pub(super) fn links(&self) -> &'a Links {
        self.links
    }

    /// Prose of clauses, with formulas.
    pub(super) fn clauses(&self) -> Prose<'a> {
        Prose { links: self.links, formulas: true, bare: false }
    }

    /// Prose of other documents: code type is code.
    pub(super) fn documents(&self) -> Prose<'a> {
        Prose { links: self.links, formulas: false, bare: false }
    }

    /// Counts an executed example.
    pub(super) fn executed(&mut self) {
        self.examples += 1;
    }

    /// Adds a file.
    pub(super) fn add(&mut self, name: &str, text: String) {
        self.files.insert(name.to_owned(), text);
    }

    /// Adds a page made by a template.
    pub(super) fn page(&mut self, name: &str, title: &str, template: &str, values: Value) -> Result<(), String> {
        let page = context! {
            page => name, title => title, contents => &self.contents,
            radcomp => env!("CARGO_PKG_VERSION"),
            ..values
        };
        let template = self.environment.get_template(template).map_err(|error| format!("{error:#}"))?;
        let text = template.render(page).map_err(|error| format!("{name}: {error:#}"))?;
        self.files.insert(name.to_owned(), text);
        Ok(())
    }

    pub(super) fn into_book(self) -> Book {
        let figures = self.files.values().map(|text| text.matches("<svg class=\"figure\"").count()).sum();
        Book { files: self.files, figures, examples: self.examples }
    }
}

fn contents() -> Vec<Group> {
    let entry = |page: &str, title: &str| Entry { page: page.to_owned(), title: title.to_owned() };
    let chapters = Catalogue::builtin().chapters.iter();
    let guides = GUIDES.iter().map(|guide| entry(&page_of(guide.file), guide.title));
    vec![
        Group {
            title: "Rules",
            entries: chapters.map(|chapter| entry(&page_of(chapter.file), chapter.title)).collect(),
        },
        Group {
            title: "Controls",
            entries: vec![
                entry("dialects.html", "How the controls differ"),
                entry("parameters.html", "Parameters"),
                entry("alarms.html", "Alarms, advisories, decisions"),
            ],
        },
        Group {
            title: "Evidence",
            entries: vec![
                entry("ledger.html", "Ledger: one row a clause"),
                entry("pass.html", "What a pass means"),
                entry("vectors.html", "Vectors"),
                entry("seeds.html", "The seed documents"),
                entry("changes.html", "Changes of the text"),
            ],
        },
        Group { title: "Guides", entries: guides.chain([entry("reading.html", "How to read a clause")]).collect() },
    ]
}
