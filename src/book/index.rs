//! The index of the search, made when the book is built; a small script of the pages reads it.

use serde::Serialize;

/// The entries.
#[derive(Clone, Debug, Default)]
pub(super) struct Index {
    entries: Vec<Entry>,
}

#[derive(Clone, Debug, Serialize)]
struct Entry {
    kind: &'static str,
    title: String,
    target: String,
    text: String,
    /// Further places that the entry leads to, such as the figure of a sentence: words and target.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    more: Vec<[String; 2]>,
}

/// What is found.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Clause,
    Chapter,
    Parameter,
    Alarm,
    Profile,
    Vector,
    Sentence,
    Guide,
}

impl Kind {
    const fn name(self) -> &'static str {
        match self {
            Kind::Clause => "clause",
            Kind::Chapter => "chapter",
            Kind::Parameter => "parameter",
            Kind::Alarm => "alarm",
            Kind::Profile => "profile",
            Kind::Vector => "vector",
            Kind::Sentence => "seed document",
            Kind::Guide => "guide",
        }
    }
}

impl Index {
    /// Adds what stands at a target; title and text are plain.
    pub(super) fn add(&mut self, kind: Kind, title: &str, target: &str, text: &str) {
        self.add_with(kind, title, target, text, Vec::new());
    }

    /// The same with further places.
    pub(super) fn add_with(&mut self, kind: Kind, title: &str, target: &str, text: &str, more: Vec<[String; 2]>) {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let entry = Entry { kind: kind.name(), title: title.to_owned(), target: target.to_owned(), text, more };
        self.entries.push(entry);
    }

    /// The index as a script that sets one variable: a page read from a disk may load scripts, and nothing else.
    pub(super) fn script(&self) -> Result<String, String> {
        let json = serde_json::to_string(&self.entries).map_err(|error| error.to_string())?;
        Ok(format!("\"use strict\";\nwindow.radcompIndex = {json};\n"))
    }
}
