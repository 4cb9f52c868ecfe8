//! `radcomp profiles`.

use std::io::Write;

use clap::Args;
use radcomp_spec::profile::{AlarmNumber, BUILTIN, PARAMETERS, Profile};

use super::failure::{Failure, Verdict};
use super::options::profile;
use super::terminal::{self, bold};

/// List the control profiles, or every parameter of one with its value, source and clause, and its alarms
#[derive(Debug, Args)]
#[command(after_help = "\
Sources: S:… read in that source, K known from well-known manuals, I derived,
D decided by this project.

Examples:
  radcomp profiles
  radcomp profiles yasnac-lx
  radcomp profiles my-lathe.toml")]
pub struct Profiles {
    /// A built-in profile or a profile file
    #[arg(value_name = "NAME|FILE.toml")]
    name: Option<String>,
}

impl Profiles {
    /// Prints the list or the profile.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let text = match &self.name {
            None => list(),
            Some(name) => page(&profile(name)?),
        };
        let mut out = terminal::output();
        out.write_all(text.as_bytes())?;
        out.flush()?;
        Ok(Verdict::Green)
    }
}

fn list() -> String {
    let width = BUILTIN.iter().map(|(name, _)| name.len()).max().unwrap_or_default();
    let profiles = BUILTIN.iter().filter_map(|(name, _)| Profile::builtin(name));
    profiles.map(|profile| format!("{:<width$}  {}\n", profile.name, profile.title)).collect()
}

fn page(profile: &Profile) -> String {
    let mut text = format!("{}\n{}\n", bold(&profile.name), profile.title);
    let width = |of: fn(&str, &str, &str) -> usize| {
        let rows = profile.provenance.iter();
        rows.map(|row| of(row.parameter, &row.value, &row.source)).max().unwrap_or_default()
    };
    let (names, values) = (width(|name, _, _| name.chars().count()), width(|_, value, _| value.chars().count()));
    let sources = width(|_, _, source| source.chars().count());
    let mut table = "";
    for (row, parameter) in profile.provenance.iter().zip(PARAMETERS) {
        if parameter.table() != table {
            table = parameter.table();
            text.push('\n');
        }
        let clause = row.clause.id();
        text.push_str(&format!(
            "{:<names$}  {:<values$}  {:<sources$}  {clause:<14}  {}\n",
            row.parameter, row.value, row.source, parameter.meaning
        ));
    }
    text.push_str(&alarms(profile));
    text
}

/// What the control calls its alarms.
fn alarms(profile: &Profile) -> String {
    let name = |alarm: &AlarmNumber| alarm.number.clone().unwrap_or_else(|| "no number in the sources".to_owned());
    let width = profile.alarms.iter().map(|alarm| alarm.kind.id().len()).max().unwrap_or_default();
    let rows = profile.alarms.iter().map(|alarm| {
        let source = if alarm.source.is_empty() { String::new() } else { format!(" ({})", alarm.source) };
        format!("alarm {:<width$}  {:<14}  {}{source}\n", alarm.kind.id(), alarm.kind.clause().id(), name(alarm))
    });
    std::iter::once("\n".to_owned()).chain(rows).collect()
}
