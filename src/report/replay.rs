//! The command that asks a device again.

/// The shell command that replays a cause of the report in this file.
pub fn replay(file: &str, cause: &str) -> String {
    format!("radcomp replay {} --case {}", word(file), word(cause))
}

/// A word of a shell command, quoted if it has to be.
fn word(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./+:,@%".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    format!("'{}'", text.replace('\'', "'\\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_for_the_shell() {
        assert_eq!(
            replay("r.json", "TRC-CORNER-08 end point"),
            "radcomp replay r.json --case 'TRC-CORNER-08 end point'"
        );
        assert_eq!(word("it's"), "'it'\\''s'");
        assert_eq!(word(""), "''");
    }
}
