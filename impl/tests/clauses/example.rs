//! A worked example as it is written: its fields, its profile, its numbers.

use radcomp_spec::profile::{PARAMETERS, Profile};

/// The text of an example.
pub struct Example<'a>(pub &'a str);

impl<'a> Example<'a> {
    /// What stands behind `name = `.
    pub fn field(&self, name: &str) -> Option<&'a str> {
        self.0.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(" = "))
    }

    /// The same without its quotes.
    pub fn text(&self, name: &str) -> Option<&'a str> {
        self.field(name).map(|value| value.trim_matches('"'))
    }

    /// A number in quotes; 0 if there is none.
    pub fn number(&self, name: &str) -> f64 {
        self.text(name).map_or(0.0, |text| text.parse().unwrap())
    }

    /// The entries of a table on one line.
    pub fn table(&self, name: &str) -> Vec<(&'a str, &'a str)> {
        let entries = self.field(name).unwrap_or("{ }").trim_matches(['{', '}', ' ']);
        let pair = |entry: &'a str| entry.split_once('=').map(|(key, value)| (key.trim(), value.trim())).unwrap();
        entries.split(',').filter(|entry| !entry.is_empty()).map(pair).collect()
    }

    /// What stands between two texts.
    pub fn between(&self, open: &str, close: &str) -> &'a str {
        let (_, rest) = self.0.split_once(open).unwrap_or(("", ""));
        rest.split_once(close).unwrap_or(("", "")).0
    }

    /// The strings of a list, on one line or on several.
    pub fn list(&self, name: &str) -> Vec<&'a str> {
        let written = self.between(&format!("\n{name} = ["), "]");
        written.split('"').skip(1).step_by(2).collect()
    }

    /// The profile, with the parameters that the example changes.
    pub fn profile(&self) -> Profile {
        let mut text = format!("name = \"example\"\ntitle = \"\"\nextends = \"{}\"\n", self.text("profile").unwrap());
        for (name, value) in self.table("set") {
            let parameter = PARAMETERS.iter().find(|parameter| parameter.name() == name).unwrap();
            let key = parameter.key;
            text += &format!("{key} = {{ value = {value}, source = \"D\", clause = \"{}\" }}\n", parameter.clause.id());
        }
        Profile::parse(&text, "example").unwrap_or_else(|fault| panic!("{text}\n{fault}"))
    }
}

/// A sum of products of numbers, square roots and parentheses.
pub fn number(text: &str) -> f64 {
    let (value, rest) = sum(text);
    assert!(rest.is_empty(), "number {text}");
    value
}

fn sum(text: &str) -> (f64, &str) {
    let (mut value, mut rest) = product(text);
    while let Some(sign) = rest.chars().next().filter(|sign| "+-".contains(*sign)) {
        let (term, after) = product(&rest[1..]);
        value += if sign == '+' { term } else { -term };
        rest = after;
    }
    (value, rest)
}

fn product(text: &str) -> (f64, &str) {
    let (mut value, mut rest) = factor(text);
    while let Some(sign) = rest.chars().next().filter(|sign| "*/".contains(*sign)) {
        let (other, after) = factor(&rest[1..]);
        value = if sign == '*' { value * other } else { value / other };
        rest = after;
    }
    (value, rest)
}

fn factor(text: &str) -> (f64, &str) {
    if let Some(rest) = text.strip_prefix('-') {
        let (value, rest) = factor(rest);
        return (-value, rest);
    }
    if let Some(inner) = text.strip_prefix("sqrt(").or(text.strip_prefix('(')) {
        let (value, rest) = sum(inner);
        let value = if text.starts_with('s') { value.sqrt() } else { value };
        return (value, rest.strip_prefix(')').unwrap());
    }
    let end = text.find(|digit: char| !digit.is_ascii_digit() && digit != '.').unwrap_or(text.len());
    (text[..end].parse().unwrap_or_else(|_| panic!("number {text}")), &text[end..])
}

/// A step of a path: its words and its numbers.
pub fn expected(line: &str) -> (String, Vec<f64>) {
    let words: Vec<&str> = line.split_whitespace().collect();
    let is_word =
        |word: &&&str| word.starts_with(|first: char| first.is_ascii_lowercase()) && !word.starts_with("sqrt");
    let kept: Vec<&str> = words[1..words.len() - 1].iter().filter(is_word).copied().collect();
    let kept: Vec<&str> = kept.into_iter().filter(|word| *word != "centre").collect();
    let numbers = words[1..words.len() - 1].iter().filter(|word| !is_word(word)).map(|word| number(word)).collect();
    (format!("{} {} {}", words[0], kept.join(" "), words[words.len() - 1]), numbers)
}
