//! The tool table: the radius that each offset number stands for ([TRC-MODE-03]).

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

use radcomp_model::number::{format_decimal, parse_decimal};
use rug::Rational;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostic::{Diagnostic, Kind, LineFault};
use super::word::MOST_DIGITS;

/// The radii of the offset numbers.
///
/// In a file each tool is a table `[[tool]]` with a `number` from 1, a `radius` or a `diameter` in millimetres as a
/// decimal in quotes, so that it stays exact, and, if wanted, an `orientation` of the imaginary tip: 0 or 9, the centre
/// of the nose. Other orientations are not supported yet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tools {
    radii: BTreeMap<u32, Rational>,
}

/// The greatest offset number.
const MOST_NUMBER: u32 = 999_999_999;

impl Tools {
    /// A table without tools.
    pub fn empty() -> Self {
        Tools::default()
    }

    /// Reads the text of a tool table; `file` is the file's name in messages.
    ///
    /// # Errors
    ///
    /// The first fault of the table.
    ///
    /// # Exactness
    ///
    /// A radius is the decimal as written, a diameter half of it.
    pub fn parse(text: &str, file: &str) -> Result<Self, Diagnostic> {
        parse(text).map_err(|fault| fault.in_text(file, text))
    }

    /// The same table with another tool, or another radius for a tool; in millimetres.
    pub fn with_radius(mut self, number: u32, radius: Rational) -> Self {
        self.radii.insert(number, radius);
        self
    }

    /// The radius of an offset number, in millimetres; none if the table does not have it.
    pub fn radius_of(&self, number: u32) -> Option<&Rational> {
        self.radii.get(&number)
    }

    /// The table as a file's text; none if a radius has no finite decimal.
    pub fn to_toml(&self) -> Option<String> {
        let mut text = String::new();
        for (number, radius) in &self.radii {
            let separator = if text.is_empty() { "" } else { "\n" };
            let radius = format_decimal(radius)?;
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{separator}[[tool]]\nnumber = {number}\nradius = \"{radius}\"");
        }
        Some(text)
    }

    /// Which numbers there are, for people.
    pub(super) fn listed(&self) -> String {
        const MOST: usize = 8;
        let mut numbers: Vec<String> = self.radii.keys().take(MOST).map(u32::to_string).collect();
        if self.radii.len() > MOST {
            numbers.push("…".to_owned());
        }
        match numbers.is_empty() {
            true => "it has none".to_owned(),
            false => format!("it has {}", numbers.join(", ")),
        }
    }
}

fn parse(text: &str) -> Result<Tools, LineFault> {
    let document =
        DeTable::parse(text).map_err(|error| wrong(error.span().unwrap_or_default(), error.message().to_owned()))?;
    let root = document.get_ref();
    check_keys(root, &["tool"])?;
    let mut tools = Tools::empty();
    let Some(list) = root.get("tool") else { return Ok(tools) };
    let not_tables = || wrong(list.span(), "tools are tables: `[[tool]]`, then `number` and `radius`");
    for tool in list.get_ref().as_array().ok_or_else(not_tables)? {
        let table = tool.get_ref().as_table().ok_or_else(not_tables)?;
        let (number, radius) = parse_tool(table, tool.span())?;
        if tools.radii.insert(number.into_inner(), radius).is_some() {
            let number = &table["number"];
            return Err(wrong(number.span(), "this number stands in the table already"));
        }
    }
    Ok(tools)
}

fn parse_tool(table: &DeTable<'_>, place: Range<usize>) -> Result<(Spanned<u32>, Rational), LineFault> {
    check_keys(table, &["number", "radius", "diameter", "orientation"])?;
    let given = table.get("number").ok_or_else(|| wrong(place.clone(), "`number` is missing"))?;
    let number = whole(given.get_ref()).filter(|number| (1..=MOST_NUMBER).contains(number));
    let number = number.ok_or_else(|| wrong(given.span(), format!("a number from 1 to {MOST_NUMBER}")))?;
    if let Some(orientation) = table.get("orientation") {
        match whole(orientation.get_ref()) {
            Some(0 | 9) => {}
            Some(1..=8) => {
                let message = "orientations other than 0 and 9, the centre of the nose, are not supported yet";
                return Err(LineFault::new(Kind::UnsupportedTool, orientation.span(), message));
            }
            _ => return Err(wrong(orientation.span(), "an orientation is a whole number from 0 to 9")),
        }
    }
    let radius = match (table.get("radius"), table.get("diameter")) {
        (Some(radius), None) => size(radius)?,
        (None, Some(diameter)) => size(diameter)? / 2,
        (Some(_), Some(diameter)) => return Err(wrong(diameter.span(), "the radius of this tool is given already")),
        (None, None) => return Err(wrong(place, "`radius` or `diameter` is missing")),
    };
    Ok((Spanned::new(given.span(), number), radius))
}

/// A radius or a diameter.
fn size(given: &Spanned<DeValue<'_>>) -> Result<Rational, LineFault> {
    let message = || "a decimal in quotes, 0 or greater, such as \"0.8\"";
    let text = given.get_ref().as_str().ok_or_else(|| wrong(given.span(), message()))?;
    let (digits, decimals) = text.split_once('.').unwrap_or((text, ""));
    if digits.len() > MOST_DIGITS || decimals.len() > MOST_DIGITS {
        let message = format!("a size has at most {MOST_DIGITS} digits before its point and {MOST_DIGITS} after it");
        return Err(wrong(given.span(), message));
    }
    parse_decimal(text).filter(|size| !size.is_negative()).ok_or_else(|| wrong(given.span(), message()))
}

fn whole(value: &DeValue<'_>) -> Option<u32> {
    let integer = value.as_integer()?;
    u32::from_str_radix(integer.as_str(), integer.radix()).ok()
}

/// Refuses keys other than these.
fn check_keys(table: &DeTable<'_>, names: &[&str]) -> Result<(), LineFault> {
    let unknown = table.keys().filter(|name| !names.contains(&&**name.get_ref()));
    match unknown.min_by_key(|name| name.span().start) {
        None => Ok(()),
        Some(first) => {
            let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
            Err(wrong(first.span(), format!("not a key of a tool table; possible here: {}", names.join(", "))))
        }
    }
}

fn wrong(span: Range<usize>, message: impl Into<String>) -> LineFault {
    LineFault::new(Kind::WrongTable, span, message)
}
