//! Waivers: failures that are accepted, each with its reason.
//!
//! ```toml
//! [[waiver]]
//! clause = "TRC-CORNER-08"
//! difference = "end point"             # optional: only this kind of difference
//! element = "line"                     # optional: only where the rules' first element that differs is such a one
//! rule-alarm = "none"                  # optional: only where the rules raise this alarm, or none
//! device-alarm = "reversed-line"       # optional: only where the device raises this alarm, or none
//! program = "#1234"                    # optional: only this program
//! reason = "acute corners are rounded off; told to customers in the manual"
//! ```
//!
//! A waiver covers programs whose first divergence lies at its clause. A device that gives no answer has not diverged at any
//! clause, and a broken relation is of no program alone: neither can be waived. Where the rules' path has ended, the element
//! that differs is the device's.

use std::{fmt, ops::Range};

use radcomp_spec::{Alarm, AlarmKind, Clause, clause};
use serde::Deserialize;
use toml::Spanned;

use super::failure::kind;
use crate::judge::{Divergence, Judged, Shape, Verdict};

/// One waiver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Waiver {
    /// The clause at which the programs first differ.
    pub clause: Clause,
    /// The program's name, if it is for one.
    pub program: Option<String>,
    /// The kind of difference, as the name of a cause tells it, if it is for one.
    pub difference: Option<String>,
    /// The shape of the first element that differs, `line`, `arc` or `hold`, if it is for one.
    pub element: Option<String>,
    /// The alarm of the rules, or `none`, if it is for one.
    pub rule_alarm: Option<String>,
    /// The alarm of the device, or `none`, if it is for one.
    pub device_alarm: Option<String>,
    /// Why these failures are accepted.
    pub reason: String,
}

/// What an element is called.
const ELEMENTS: [&str; 3] = ["line", "arc", "hold"];
/// What a path without an alarm ends in.
const NO_ALARM: &str = "none";

/// Every waiver of a campaign; the first that fits a failure covers it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Waivers(pub Vec<Waiver>);

/// What is wrong with a file of waivers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WaiverError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub reason: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    waiver: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
struct Entry {
    clause: Spanned<String>,
    program: Option<String>,
    difference: Option<String>,
    element: Option<Spanned<String>>,
    rule_alarm: Option<Spanned<String>>,
    device_alarm: Option<Spanned<String>>,
    reason: Spanned<String>,
}

impl Waivers {
    /// Reads a file of waivers.
    ///
    /// # Errors
    ///
    /// The first fault of the file, with its line: it is not TOML, a key is missing or unknown, there is no such clause, or
    /// a reason says nothing.
    pub fn parse(text: &str) -> Result<Waivers, WaiverError> {
        let at = |place: Range<usize>, reason: String| WaiverError {
            line: text[..place.start.min(text.len())].matches('\n').count() + 1,
            reason,
        };
        let file: File =
            toml::from_str(text).map_err(|error| at(error.span().unwrap_or_default(), error.message().to_owned()))?;
        let read = |entry: Entry| {
            let id = entry.clause.get_ref();
            let known = clause::ALL.iter().find(|(clause, _)| clause.id() == id);
            let (clause, _) = known.ok_or_else(|| at(entry.clause.span(), format!("there is no clause {id}")))?;
            if entry.reason.get_ref().trim().is_empty() {
                return Err(at(entry.reason.span(), "a waiver needs a reason".to_owned()));
            }
            let word = |word: Option<Spanned<String>>, known: &dyn Fn(&str) -> bool| match word {
                Some(word) if !known(word.get_ref()) => {
                    Err(at(word.span(), format!("there is nothing called {:?} here", word.get_ref())))
                }
                word => Ok(word.map(Spanned::into_inner)),
            };
            let is_element = |word: &str| ELEMENTS.contains(&word);
            let is_alarm = |word: &str| word == NO_ALARM || AlarmKind::ALL.iter().any(|kind| kind.id() == word);
            Ok(Waiver {
                clause: *clause,
                program: entry.program,
                difference: entry.difference,
                element: word(entry.element, &is_element)?,
                rule_alarm: word(entry.rule_alarm, &is_alarm)?,
                device_alarm: word(entry.device_alarm, &is_alarm)?,
                reason: entry.reason.into_inner(),
            })
        };
        file.waiver.into_iter().map(read).collect::<Result<_, _>>().map(Waivers)
    }

    /// The place of the waiver that covers a program of this name, judged so.
    pub fn covering(&self, name: &str, judged: &Judged) -> Option<usize> {
        let (Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence)) = &judged.verdict else { return None };
        let (rule, device) = (judged.exact.alarm, judged.answer.as_ref().and_then(|answer| answer.alarm));
        let is = |wanted: &Option<String>, word: &str| wanted.as_ref().is_none_or(|wanted| wanted == word);
        self.0.iter().position(|waiver| {
            waiver.clause == divergence.clause
                && is(&waiver.program, name)
                && is(&waiver.difference, kind(&divergence.difference))
                && is(&waiver.element, element(divergence))
                && is(&waiver.rule_alarm, alarm(rule))
                && is(&waiver.device_alarm, alarm(device))
        })
    }
}

/// The shape of the first element that differs; nothing where the paths are the same.
fn element(divergence: &Divergence) -> &'static str {
    let stroke = divergence.expected.as_ref().or(divergence.observed.as_ref());
    stroke.map_or("", |stroke| match stroke.shape {
        Shape::Line => "line",
        Shape::Arc { .. } => "arc",
        Shape::Hold => "hold",
    })
}

fn alarm(alarm: Option<Alarm>) -> &'static str {
    alarm.map_or(NO_ALARM, |alarm| alarm.kind.id())
}

impl fmt::Display for Waiver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.clause)?;
        if let Some(difference) = &self.difference {
            write!(f, " {difference}")?;
        }
        let more = [
            ("element", &self.element),
            ("the rules' alarm", &self.rule_alarm),
            ("the device's alarm", &self.device_alarm),
            ("program", &self.program),
        ];
        more.iter()
            .filter_map(|(name, word)| Some((name, word.as_ref()?)))
            .try_for_each(|(name, word)| write!(f, ", {name} {word}"))
    }
}

impl fmt::Display for WaiverError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl std::error::Error for WaiverError {}
