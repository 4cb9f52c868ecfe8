//! Reading the table of alarms of a profile file.

use toml::Spanned;
use toml::de::DeValue;

use super::error::ProfileError;
use super::read::{Source, Table};
use super::{AlarmNumber, Profile};
use crate::outcome::AlarmKind;

impl Source<'_> {
    /// Reads the table of alarms: each alarm's number with its source, and the list of those that have none.
    pub(super) fn alarms(&self, root: &Table<'_>, profile: &mut Profile) -> Result<(), ProfileError> {
        let numbered = "a table of alarms, each { value = …, source = … }, the others listed in `unnumbered`";
        let Some(value) = root.get("alarms") else {
            let inherited = !profile.alarms.is_empty();
            return if inherited { Ok(()) } else { Err(self.missing(&(0..0), "alarms", numbered)) };
        };
        let Some(table) = value.get_ref().as_table() else {
            return Err(self.wrong(value.span(), "alarms", numbered));
        };
        let names: Vec<&str> = AlarmKind::ALL.iter().map(|kind| kind.id()).chain(["unnumbered"]).collect();
        self.known(table, "alarms", &names)?;
        let listed = self.unnumbered(table)?;
        let mut alarms = Vec::new();
        for kind in AlarmKind::ALL {
            let key = format!("alarms.{}", kind.id());
            alarms.push(match (table.get(kind.id()), listed.contains(&kind.id())) {
                (Some(given), false) => self.alarm(*kind, &key, given)?,
                (None, true) => AlarmNumber { kind: *kind, number: None, source: String::new() },
                (Some(given), true) => return Err(self.wrong(given.span(), &key, "numbered or unnumbered, not both")),
                (None, false) => match profile.alarms.iter().find(|inherited| inherited.kind == *kind) {
                    Some(inherited) => inherited.clone(),
                    None => return Err(self.missing(&value.span(), &key, numbered)),
                },
            });
        }
        profile.alarms = alarms;
        Ok(())
    }

    /// The alarms listed as having no number.
    fn unnumbered(&self, table: &Table<'_>) -> Result<Vec<&'static str>, ProfileError> {
        let Some(list) = table.get("unnumbered") else { return Ok(Vec::new()) };
        let kinds = "a list of alarms, in quotes";
        let entries = list.get_ref().as_array().ok_or_else(|| self.wrong(list.span(), "alarms.unnumbered", kinds))?;
        let mut listed = Vec::new();
        for entry in entries {
            let kind = AlarmKind::ALL.iter().find(|kind| entry.get_ref().as_str() == Some(kind.id()));
            listed.push(kind.ok_or_else(|| self.wrong(entry.span(), "alarms.unnumbered", kinds))?.id());
        }
        Ok(listed)
    }

    /// Reads one alarm: `{ value = "…", source = "…" }`.
    fn alarm(&self, kind: AlarmKind, key: &str, given: &Spanned<DeValue<'_>>) -> Result<AlarmNumber, ProfileError> {
        let form = "{ value = \"the control's number or text\", source = \"D\" }";
        let table = given.get_ref().as_table().ok_or_else(|| self.wrong(given.span(), key, form))?;
        self.known(table, key, &["value", "source"])?;
        let number = self.text_of(table, "value", &format!("{key}.value"), "a text in quotes", &given.span())?;
        let source = self.source_of(table, key, &given.span())?;
        Ok(AlarmNumber { kind, number: Some(number.into_inner().to_owned()), source })
    }
}
