//! The controls: how they differ, every parameter, every profile, alarms and decisions.

use std::collections::BTreeMap;

use minijinja::context;
use radcomp_spec::profile::{BUILTIN, PARAMETERS, Profile};
use radcomp_spec::{AdvisoryKind, AlarmKind, DecisionKind};
use serde::Serialize;

use super::index::{Index, Kind};
use super::prose::{Prose, without_tags};
use super::site::Site;

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    table: &'static str,
    meaning: String,
    clause: &'static str,
    target: String,
    allowed: String,
    values: Vec<Value>,
}

/// A value, and the profiles that have it with the source of each.
#[derive(Serialize)]
struct Value {
    value: String,
    profiles: Vec<[String; 2]>,
}

#[derive(Serialize)]
struct Named {
    id: &'static str,
    text: &'static str,
    clause: &'static str,
    target: String,
    /// The controls' own numbers: number, profiles.
    numbers: Vec<(String, Vec<String>)>,
}

/// Adds the pages of the controls.
pub(super) fn pages(site: &mut Site<'_>, index: &mut Index) -> Result<(), String> {
    let profiles: Vec<Profile> = BUILTIN.iter().filter_map(|(name, _)| Profile::builtin(name)).collect();
    parameters(site, index, &profiles)?;
    alarms(site, index, &profiles)?;
    for profile in &profiles {
        one(site, index, profile)?;
    }
    let prose = Prose { bare: true, ..site.documents() };
    let text = include_str!("../../spec/DIALECTS.md");
    // What stands before the tables is for those who edit them.
    let tables = text.find("## ").map_or(text, |start| &text[start..]);
    let opening = "Every value leads from its profile's page to its clause. Source tags: S read in a source, K known from \
                well-known manuals, I derived, D decided by this project.\n\n";
    let body = prose.html(&format!("{opening}{}", with_profile_links(tables, &profiles)));
    let values = context! { body, profiles => profiles.iter().map(head).collect::<Vec<_>>(), dialects => true };
    site.page("dialects.html", "How the controls differ", "document.html", values)
}

fn head(profile: &Profile) -> BTreeMap<&'static str, &str> {
    BTreeMap::from([("name", profile.name.as_str()), ("title", profile.title.as_str())])
}

/// What follows the title line of a document.
pub(super) fn without_title(text: &str) -> &str {
    text.split_once('\n').map_or("", |(_, rest)| rest)
}

/// The heads of the table's columns lead to the profiles.
fn with_profile_links(text: &str, profiles: &[Profile]) -> String {
    let line = |line: &str| {
        if !line.starts_with("| rule |") && !line.starts_with("| alarm |") {
            return line.to_owned();
        }
        let cells = line.split('|').map(|cell| {
            let name = cell.trim();
            match profiles.iter().any(|profile| profile.name == name) {
                true => format!(" [{name}](profile-{name}.html) "),
                false => cell.to_owned(),
            }
        });
        cells.collect::<Vec<_>>().join("|")
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

fn parameters(site: &mut Site<'_>, index: &mut Index, profiles: &[Profile]) -> Result<(), String> {
    let mut shown = Vec::new();
    for parameter in PARAMETERS {
        let mut values: Vec<Value> = Vec::new();
        for profile in profiles {
            let Some(entry) = profile.provenance_of(parameter.key) else { continue };
            let who = [profile.name.clone(), entry.source.clone()];
            match values.iter_mut().find(|value| value.value == entry.value) {
                Some(value) => value.profiles.push(who),
                None => values.push(Value { value: entry.value.clone(), profiles: vec![who] }),
            }
        }
        let meaning = site.clauses().inline(parameter.meaning);
        let words: Vec<_> = values.iter().map(|value| value.value.as_str()).collect();
        let plain = format!("{} {}", without_tags(&meaning), words.join(" "));
        let target = format!("parameters.html#{}", parameter.name());
        index.add(Kind::Parameter, parameter.name(), &target, &plain);
        shown.push(Parameter {
            name: parameter.name(),
            table: parameter.table(),
            meaning,
            clause: parameter.clause.id(),
            target: site.links().clause(parameter.clause.id()).unwrap_or_default().to_owned(),
            allowed: site.documents().inline(&parameter.allowed().replace('"', "`")),
            values,
        });
    }
    site.page("parameters.html", "Parameters of a profile", "parameters.html", context! { parameters => shown })
}

fn alarms(site: &mut Site<'_>, index: &mut Index, profiles: &[Profile]) -> Result<(), String> {
    let target = |clause: radcomp_spec::Clause| site.links().clause(clause.id()).unwrap_or_default().to_owned();
    let mut alarms = Vec::new();
    for kind in AlarmKind::ALL {
        let mut numbers: Vec<(String, Vec<String>)> = Vec::new();
        for profile in profiles {
            let Some(number) = profile.alarm_number(*kind) else { continue };
            match numbers.iter_mut().find(|(known, _)| known == number) {
                Some((_, names)) => names.push(profile.name.clone()),
                None => numbers.push((number.to_owned(), vec![profile.name.clone()])),
            }
        }
        let own: Vec<_> = numbers.iter().map(|(number, _)| number.as_str()).collect();
        index.add(
            Kind::Alarm,
            kind.id(),
            &format!("alarms.html#{}", kind.id()),
            &format!("{} {}", kind.text(), own.join(" ")),
        );
        let (clause, target) = (kind.clause().id(), target(kind.clause()));
        alarms.push(Named { id: kind.id(), text: kind.text(), clause, target, numbers });
    }
    let advisories: Vec<_> = AdvisoryKind::ALL
        .iter()
        .map(|kind| Named {
            id: kind.id(),
            text: kind.text(),
            clause: kind.clause().id(),
            target: target(kind.clause()),
            numbers: Vec::new(),
        })
        .collect();
    let decisions: Vec<_> = DecisionKind::ALL
        .iter()
        .map(|kind| Named {
            id: kind.id(),
            text: kind.margin(),
            clause: kind.clause().id(),
            target: target(kind.clause()),
            numbers: Vec::new(),
        })
        .collect();
    let values = context! { alarms, advisories, decisions };
    site.page("alarms.html", "Alarms, advisories, decisions", "alarms.html", values)
}

fn one(site: &mut Site<'_>, index: &mut Index, profile: &Profile) -> Result<(), String> {
    let page = format!("profile-{}.html", profile.name);
    let rows: Vec<_> = profile
        .provenance
        .iter()
        .map(|entry| {
            let (table, name) = entry.parameter.split_once('.').unwrap_or(("", entry.parameter));
            let target = site.links().clause(entry.clause.id()).unwrap_or_default();
            BTreeMap::from([
                ("table", table),
                ("name", name),
                ("value", entry.value.as_str()),
                ("source", entry.source.as_str()),
                ("clause", entry.clause.id()),
                ("target", target),
            ])
        })
        .collect();
    let alarms: Vec<_> = profile
        .alarms
        .iter()
        .filter_map(|alarm| {
            let number = alarm.number.as_deref()?;
            Some(BTreeMap::from([("id", alarm.kind.id()), ("number", number), ("source", alarm.source.as_str())]))
        })
        .collect();
    index.add(Kind::Profile, &profile.name, &page, &profile.title);
    site.page(
        &page,
        &format!("Profile {}", profile.name),
        "profile.html",
        context! { profile => head(profile), rows, alarms },
    )
}
