//! Waivers: failures that are accepted, each with its reason.
//!
//! ```toml
//! [[waiver]]
//! clause = "TRC-CORNER-08"
//! difference = "end point"             # optional: only this kind of difference
//! program = "#1234"                    # optional: only this program
//! reason = "acute corners are rounded off; told to customers in the manual"
//! ```
//!
//! A waiver covers programs whose first divergence lies at its clause. A device that gives no answer has not diverged at any
//! clause, and a broken relation is of no program alone: neither can be waived.

use std::{fmt, ops::Range};

use radcomp_spec::{Clause, clause};
use serde::Deserialize;
use toml::Spanned;

use super::failure::kind;
use crate::judge::Verdict;

/// One waiver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Waiver {
    /// The clause at which the programs first differ.
    pub clause: Clause,
    /// The program's name, if it is for one.
    pub program: Option<String>,
    /// The kind of difference, as the name of a cause tells it, if it is for one.
    pub difference: Option<String>,
    /// Why these failures are accepted.
    pub reason: String,
}

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
#[serde(deny_unknown_fields)]
struct Entry {
    clause: Spanned<String>,
    program: Option<String>,
    difference: Option<String>,
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
            let Entry { program, difference, reason, .. } = entry;
            Ok(Waiver { clause: *clause, program, difference, reason: reason.into_inner() })
        };
        file.waiver.into_iter().map(read).collect::<Result<_, _>>().map(Waivers)
    }

    /// The place of the waiver that covers a program of this name with this verdict.
    pub fn covering(&self, name: &str, verdict: &Verdict) -> Option<usize> {
        let (Verdict::Inadmissible(divergence) | Verdict::ForkLimit(divergence)) = verdict else { return None };
        self.0.iter().position(|waiver| {
            waiver.clause == divergence.clause
                && waiver.program.as_ref().is_none_or(|program| program == name)
                && waiver.difference.as_ref().is_none_or(|difference| difference == kind(&divergence.difference))
        })
    }
}

impl fmt::Display for Waiver {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.clause)?;
        if let Some(difference) = &self.difference {
            write!(f, " {difference}")?;
        }
        if let Some(program) = &self.program {
            write!(f, ", program {program}")?;
        }
        Ok(())
    }
}

impl fmt::Display for WaiverError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl std::error::Error for WaiverError {}
