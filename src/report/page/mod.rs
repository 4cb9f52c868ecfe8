//! A report as one HTML page that needs nothing else: no file, no network.

use minijinja::{Environment, context};
use radcomp_spec::catalogue::Catalogue;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Parameters, clause};
use serde::Serialize;

use super::document::Report;
use super::replay::replay;
use super::tally::ClauseTallyRecord;
use crate::explain::{Axes, first_sentence};
use crate::plot::comparison;

/// A row of the clause matrix.
#[derive(Serialize)]
struct Row<'a> {
    id: &'static str,
    title: &'static str,
    sentence: String,
    chapter: &'static str,
    state: &'static str,
    tally: &'a ClauseTallyRecord,
}

/// The page of a report. `file` is the report's file name, for the commands that the page shows.
///
/// # Errors
///
/// If the template fails, in words: a fault of the toolkit.
pub fn page(report: &Report, file: &str) -> Result<String, String> {
    let none = ClauseTallyRecord::default();
    let catalogue = Catalogue::builtin();
    let rows: Vec<_> = clause::ALL
        .iter()
        .map(|(clause, title)| {
            let tally = report.tally.clauses.get(clause.id()).unwrap_or(&none);
            let chapter = catalogue.text_of(*clause).map_or("", |text| catalogue.chapters[text.chapter].title);
            let sentence = first_sentence(*clause);
            Row { id: clause.id(), title, sentence, chapter, state: state(tally), tally }
        })
        .collect();
    let mut chapters: Vec<_> = rows.iter().map(|row| row.chapter).collect();
    chapters.dedup();
    let mut environment = Environment::new();
    environment
        .add_template("report.html", include_str!("report.html"))
        .and_then(|()| environment.get_template("report.html"))
        .and_then(|template| {
            template.render(context! {
                report, rows, chapters, file,
                pictures => pictures(report),
                replays => report.causes.iter().map(|cause| replay(file, &cause.cause)).collect::<Vec<_>>(),
                reasons => report.tally.unsupported.by_frequency(),
                style => include_str!("report.css"),
                script => include_str!("report.js"),
                verdict => verdict(report),
            })
        })
        .map_err(|error| format!("{error:#}"))
}

/// The page's word for a clause's counts.
fn state(tally: &ClauseTallyRecord) -> &'static str {
    match tally {
        tally if tally.failed > 0 => "fail",
        tally if tally.expected_failures > 0 => "expected",
        tally if tally.programs == 0 => "unreached",
        tally if tally.unsupported > 0 => "unsupported",
        _ => "pass",
    }
}

fn verdict(report: &Report) -> &'static str {
    match (report.red, report.counts.unsupported) {
        (0, 0) => "PASS",
        (0, _) => "INCOMPLETE",
        _ => "RED",
    }
}

/// A picture for each cause, empty where there is none.
fn pictures(report: &Report) -> Vec<String> {
    let Ok(profile) = Profile::parse(&report.profile_file, &report.profile) else { return Vec::new() };
    let axes = Axes { plane: profile.machine.plane, x_words: profile.machine.x_words };
    let parameters = Parameters::from(&report.parameters);
    let picture = |(index, cause): (usize, &super::Cause)| {
        let case = cause.case.as_ref();
        case.map(|case| comparison(case, &parameters, axes, &format!("c{index}"), &cause.cause)).unwrap_or_default()
    };
    report.causes.iter().enumerate().map(picture).collect()
}
