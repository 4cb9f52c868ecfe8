//! Vectors: programs with outcomes worked out by hand, and what compares the model with them.
//!
//! They stand in `tests/vectors/*.toml` and as the worked examples of the clauses. A coordinate is an exact expression;
//! the model must give exactly that number.

mod expect;

use std::collections::BTreeMap;
use std::sync::LazyLock;

use radcomp_model::number::parse_decimal;
use radcomp_spec::catalogue::Catalogue;
use radcomp_spec::profile::{BUILTIN, Profile};
use serde::Deserialize;

use crate::gcode::{self, Program, Tool, Tools};

pub use expect::mismatch;

/// A vector as its file writes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vector {
    /// Its name; for a clause's example, the clause and the line of its text.
    #[serde(default)]
    pub name: String,
    /// Why it is there.
    #[serde(default)]
    pub story: String,
    /// The profile it runs under.
    pub profile: String,
    /// Radius of tool 1, in millimetres; there is no tool if it is absent.
    pub radius: Option<String>,
    /// Wear of tool 1, in millimetres; 0 if it is absent ([TRC-TIP-02]).
    pub wear: Option<String>,
    /// Tip orientation of tool 1 ([TRC-TIP-01]).
    pub tip: Option<u8>,
    /// Radii of further tools by number, in millimetres.
    #[serde(default)]
    pub tools: BTreeMap<String, String>,
    /// Parameters that it changes.
    #[serde(default)]
    pub set: toml::Table,
    /// The program.
    pub program: String,
    /// The expected path, one element a string: line, kind, numbers, clause.
    #[serde(default)]
    pub path: Vec<String>,
    /// The expected tip at the end of each step but the holds, two coordinates a string; not checked if absent.
    #[serde(rename = "tip-path")]
    pub tip_path: Option<Vec<String>>,
    /// The expected alarm: line and kind.
    pub alarm: Option<String>,
    /// The expected advisories: line, kind, amount; not checked if absent.
    pub advisories: Option<Vec<String>>,
    /// The expected refusal of the reader: line and a part of the message.
    pub error: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VectorFile {
    vector: Vec<Vector>,
}

const FILES: &[(&str, &str)] = &[
    ("seed-000", include_str!("../../tests/vectors/seed-000.toml")),
    ("seed-001", include_str!("../../tests/vectors/seed-001.toml")),
    ("seed-003", include_str!("../../tests/vectors/seed-003.toml")),
    ("tv-1", include_str!("../../tests/vectors/tv-1.toml")),
    ("tv-2", include_str!("../../tests/vectors/tv-2.toml")),
    ("tv-3", include_str!("../../tests/vectors/tv-3.toml")),
    ("tv-4", include_str!("../../tests/vectors/tv-4.toml")),
    ("tv-5", include_str!("../../tests/vectors/tv-5.toml")),
    ("tv-8", include_str!("../../tests/vectors/tv-8.toml")),
    ("tv-10", include_str!("../../tests/vectors/tv-10.toml")),
    ("edges", include_str!("../../tests/vectors/edges.toml")),
    ("interference", include_str!("../../tests/vectors/interference.toml")),
    ("magnitudes", include_str!("../../tests/vectors/magnitudes.toml")),
];

/// The vectors of `tests/vectors`, and the worked examples of every clause, each with the clause's id as its name.
pub fn all() -> &'static [Result<Vector, String>] {
    static ALL: LazyLock<Vec<Result<Vector, String>>> = LazyLock::new(|| {
        let mut vectors = Vec::new();
        for (file, text) in FILES {
            match toml::from_str::<VectorFile>(text) {
                Ok(file) => vectors.extend(file.vector.into_iter().map(Ok)),
                Err(error) => vectors.push(Err(format!("tests/vectors/{file}.toml: {error}"))),
            }
        }
        for clause in &Catalogue::builtin().clauses {
            for (index, example) in clause.examples.iter().enumerate() {
                let place = format!("{} example {} (line {})", clause.clause, index + 1, example.line);
                vectors.push(match toml::from_str::<Vector>(example.text) {
                    Ok(vector) => Ok(Vector { name: place, ..vector }),
                    Err(error) => Err(format!("{place}: {error}")),
                });
            }
        }
        vectors
    });
    &ALL
}

impl Vector {
    /// The vector's profile: a built-in one, with the parameters that the vector sets.
    ///
    /// # Errors
    ///
    /// A profile or parameter that does not exist, in words.
    pub fn profile(&self) -> Result<Profile, String> {
        if self.set.is_empty() {
            return Profile::builtin(&self.profile).ok_or_else(|| {
                let known: Vec<_> = BUILTIN.iter().map(|(name, _)| *name).collect();
                format!("no profile {}; there are {}", self.profile, known.join(", "))
            });
        }
        Profile::changed(&self.profile, "vector", &self.set).map_err(|error| error.to_string())
    }

    /// The vector's program, read under its profile with its tool; the reader's refusal if it refuses.
    ///
    /// # Errors
    ///
    /// The outer error is a fault of the vector itself.
    pub fn read(&self, profile: &Profile) -> Result<Result<Program, gcode::Diagnostic>, String> {
        let decimal =
            |what: &str, text: &str| parse_decimal(text).ok_or_else(|| format!("{what} {text:?} is no decimal"));
        let mut tools = Tools::empty();
        if let Some(radius) = &self.radius {
            let wear = self.wear.as_deref().map(|wear| decimal("wear", wear)).transpose()?.unwrap_or_default();
            tools = tools.with_tool(1, Tool { geometry: decimal("radius", radius)?, wear, orientation: self.tip });
        }
        for (number, radius) in &self.tools {
            let number = number.parse().map_err(|_| format!("tool {number:?} is no number"))?;
            tools = tools.with_radius(number, decimal("radius", radius)?);
        }
        Ok(gcode::read("program", self.program.as_bytes(), profile, &tools))
    }
}
