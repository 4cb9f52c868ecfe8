//! The tool table: the tool that each offset number stands for ([TRC-MODE-03], [TRC-TIP-01], [TRC-TIP-02]).

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

use radcomp_model::number::{format_decimal, parse_decimal};
use rug::Rational;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::diagnostic::{Diagnostic, Kind, LineFault};
use super::word::MOST_DIGITS;

/// The tools of the offset numbers.
///
/// In a file each tool is a table `[[tool]]` with a `number` from 1, a `radius` or a `diameter` of its geometry in
/// millimetres as a decimal in quotes, so that it stays exact, and, if wanted, a `wear` that is added to the radius and
/// an `orientation` of the imaginary tip from 0 to 9. A size may be negative ([TRC-SIDE-07]).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tools {
    tools: BTreeMap<u32, Tool>,
}

/// A tool, in millimetres.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tool {
    /// The radius of its geometry.
    pub geometry: Rational,
    /// What is added to that ([TRC-TIP-02]).
    pub wear: Rational,
    /// The orientation of its imaginary tip, 0 to 9, if it is given ([TRC-TIP-01]).
    pub orientation: Option<u8>,
}

impl Tool {
    /// A tool of this radius, without wear or orientation.
    pub fn of_radius(radius: Rational) -> Self {
        Tool { geometry: radius, ..Tool::default() }
    }

    /// The radius that it puts in force: geometry and wear.
    pub fn radius(&self) -> Rational {
        Rational::from(&self.geometry + &self.wear)
    }
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

    /// The same table with another tool in the place of this number.
    pub fn with_tool(mut self, number: u32, tool: Tool) -> Self {
        self.tools.insert(number, tool);
        self
    }

    /// The same table with a tool of a radius alone, in millimetres, in the place of this number.
    pub fn with_radius(self, number: u32, radius: Rational) -> Self {
        self.with_tool(number, Tool::of_radius(radius))
    }

    /// The tool of an offset number; none if the table does not have it.
    pub fn tool(&self, number: u32) -> Option<&Tool> {
        self.tools.get(&number)
    }

    /// The table as a file's text; none if a size has no finite decimal.
    pub fn to_toml(&self) -> Option<String> {
        let mut text = String::new();
        for (number, tool) in &self.tools {
            let separator = if text.is_empty() { "" } else { "\n" };
            let radius = format_decimal(&tool.geometry)?;
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{separator}[[tool]]\nnumber = {number}\nradius = \"{radius}\"");
            if !tool.wear.is_zero() {
                let _ = writeln!(text, "wear = \"{}\"", format_decimal(&tool.wear)?);
            }
            if let Some(orientation) = tool.orientation {
                let _ = writeln!(text, "orientation = {orientation}");
            }
        }
        Some(text)
    }

    /// Which numbers there are, for people.
    pub(super) fn listed(&self) -> String {
        const MOST: usize = 8;
        let mut numbers: Vec<String> = self.tools.keys().take(MOST).map(u32::to_string).collect();
        if self.tools.len() > MOST {
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
        let (number, tool) = parse_tool(table, tool.span())?;
        if tools.tools.insert(number.into_inner(), tool).is_some() {
            let number = &table["number"];
            return Err(wrong(number.span(), "this number stands in the table already"));
        }
    }
    Ok(tools)
}

fn parse_tool(table: &DeTable<'_>, place: Range<usize>) -> Result<(Spanned<u32>, Tool), LineFault> {
    check_keys(table, &["number", "radius", "diameter", "wear", "orientation"])?;
    let given = table.get("number").ok_or_else(|| wrong(place.clone(), "`number` is missing"))?;
    let number = whole(given.get_ref()).filter(|number| (1..=MOST_NUMBER).contains(number));
    let number = number.ok_or_else(|| wrong(given.span(), format!("a number from 1 to {MOST_NUMBER}")))?;
    let orientation = table.get("orientation").map(orientation).transpose()?;
    let geometry = match (table.get("radius"), table.get("diameter")) {
        (Some(radius), None) => size(radius)?,
        (None, Some(diameter)) => size(diameter)? / 2,
        (Some(_), Some(diameter)) => return Err(wrong(diameter.span(), "the radius of this tool is given already")),
        (None, None) => return Err(wrong(place, "`radius` or `diameter` is missing")),
    };
    let wear = table.get("wear").map(size).transpose()?.unwrap_or_default();
    Ok((Spanned::new(given.span(), number), Tool { geometry, wear, orientation }))
}

fn orientation(given: &Spanned<DeValue<'_>>) -> Result<u8, LineFault> {
    let number = whole(given.get_ref()).and_then(|number| u8::try_from(number).ok()).filter(|number| *number <= 9);
    number.ok_or_else(|| wrong(given.span(), "an orientation is a whole number from 0 to 9"))
}

/// A radius, a diameter or a wear.
fn size(given: &Spanned<DeValue<'_>>) -> Result<Rational, LineFault> {
    let message = || "a decimal in quotes, such as \"0.8\"";
    let text = given.get_ref().as_str().ok_or_else(|| wrong(given.span(), message()))?;
    let (digits, decimals) = text.split_once('.').unwrap_or((text, ""));
    if digits.trim_start_matches(['+', '-']).len() > MOST_DIGITS || decimals.len() > MOST_DIGITS {
        let message = format!("a size has at most {MOST_DIGITS} digits before its point and {MOST_DIGITS} after it");
        return Err(wrong(given.span(), message));
    }
    parse_decimal(text).ok_or_else(|| wrong(given.span(), message()))
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
