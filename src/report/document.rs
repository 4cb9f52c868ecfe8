//! The report itself: reading and writing.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use radcomp_spec::profile::Profile;
use serde::{Deserialize, Serialize};

use super::case::{Case, Cases};
use super::error::ReportError;
use super::number::Binary;
use super::parameters::ParametersRecord;
use super::tally::TallyRecord;
use crate::certify::Tally;
use crate::judge::{Budget, Grade};
use crate::metamorphic::Broken;

/// The number of this format; it changes when a reader of the old one would misread the new one.
pub const FORMAT: u64 = 1;

/// The most bytes of a report that is read.
pub const MOST_BYTES: u64 = 64 << 20;

/// The JSON Schema of a report.
pub const SCHEMA: &str = include_str!("report.schema.json");

/// A certification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Report {
    /// [`FORMAT`].
    pub format: u64,
    /// The version of the toolkit that wrote it.
    pub radcomp: String,
    /// The device.
    pub device: String,
    /// The name of the control's profile.
    pub profile: String,
    /// Least input increment of the control.
    pub least_increment_mm: Binary,
    /// What the compensation reads of the profile.
    pub parameters: ParametersRecord,
    /// Seed of the generated programs.
    pub seed: u64,
    /// How many of them.
    pub generated_programs: u64,
    /// How wide the band around a decision is.
    pub grade: GradeRecord,
    /// How far a point may lie from where its branch puts it.
    pub delta_mm: Binary,
    /// The smallest share of the band under which the device would still pass, as far as the witnesses found tell; none if
    /// it does not pass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub needed_share_of_beta: Option<Binary>,
    /// Programs that the device failed, and relations that it broke.
    pub red: u64,
    /// The counts.
    pub tally: TallyRecord,
    /// Failures of one cause, with the smallest program of each.
    pub causes: Vec<Cause>,
    /// Relations between a program and its images that the device broke.
    pub broken: Vec<BrokenRecord>,
    /// Programs whose answer was not exact, in the order in which they were judged.
    pub cases: Vec<Case>,
    /// How many more there were.
    pub cases_left_out: u64,
}

/// The grade of the band.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GradeRecord {
    /// 2⁻⁴⁰ times the largest number of each program.
    Binary64,
    /// Half the least input increment.
    Resolution,
}

/// Failures that have their clause and their kind of difference in common. For people; a checker has no use for it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cause {
    /// Clause and kind.
    pub cause: String,
    /// How many programs.
    pub programs: u64,
    /// The smallest failure, in words.
    pub smallest: String,
    /// What its path does to the part, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub safety: Option<String>,
    /// Its program as G-code, if the profile can write it.
    pub program: Option<String>,
    /// The tool table of that program.
    pub tools: Option<String>,
}

/// A relation between a program and its image that the device broke. For people, as causes are.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BrokenRecord {
    /// The program's name.
    pub name: String,
    /// The relation.
    pub relation: String,
    /// What differs, in words.
    pub difference: String,
}

impl BrokenRecord {
    /// The record of a relation that the generated program with this number breaks.
    pub fn new(number: u64, broken: &Broken) -> BrokenRecord {
        BrokenRecord {
            name: format!("#{number}"),
            relation: broken.relation.to_owned(),
            difference: broken.difference.clone(),
        }
    }
}

/// What was certified, and how.
#[derive(Clone, Copy, Debug)]
pub struct Head<'a> {
    /// The device's name.
    pub device: &'a str,
    /// The control.
    pub profile: &'a Profile,
    /// Seed of the generated programs.
    pub seed: u64,
    /// How many of them.
    pub generated_programs: u64,
    /// The budgets.
    pub budget: &'a Budget,
}

impl Report {
    /// The report of a campaign.
    pub fn new(head: Head<'_>, tally: &Tally, causes: Vec<Cause>, broken: Vec<BrokenRecord>, cases: Cases) -> Report {
        let (cases, cases_left_out) = cases.into_parts();
        Report {
            format: FORMAT,
            radcomp: env!("CARGO_PKG_VERSION").to_owned(),
            device: head.device.to_owned(),
            profile: head.profile.name.clone(),
            least_increment_mm: Binary(head.budget.least_increment),
            parameters: ParametersRecord::from(&head.profile.parameters),
            seed: head.seed,
            generated_programs: head.generated_programs,
            grade: match head.budget.grade {
                Grade::Binary64 => GradeRecord::Binary64,
                Grade::Resolution => GradeRecord::Resolution,
            },
            delta_mm: Binary(head.budget.delta),
            needed_share_of_beta: tally.needed_share().map(Binary),
            red: tally.red(),
            tally: TallyRecord::from(tally),
            causes,
            broken,
            cases,
            cases_left_out,
        }
    }

    /// Writes the report.
    ///
    /// # Errors
    ///
    /// If the output fails.
    pub fn write(&self, mut out: impl Write) -> io::Result<()> {
        serde_json::to_writer_pretty(&mut out, self)?;
        out.write_all(b"\n")?;
        out.flush()
    }

    /// Reads a report.
    ///
    /// # Errors
    ///
    /// [`ReportError::Malformed`] with line and column, or [`ReportError::OtherFormat`].
    pub fn parse(text: &str) -> Result<Report, ReportError> {
        /// As much as every format has in common.
        #[derive(Deserialize)]
        struct AnyFormat {
            format: u64,
        }
        let AnyFormat { format } = serde_json::from_str(text).map_err(ReportError::Malformed)?;
        if format != FORMAT {
            return Err(ReportError::OtherFormat { found: format });
        }
        serde_json::from_str(text).map_err(ReportError::Malformed)
    }

    /// Reads a report file of at most [`MOST_BYTES`] bytes.
    ///
    /// # Errors
    ///
    /// Every [`ReportError`].
    pub fn open(file: &Path) -> Result<Report, ReportError> {
        let unreadable = |reason| ReportError::Unreadable { file: file.to_owned(), reason };
        let mut text = String::new();
        let limit = MOST_BYTES.saturating_add(1);
        File::open(file).map_err(unreadable)?.take(limit).read_to_string(&mut text).map_err(unreadable)?;
        if text.len() as u64 > MOST_BYTES {
            return Err(ReportError::TooLarge { file: file.to_owned() });
        }
        Report::parse(&text)
    }
}
