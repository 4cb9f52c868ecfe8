//! The form of an example: `spec/README.md`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use radcomp_model::number::Real;
use radcomp_spec::profile::{PARAMETERS, Profile};
use rug::Rational;
use serde::Deserialize;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Example {
    name: Option<String>,
    #[expect(dead_code, reason = "for people")]
    story: Option<String>,
    profile: String,
    radius: Option<String>,
    wear: Option<String>,
    pub tip: Option<usize>,
    #[serde(default)]
    tools: BTreeMap<String, String>,
    #[serde(default)]
    set: toml::Table,
    pub program: String,
    #[serde(default)]
    pub path: Vec<String>,
    pub tip_path: Option<Vec<String>>,
    pub alarm: Option<String>,
    pub advisories: Option<Vec<String>>,
    pub error: Option<String>,
}

/// The vectors of a file, with their names.
pub fn vectors(text: &str) -> Vec<(String, Example)> {
    #[derive(Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        vector: Vec<Example>,
    }
    let file: File = toml::from_str(text).expect("a file of vectors");
    file.vector.into_iter().map(|vector| (vector.name.clone().expect("a vector has a name"), vector)).collect()
}

/// A number of an example.
pub fn number(text: &str) -> Real {
    Real::parse(text).unwrap_or_else(|fault| panic!("{text:?} is not a number: {fault:?}"))
}

fn rational(text: &str) -> Rational {
    number(text).as_rational().unwrap_or_else(|| panic!("{text:?} is not rational")).clone()
}

impl Example {
    pub fn read(text: &str) -> Example {
        toml::from_str(text).unwrap_or_else(|fault| panic!("{fault}\n{text}"))
    }

    /// The profile with the changes of this example.
    pub fn profile(&self) -> Profile {
        let mut text = format!("name = \"example\"\ntitle = \"example\"\nextends = \"{}\"\n", self.profile);
        for (name, value) in &self.set {
            let parameter = PARAMETERS.iter().find(|parameter| parameter.name() == name);
            let parameter = parameter.unwrap_or_else(|| panic!("no parameter {name}"));
            let (table, clause) = (parameter.table(), parameter.clause);
            writeln!(text, "{table}.{name} = {{ value = {value}, source = \"D\", clause = \"{clause}\" }}")
                .expect("writing to a string");
        }
        Profile::parse(&text, "example").unwrap_or_else(|fault| panic!("{fault}"))
    }

    /// The tool radius of an offset number, geometry and wear together; none for number 0.
    pub fn offset(&self, number: u32) -> Option<Rational> {
        match number {
            0 => None,
            1 => {
                let geometry = rational(self.radius.as_ref().expect("the example selects tool 1"));
                Some(geometry + self.wear.as_ref().map_or_else(Rational::new, |wear| rational(wear)))
            }
            _ => Some(rational(self.tools.get(&number.to_string()).expect("a tool of the example"))),
        }
    }
}
