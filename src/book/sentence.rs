//! Formulas in a sentence that does not mark them, such as `an outer corner with d < 0`.

/// The formulas of a sentence: its parts in order, those that are formulas apart.
///
/// A formula is a run of terms with operators between them, `d > 0` or `α = 180° + σ·φ`, or one term that no word of the
/// language looks like, `u1` or `σ·c`.
pub(super) fn in_sentence(text: &str) -> Vec<(String, bool)> {
    let joined = with_pairs_joined(text);
    let words: Vec<&str> = joined.split_inclusive(' ').collect();
    let mut parts: Vec<(String, bool)> = Vec::new();
    let plain = |parts: &mut Vec<(String, bool)>, text: &str| match parts.last_mut() {
        Some((last, false)) => last.push_str(text),
        _ => parts.push((text.to_owned(), false)),
    };
    let mut place = 0;
    while place < words.len() {
        match run_at(&words[place..]) {
            Some((count, formula, before, after)) => {
                plain(&mut parts, before);
                parts.push((formula, true));
                plain(&mut parts, &after);
                place += count;
            }
            None => {
                plain(&mut parts, words[place]);
                place += 1;
            }
        }
    }
    parts.retain(|(text, _)| !text.is_empty());
    parts.into_iter().map(|(text, formula)| (text.replace(JOINT, " "), formula)).collect()
}

/// Stands for the space of a pair in parentheses while words are told apart by theirs.
const JOINT: char = '\u{2009}';

/// A text in which the space of each pair of terms, as in `cross(t1, t2)`, is a [`JOINT`].
fn with_pairs_joined(text: &str) -> String {
    let mut joined = String::new();
    for word in text.split_inclusive(' ') {
        let start = joined.rfind(' ').map_or(0, |last| joined[..last].rfind(' ').map_or(0, |before| before + 1));
        let pair = format!("{}{JOINT}{word}", joined[start..].trim_end());
        let bare = pair.trim_end().trim_end_matches([',', '.', ';', ':']);
        let open = joined[start..].ends_with(", ") && !balanced(&joined[start..]);
        if open && balanced(bare) && is_term(bare) {
            joined.truncate(start);
            joined.push_str(&pair);
        } else {
            joined.push_str(word);
        }
    }
    joined
}

/// The longest formula at the head of some words: how many words it takes, itself, what stands before and after it.
fn run_at<'t>(words: &[&'t str]) -> Option<(usize, String, &'t str, String)> {
    let operator = |word: &str| matches!(word.trim_end(), "=" | "<" | ">" | "≤" | "≥" | "+" | "-" | "/");
    let first = words.first()?;
    let before = if first.starts_with('(') && !is_term(first.trim_end()) { "(" } else { "" };
    let mut best = None;
    for count in (1..=words.len().min(15)).step_by(2) {
        let between = words[..count].iter().skip(1).step_by(2).all(|word| operator(word));
        let joined: String = words[..count].concat();
        let inner = joined.trim_end()[before.len()..].trim_end_matches([',', '.', ';', ':']);
        let inner = if balanced(inner) { inner } else { inner.trim_end_matches(')') };
        let terms = inner.split(' ').step_by(2).all(is_term);
        if !between || !terms || !balanced(inner) {
            if !between {
                break;
            }
            continue;
        }
        if is_distinctive(inner) || count > 1 && inner.contains(char::is_alphabetic) {
            best = Some((count, inner.to_owned(), before, joined[before.len() + inner.len()..].to_owned()));
        }
        // Behind a comma or a full stop another formula begins.
        if joined.trim_end().len() > before.len() + inner.len() {
            break;
        }
    }
    best
}

/// Whether a word can be a term: letters alone, letters with digits, functions, numbers, products of them.
fn is_term(word: &str) -> bool {
    if let Some((first, second)) = word.split_once(JOINT) {
        let first = first.trim_end_matches(',');
        return is_term(&format!("{first})")) && is_term(&format!("({second}"));
    }
    const FUNCTIONS: [&str; 6] = ["tan", "sin", "cos", "cross", "dot", "perp"];
    let allowed = |character: char| character.is_alphanumeric() || "·√()|/'²°._+-".contains(character);
    let unsigned = word.trim_start_matches(['+', '-', '(', '|']);
    let name = |name: &str| {
        let bare = name.trim_end_matches(|last: char| last.is_ascii_digit());
        let single = bare.chars().count() <= 1 && name.chars().count() <= 2 || name.chars().all(|c| c.is_ascii_digit());
        single || FUNCTIONS.contains(&name)
    };
    !unsigned.is_empty()
        && word.chars().all(allowed)
        && !unsigned.contains(['+', '-'])
        && word.split(|character: char| !character.is_alphanumeric()).all(name)
}

/// Whether one term alone is a formula and no word.
fn is_distinctive(term: &str) -> bool {
    let mut characters = term.chars();
    let first = characters.next().unwrap_or(' ');
    let rest: String = characters.collect();
    let greek = |character: char| ('α'..='ω').contains(&character);
    let numbered = "uCRVtn".contains(first) && matches!(rest.as_str(), "1" | "2" | "'" | "1'" | "2'");
    numbered || term.contains(greek) || (term.contains('·') && term.contains(char::is_alphabetic))
}

fn balanced(text: &str) -> bool {
    let mut depth = 0;
    for character in text.chars() {
        depth += match character {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        if depth < 0 {
            return false;
        }
    }
    depth == 0 && text.matches('|').count().is_multiple_of(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_found_in_a_sentence() {
        let found = |text: &str| -> Vec<String> {
            in_sentence(text).into_iter().filter(|(_, formula)| *formula).map(|(text, _)| text).collect()
        };
        assert_eq!(found("is inner when σ·c > 0 or when c = 0 and d > 0; it is"), ["σ·c > 0", "c = 0", "d > 0"]);
        assert_eq!(found("the workpiece side is α = 180° + σ·φ with φ the turn"), ["α = 180° + σ·φ", "φ"]);
        assert_eq!(found("an outer corner with d < 0 (0° ≤ α < 90°) that"), ["d < 0", "(0° ≤ α < 90°)"]);
        assert_eq!(found("none when D > R1' + R2', or when D < |R1' - R2'|."), ["D > R1' + R2'", "D < |R1' - R2'|"]);
        assert_eq!(found("tan(|φ|/2) = 2, from u1 to u2."), ["tan(|φ|/2) = 2", "u1", "u2"]);
        assert_eq!(found("to its side, σ·cross(t1, t2) > 0 with t1"), ["σ·cross(t1, t2) > 0", "t1"]);
        assert_eq!(found("Two lines: A = (15, 5), B = (17, 1)."), ["A = (15, 5)", "B = (17, 1)"]);
        assert_eq!(found("over the normal (10, -1) to the corner point (11, -1)."), Vec::<String>::new());
        assert_eq!(found("under G41 D1 a tool T1 goes to X 10 - 20, N40; I am - a tool"), Vec::<String>::new());
        let plain = "at (10, 5), and (see there) the rest";
        assert_eq!(in_sentence(plain), [(plain.to_owned(), false)]);
        let whole: String = in_sentence("so (α ≥ 180°), and").into_iter().map(|(text, _)| text).collect();
        assert_eq!(whole, "so (α ≥ 180°), and");
    }
}
