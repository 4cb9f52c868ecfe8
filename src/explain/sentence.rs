//! Clause texts cut and set for a page of plain text.

use radcomp_spec::Clause;
use radcomp_spec::catalogue::Catalogue;

/// The first sentence of a clause, on one line; empty if the specification does not hold the clause.
pub fn first_sentence(clause: Clause) -> String {
    let Some(text) = Catalogue::builtin().text_of(clause) else { return String::new() };
    let paragraph = text.text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
    let end =
        paragraph.match_indices(". ").map(|(place, _)| place).find(|place| starts_sentence(&paragraph[place + 2..]));
    match end {
        Some(end) => paragraph[..=end].to_owned(),
        None => paragraph,
    }
}

/// Whether a text begins as sentences do.
fn starts_sentence(text: &str) -> bool {
    text.starts_with(|first: char| first.is_uppercase() || matches!(first, '[' | '`'))
}

/// A text in lines of at most `width` characters, each after `indent`; a longer word has a line of its own.
pub fn wrapped(text: &str, indent: &str, width: usize) -> String {
    let mut lines = String::new();
    let mut used = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if used == 0 || used + 1 + length > width {
            lines.push_str(if lines.is_empty() { "" } else { "\n" });
            lines.push_str(indent);
            used = indent.chars().count();
        } else {
            lines.push(' ');
            used += 1;
        }
        lines.push_str(word);
        used += length;
    }
    lines
}

#[cfg(test)]
mod tests {
    use radcomp_spec::clause;

    use super::*;

    #[test]
    fn every_clause_has_a_first_sentence() {
        for (clause, _) in clause::ALL {
            let sentence = first_sentence(*clause);
            assert!(sentence.ends_with(['.', ':', '`']), "{clause}: {sentence}");
            assert!(!sentence.contains('\n'), "{clause}");
        }
    }

    #[test]
    fn a_sentence_ends_before_the_next_one() {
        let sentence = "In cancel mode the tool's centre follows the programmed moves themselves.";
        assert_eq!(first_sentence(clause::TRC_MODE_01), sentence);
    }

    #[test]
    fn lines_are_filled_up_to_the_width() {
        assert_eq!(wrapped("one two three", "> ", 9), "> one two\n> three");
    }
}
