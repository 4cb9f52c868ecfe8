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

/// From how many characters on a formula may be wider than a cell on a telephone.
const LONG: usize = 20;

/// The formula as a `math` element; characters that it does not know are set as operators.
pub(super) fn math(text: &str) -> String {
    let characters: Vec<char> = text.split_whitespace().collect::<Vec<_>>().join(" ").chars().collect();
    let mut place = 0;
    let row = row(&characters, &mut place, None);
    // No browser breaks a formula: what is longer than a telephone is wide scrolls on a line of its own there.
    if characters.len() >= LONG {
        format!("<span class=\"formula\"><math>{row}</math></span>")
    } else {
        format!("<math>{row}</math>")
    }
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
        assert!(math("R1'² - a² + R2'² - b²").starts_with("<span class=\"formula\"><math>"));
        let scaled = math("k = dot(S, V) / (2)");
        assert!(scaled.contains("<mo>=</mo><mfrac><mrow><mi>dot</mi><mrow>"), "{scaled}");
    }
}
