//! `radcomp clause`.

use std::io::Write;

use clap::Args;
use radcomp_spec::catalogue::{Catalogue, ClauseText};

use super::failure::{Failure, Verdict};
use super::nearest::suggestion;
use super::terminal::{self, bold};

/// Show a clause of the specification: its text, where it comes from, its worked examples
#[derive(Debug, Args)]
#[command(after_help = "\
Sources: S:… read in that source, K known from well-known manuals, I derived,
D decided by this project.

Examples:
  radcomp clause
  radcomp clause TRC-CORNER-08
  radcomp clause corner-08")]
pub struct Clauses {
    /// The clause, such as TRC-CORNER-08; all are listed if none is named
    #[arg(value_name = "ID")]
    id: Option<String>,
}

impl Clauses {
    /// Prints the clause, or the list.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let text = match &self.id {
            None => list(),
            Some(id) => page(find(id)?),
        };
        let mut out = terminal::output();
        out.write_all(text.as_bytes())?;
        out.flush()?;
        Ok(Verdict::Green)
    }
}

fn find(id: &str) -> Result<&'static ClauseText, Failure> {
    let catalogue = Catalogue::builtin();
    let bare = id.trim_start_matches('[').trim_end_matches(']');
    catalogue.find(bare).or_else(|| catalogue.find(&format!("TRC-{bare}"))).ok_or_else(|| {
        let ids = catalogue.clauses.iter().map(|text| text.clause.id());
        let suggestion = suggestion(bare, ids);
        Failure::Input(format!("there is no clause {id}{suggestion}\n`radcomp clause` lists all"))
    })
}

fn list() -> String {
    let catalogue = Catalogue::builtin();
    let mut text = String::new();
    for (index, chapter) in catalogue.chapters.iter().enumerate() {
        text.push_str(&format!("{}{}\n", if index == 0 { "" } else { "\n" }, bold(chapter.title)));
        for clause in catalogue.clauses.iter().filter(|clause| clause.chapter == index) {
            text.push_str(&format!("  {:<16}{}\n", clause.clause.id(), clause.title));
        }
    }
    text
}

fn page(clause: &ClauseText) -> String {
    let chapter = &Catalogue::builtin().chapters[clause.chapter];
    let mut text = format!(
        "{}\n\nChapter: {} (spec/clauses/{}:{})\nSource: {}\n\n{}\n",
        bold(&format!("[{}] {}", clause.clause, clause.title)),
        chapter.title,
        chapter.file,
        clause.line,
        clause.sources.join(", "),
        clause.text
    );
    for (number, example) in (1..).zip(&clause.examples) {
        text.push_str(&format!("\n{}\n", bold(&format!("Example {number}"))));
        for line in example.text.lines() {
            text.push_str(&format!("    {line}\n"));
        }
    }
    text
}
