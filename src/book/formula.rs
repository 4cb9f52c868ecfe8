//! Formulas as the clauses write them, such as `P + r·n(u1) - r·tan(|φ|/2)·u1`, set as MathML.
//!
//! Digits at the end of a name and what follows `_` are set below it, `'` and `²` above it; `√( )` becomes a root and
//! ` / ` between spaces a fraction. Nothing is computed.

/// A part of a row that is set already.
#[derive(Clone, Debug)]
struct Node {
    set: String,
    kind: Kind,
    /// Of a group in parentheses: what stands between them.
    inner: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// Can be divided.
    Atom,
    /// Stands between terms.
    Operator,
}

/// Whether a text in code type is a formula, not a name: it has an operator, or is a single letter.
pub(super) fn is_formula(text: &str) -> bool {
    let operators = ['·', '+', '=', '<', '>', '≤', '≥', '√', '|', '('];
    let mut characters = text.chars();
    let letter = characters.next().is_some_and(char::is_alphabetic);
    let rest: String = characters.collect();
    let symbol = letter && matches!(rest.as_str(), "" | "'" | "1" | "2");
    symbol || text.contains(operators)
}

/// The formulas of a sentence: its parts in order, those that are formulas apart.
///
/// A formula is a run of terms with operators between them, `d > 0` or `α = 180° + σ·φ`, or one term that no word of the
/// language looks like, `u1` or `σ·c`.
pub(super) fn in_sentence(text: &str) -> Vec<(String, bool)> {
    let words: Vec<&str> = text.split_inclusive(' ').collect();
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
    parts
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
        if count > 1 || is_distinctive(inner) {
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
    let numbered = "uCRVtnD".contains(first) && matches!(rest.as_str(), "1" | "2" | "'" | "1'" | "2'");
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

/// The formula as a `math` element; characters that it does not know are set as operators.
pub(super) fn math(text: &str) -> String {
    let characters: Vec<char> = text.split_whitespace().collect::<Vec<_>>().join(" ").chars().collect();
    let mut place = 0;
    let row = row(&characters, &mut place, None);
    format!("<math>{row}</math>")
}

/// Sets what stands up to `end`, which is passed over.
fn row(text: &[char], place: &mut usize, end: Option<char>) -> String {
    let mut nodes: Vec<Node> = Vec::new();
    let mut divide = false;
    while let Some(character) = text.get(*place).copied() {
        if Some(character) == end {
            *place += 1;
            break;
        }
        let spaced = |at: usize| at.checked_sub(1).and_then(|before| text.get(before)) == Some(&' ');
        if character == ' ' {
            *place += 1;
            continue;
        }
        if character == '/' && spaced(*place) {
            *place += 1;
            divide = true;
            continue;
        }
        let node = node(text, place);
        if std::mem::take(&mut divide) {
            fraction(&mut nodes, &node);
        } else {
            nodes.push(node);
        }
    }
    format!("<mrow>{}</mrow>", nodes.iter().map(|node| node.set.as_str()).collect::<String>())
}

/// Puts the last term of the row over a divisor.
fn fraction(nodes: &mut Vec<Node>, below: &Node) {
    let start = nodes.iter().rposition(|node| node.kind == Kind::Operator).map_or(0, |last| last + 1);
    let above: Vec<Node> = nodes.drain(start..).collect();
    let bare = |node: &Node| node.inner.clone().unwrap_or_else(|| node.set.clone());
    let above = match &above[..] {
        [only] => bare(only),
        several => format!("<mrow>{}</mrow>", several.iter().map(|node| node.set.as_str()).collect::<String>()),
    };
    let set = format!("<mfrac>{above}{}</mfrac>", bare(below));
    nodes.push(Node { set, kind: Kind::Atom, inner: None });
}

fn node(text: &[char], place: &mut usize) -> Node {
    let character = text[*place];
    let atom = |set: String| Node { set, kind: Kind::Atom, inner: None };
    if character == '√' {
        *place += 1;
        if text.get(*place) == Some(&'(') {
            *place += 1;
            return atom(format!("<msqrt>{}</msqrt>", row(text, place, Some(')'))));
        }
        let under = if *place < text.len() { node(text, place).set } else { String::new() };
        return atom(format!("<msqrt>{under}</msqrt>"));
    }
    if character == '(' {
        *place += 1;
        let inner = row(text, place, Some(')'));
        let set = format!("<mrow><mo stretchy=\"false\">(</mo>{inner}<mo stretchy=\"false\">)</mo></mrow>");
        return Node { set: raised(set, None, text, place), kind: Kind::Atom, inner: Some(inner) };
    }
    if character.is_ascii_digit() {
        let number = run(text, place, |next| next.is_ascii_digit() || next == '.');
        return atom(format!("<mn>{number}</mn>"));
    }
    if character.is_alphabetic() {
        let name = run(text, place, char::is_alphabetic);
        let mut below = run(text, place, |next| next.is_ascii_digit());
        if text.get(*place) == Some(&'_') {
            *place += 1;
            below = run(text, place, char::is_alphanumeric);
        }
        let set = format!("<mi>{name}</mi>");
        return atom(raised(set, (!below.is_empty()).then_some(below), text, place));
    }
    *place += 1;
    if character == '°' {
        return atom("<mi mathvariant=\"normal\">°</mi>".to_owned());
    }
    let set = match character {
        '-' => "−".to_owned(),
        '<' => "&lt;".to_owned(),
        '>' => "&gt;".to_owned(),
        '&' => "&amp;".to_owned(),
        other => other.to_string(),
    };
    let kind = if matches!(character, '+' | '-' | '=' | '<' | '>' | '≤' | '≥' | ',') {
        Kind::Operator
    } else {
        Kind::Atom
    };
    let stretchy = if character == '|' { " stretchy=\"false\"" } else { "" };
    Node { set: format!("<mo{stretchy}>{set}</mo>"), kind, inner: None }
}

/// A part with what stands below it and what follows above it.
fn raised(base: String, below: Option<String>, text: &[char], place: &mut usize) -> String {
    let mut above = String::new();
    while let Some(mark @ ('\'' | '²')) = text.get(*place) {
        above.push_str(if *mark == '²' { "<mn>2</mn>" } else { "<mo>′</mo>" });
        *place += 1;
    }
    let digits = |below: &str| below.chars().all(|character| character.is_ascii_digit());
    let below =
        below.map(|below| if digits(&below) { format!("<mn>{below}</mn>") } else { format!("<mi>{below}</mi>") });
    match (below, above.is_empty()) {
        (None, true) => base,
        (None, false) => format!("<msup>{base}<mrow>{above}</mrow></msup>"),
        (Some(below), true) => format!("<msub>{base}{below}</msub>"),
        (Some(below), false) => format!("<msubsup>{base}{below}<mrow>{above}</mrow></msubsup>"),
    }
}

fn run(text: &[char], place: &mut usize, belongs: impl Fn(char) -> bool) -> String {
    let rest = &text[*place..];
    let found: String = rest.iter().take_while(|next| belongs(**next)).collect();
    *place += found.chars().count();
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_the_profile_are_no_formulas() {
        for name in ["corner-owner", "type-a", "normal", "no-intersection", "G41", "tip-path"] {
            assert!(!is_formula(name), "{name}");
        }
        for formula in ["P", "u1", "R'", "d ≥ L", "P + r·n", "r·n(u)"] {
            assert!(is_formula(formula), "{formula}");
        }
    }

    #[test]
    fn digits_stand_below_and_primes_above() {
        assert_eq!(math("u1"), "<math><mrow><msub><mi>u</mi><mn>1</mn></msub></mrow></math>");
        let raised = "<msubsup><mi>R</mi><mn>1</mn><mrow><mo>′</mo><mn>2</mn></mrow></msubsup>";
        assert_eq!(math("R1'²"), format!("<math><mrow>{raised}</mrow></math>"));
        assert!(math("v_a").contains("<msub><mi>v</mi><mi>a</mi></msub>"));
    }

    #[test]
    fn formulas_are_found_in_a_sentence() {
        let found = |text: &str| -> Vec<String> {
            in_sentence(text).into_iter().filter(|(_, formula)| *formula).map(|(text, _)| text).collect()
        };
        assert_eq!(found("is inner when σ·c > 0 or when c = 0 and d > 0; it is"), ["σ·c > 0", "c = 0", "d > 0"]);
        assert_eq!(found("the workpiece side is α = 180° + σ·φ with φ the turn"), ["α = 180° + σ·φ", "φ"]);
        assert_eq!(found("an outer corner with d < 0 (0° ≤ α < 90°) that"), ["d < 0", "0° ≤ α < 90°"]);
        assert_eq!(found("none when D > R1' + R2', or when D < |R1' - R2'|."), ["D > R1' + R2'", "D < |R1' - R2'|"]);
        assert_eq!(found("tan(|φ|/2) = 2, from u1 to u2."), ["tan(|φ|/2) = 2", "u1", "u2"]);
        assert_eq!(found("under G41 a tool T1 goes to X 10 - 20, N40; I am - a tool"), Vec::<String>::new());
        let whole: String = in_sentence("so (α ≥ 180°), and").into_iter().map(|(text, _)| text).collect();
        assert_eq!(whole, "so (α ≥ 180°), and");
    }

    #[test]
    fn roots_and_fractions() {
        let root = math("√(R'² - h²)");
        assert!(root.starts_with("<math><mrow><msqrt><mrow><msup>"), "{root}");
        assert!(root.ends_with("</mrow></msqrt></mrow></math>"), "{root}");
        let quotient = math("a = (x + y) / (2·D)");
        assert!(
            quotient.contains("<mo>=</mo><mfrac><mrow><mi>x</mi><mo>+</mo><mi>y</mi></mrow><mrow><mn>2</mn>"),
            "{quotient}"
        );
        assert!(math("|φ|/2").contains("<mo>/</mo><mn>2</mn>"));
        assert!(math("d < 0").contains("<mo>&lt;</mo>"));
        let scaled = math("k = dot(S, V) / (2)");
        assert!(scaled.contains("<mo>=</mo><mfrac><mrow><mi>dot</mi><mrow>"), "{scaled}");
    }
}
