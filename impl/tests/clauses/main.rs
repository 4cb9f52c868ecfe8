//! Every worked example of the clauses that is no error of the program, word by word: paths, clauses and alarms.

#[path = "../common/mod.rs"]
mod common;
mod reader;

use common::{SEED_MILL, run, write};
use radcomp_spec::Parameters;
use radcomp_spec::parameters::*;
use reader::Reader;

/// The largest coordinate of the examples is 10⁹; most are below 100.
const TOLERANCE: f64 = 1e-12;

struct Example<'a>(&'a str);

impl<'a> Example<'a> {
    fn field(&self, name: &str) -> Option<&'a str> {
        self.0.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(" = "))
    }

    fn text(&self, name: &str) -> Option<&'a str> {
        self.field(name).map(|value| value.trim_matches('"'))
    }

    fn between(&self, open: &str, close: &str) -> &'a str {
        let (_, rest) = self.0.split_once(open).unwrap_or(("", ""));
        rest.split_once(close).unwrap_or(("", "")).0
    }
}

fn value<T: Copy>(values: &[(&str, T)], id: &str) -> T {
    values.iter().find(|value| value.0 == id).unwrap_or_else(|| panic!("no value {id}")).1
}

fn parameters(example: &Example, reader: &mut Reader) -> Parameters {
    let mut parameters = SEED_MILL;
    if example.text("profile") == Some("mori-lathe") {
        parameters.start_up_lost = StartUpLost::NoVector;
        parameters.non_moving_allowed = 4;
        parameters.reversed_path = ReversedPath::Alarm;
    }
    let set = example.field("set").unwrap_or("{ }").trim_matches(['{', '}', ' ']);
    for entry in set.split(',').filter(|entry| !entry.is_empty()) {
        let (name, id) = entry.split_once('=').unwrap();
        let id = id.trim().trim_matches('"');
        match name.trim() {
            "start-up-lost" => parameters.start_up_lost = value(StartUpLost::VALUES, id),
            "outer-corner" => parameters.outer_corner = value(OuterCorner::VALUES, id),
            "reversal" => parameters.reversal = value(Reversal::VALUES, id),
            "side-change" => parameters.side_change = value(SideChange::VALUES, id),
            "side-change-after-start-up" => {
                parameters.side_change_after_start_up = value(SideChangeAfterStartUp::VALUES, id);
            }
            "non-moving-allowed" => parameters.non_moving_allowed = id.parse().unwrap(),
            "corner-owner" => parameters.corner_owner = value(CornerOwner::VALUES, id),
            "reversed-path" => parameters.reversed_path = value(ReversedPath::VALUES, id),
            "arc-end-tolerance" => {
                let millionths = (id.parse::<f64>().unwrap() * 1e6).round() as u32;
                parameters.arc_end_tolerance = Ratio { numerator: millionths, denominator: 1_000_000 };
            }
            "dummy-first-axis" => reader.dummy_diameter = id == "diameter",
            "far-intersection" => {}
            other => panic!("parameter {other}"),
        }
    }
    parameters
}

/// A sum of products of numbers, square roots and parentheses.
fn number(text: &str) -> f64 {
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

fn expected(line: &str) -> (String, Vec<f64>) {
    let words: Vec<&str> = line.split_whitespace().collect();
    let is_word =
        |word: &&&str| word.starts_with(|first: char| first.is_ascii_lowercase()) && !word.starts_with("sqrt");
    let kept: Vec<&str> = words[1..words.len() - 1].iter().filter(is_word).copied().collect();
    let kept: Vec<&str> = kept.into_iter().filter(|word| *word != "centre").collect();
    let numbers = words[1..words.len() - 1].iter().filter(|word| !is_word(word)).map(|word| number(word)).collect();
    (format!("{} {} {}", words[0], kept.join(" "), words[words.len() - 1]), numbers)
}

fn check(example: &Example) -> Result<(), String> {
    let radius = example.text("radius").map_or(0.0, |text| text.parse().unwrap());
    let mut reader = Reader::new(example.text("profile").unwrap(), radius);
    let tools = example.field("tools").unwrap_or("{ }").trim_matches(['{', '}', ' ']);
    for entry in tools.split(',').filter(|entry| !entry.is_empty()) {
        let (tool, radius) = entry.split_once('=').unwrap();
        reader.tools.push((tool.trim().parse().unwrap(), radius.trim().trim_matches('"').parse().unwrap()));
    }
    let parameters = parameters(example, &mut reader);
    let program = example.between("program = \"\"\"\n", "\"\"\"");
    let blocks: Vec<_> = program.lines().map(|line| reader.block(line)).collect();
    let (steps, alarm) = run(&parameters, &blocks);
    let alarm = alarm.map(|alarm| format!("{} {}", alarm.block + 1, alarm.kind.id()));
    if alarm.as_deref() != example.text("alarm") {
        return Err(format!("alarm {alarm:?}"));
    }
    let path: Vec<&str> = example.between("path = [\n", "\n]").lines().collect();
    let written: Vec<_> = steps.iter().map(write).collect();
    let same = path.len() == written.len()
        && path.iter().zip(&written).all(|(line, written)| {
            let expected = expected(line.trim().trim_matches([',', '"']));
            let near = |(a, b): (&f64, &f64)| (a - b).abs() <= TOLERANCE * a.abs().max(100.0);
            expected.0 == written.0
                && expected.1.len() == written.1.len()
                && expected.1.iter().zip(&written.1).all(near)
        });
    if same { Ok(()) } else { Err(format!("path {written:?}")) }
}

#[test]
fn worked_examples() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../spec/clauses");
    let (mut examples, mut failures) = (0, String::new());
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        for part in text.split("```toml example\n").skip(1) {
            let example = Example(part.split_once("\n```").unwrap().0);
            if example.field("error").is_some() {
                continue;
            }
            examples += 1;
            if let Err(reason) = check(&example) {
                failures += &format!("{}:\n{}\n{reason}\n\n", path.display(), example.0);
            }
        }
    }
    assert!(failures.is_empty(), "{failures}");
    assert!(examples > 100, "only {examples} examples");
}
