//! What there is to tell of one block, as a page of plain text and as JSON.

use std::fmt::Write;

use radcomp_spec::{Clause, clause};
use serde_json::{Value, json};

use super::{first_sentence, wrapped};

/// One block.
#[derive(Debug)]
pub(super) struct Explanation {
    /// Its index, from 0.
    pub(super) block: usize,
    /// Its line, from 1.
    pub(super) line: u32,
    /// The digits of its N word.
    pub(super) n: Option<String>,
    /// The text of its line.
    pub(super) text: String,
    /// What is told, in order.
    pub(super) rows: Vec<Row>,
    /// The clauses of its path, its warnings and its alarm, each once.
    pub(super) clauses: Vec<Clause>,
}

/// One thing that is told.
#[derive(Debug)]
pub(super) struct Row {
    /// What kind of thing.
    pub(super) name: &'static str,
    /// The words.
    pub(super) words: String,
    /// The size of a decision's margin in millimetres: in decimal, and its closed form where that tells more.
    pub(super) margin: Option<(String, Option<String>)>,
    /// The clause that it follows.
    pub(super) clause: Option<Clause>,
    /// The closed forms of the point that it names.
    pub(super) exact: Option<String>,
}

/// Columns of the text.
const WIDTH: usize = 100;
/// Before what is told of a block.
const INDENT: &str = "               ";

impl Row {
    /// Words alone.
    pub(super) fn plain(name: &'static str, words: String) -> Self {
        Row { name, words, margin: None, clause: None, exact: None }
    }
}

impl Explanation {
    /// As a page of text.
    pub(super) fn text(&self, bold: bool) -> String {
        let (on, off) = if bold { ("\u{1b}[1m", "\u{1b}[0m") } else { ("", "") };
        let mut text = format!("{on}line {}{off} | {on}{}{off}\n", self.line, self.text.trim());
        for row in &self.rows {
            let margin = row.margin.as_ref().map_or(String::new(), |(decimal, form)| {
                let form = form.as_ref().map_or(String::new(), |form| format!(" = {form}"));
                format!("; margin {decimal} mm{form}")
            });
            let clause = row.clause.map_or(String::new(), |clause| format!(" [{clause}]"));
            set(&mut text, row.name, &format!("{}{margin}{clause}", row.words));
            if let Some(forms) = &row.exact {
                set(&mut text, "", forms);
            }
        }
        for of in &self.clauses {
            let title = clause::ALL.iter().find(|(known, _)| known == of).map_or("", |(_, title)| title);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "  [{of}] {title}");
            let _ = writeln!(text, "{}", wrapped(&first_sentence(*of), "      ", WIDTH));
        }
        text.push('\n');
        text
    }

    /// As a JSON object.
    pub(super) fn json(&self) -> Value {
        let row = |row: &Row| {
            let mut record = json!({ "name": row.name, "words": row.words });
            if let Some((decimal, form)) = &row.margin {
                record["margin"] = json!({ "decimal": decimal, "exact": form });
            }
            if let Some(clause) = row.clause {
                record["clause"] = json!(clause.id());
            }
            if let Some(exact) = &row.exact {
                record["exact"] = json!(exact);
            }
            record
        };
        json!({
            "block": self.block,
            "line": self.line,
            "n": self.n,
            "text": self.text,
            "rows": self.rows.iter().map(row).collect::<Vec<_>>(),
            "clauses": self.clauses.iter().map(|clause| clause.id()).collect::<Vec<_>>(),
        })
    }
}

/// Writes a row, its words in lines.
fn set(text: &mut String, name: &str, words: &str) {
    let set = wrapped(words, INDENT, WIDTH);
    let place = INDENT.len().min(set.len());
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {name:<width$}{}", &set[place..], width = INDENT.len() - 2);
}
