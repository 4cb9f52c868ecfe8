//! The report itself: reading and writing.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use radcomp_spec::Clause;
use radcomp_spec::profile::Profile;
use serde::{Deserialize, Serialize};

use super::buckets::Buckets;
use super::case::{Case, Cases};
use super::cause::{BrokenRecord, Cause};
use super::device::{DeviceRecord, FileRecord};
use super::error::ReportError;
use super::hash::sha256;
use super::number::Binary;
use super::parameters::ParametersRecord;
use super::profile::profile_text;
use super::tally::TallyRecord;
use super::word::Id;
use crate::certify::{LedgerRecord, Tally};
use crate::judge::{Budget, Grade};

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
    /// The commit that the toolkit was built from, or `unknown`.
    pub commit: String,
    /// The device.
    pub device: String,
    /// The device's version, if it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device_version: Option<String>,
    /// The files that the device consists of, as far as its name tells them.
    pub device_files: Vec<FileRecord>,
    /// The name of the control's profile.
    pub profile: String,
    /// The profile whole: the text of a file that reads back to it.
    pub profile_file: String,
    /// SHA-256 of that text.
    pub profile_sha256: String,
    /// Least input increment of the control.
    pub least_increment_mm: Binary,
    /// What the compensation reads of the profile.
    pub parameters: ParametersRecord,
    /// The level, if one was run: so many generated programs, vectors and boundary triples.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level: Option<u8>,
    /// Seed of the generated programs.
    pub seed: u64,
    /// How many of them.
    pub generated_programs: u64,
    /// The part of the campaign that was run, if not the whole was: its counts and cases are of that part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shard: Option<ShardRecord>,
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
    /// Programs by what came of them.
    pub counts: Buckets,
    /// The waivers that were given.
    pub expected_failures: Vec<ExpectedFailure>,
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

impl From<GradeRecord> for Grade {
    fn from(record: GradeRecord) -> Grade {
        match record {
            GradeRecord::Binary64 => Grade::Binary64,
            GradeRecord::Resolution => Grade::Resolution,
        }
    }
}

impl GradeRecord {
    /// How wide the band is, in words.
    pub const fn band(self) -> &'static str {
        match self {
            GradeRecord::Binary64 => "2^-40 of the largest number of the program",
            GradeRecord::Resolution => "half the least input increment",
        }
    }
}

/// A part of a campaign, and what `radcomp merge` puts together with the other parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShardRecord {
    /// Which part, from 1.
    pub number: u64,
    /// Of how many.
    pub of: u64,
    /// What its programs gave.
    pub ledger: LedgerRecord,
}

/// A waiver that was given, and what it covered.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExpectedFailure {
    /// The clause at which the programs first differ.
    pub clause: Id<Clause>,
    /// The program's name, if the waiver is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// The kind of difference, if the waiver is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference: Option<String>,
    /// The shape of the first element that differs, if the waiver is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub element: Option<String>,
    /// The alarm of the rules, or `none`, if the waiver is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule_alarm: Option<String>,
    /// The alarm of the device, or `none`, if the waiver is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device_alarm: Option<String>,
    /// Why these failures are accepted.
    pub reason: String,
    /// How many programs.
    pub programs: u64,
}

/// What was certified, and how.
#[derive(Clone, Copy, Debug)]
pub struct Head<'a> {
    /// The device.
    pub device: &'a DeviceRecord,
    /// The level, if one was run.
    pub level: Option<u8>,
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
        let profile_file = profile_text(head.profile);
        Report {
            format: FORMAT,
            radcomp: env!("CARGO_PKG_VERSION").to_owned(),
            commit: option_env!("RADCOMP_COMMIT").unwrap_or("unknown").to_owned(),
            device: head.device.name.clone(),
            device_version: head.device.version.clone(),
            device_files: head.device.files.clone(),
            profile: head.profile.name.clone(),
            profile_sha256: sha256(profile_file.as_bytes()),
            profile_file,
            least_increment_mm: Binary(head.budget.least_increment),
            parameters: ParametersRecord::from(&head.profile.parameters),
            level: head.level,
            seed: head.seed,
            generated_programs: head.generated_programs,
            shard: None,
            grade: match head.budget.grade {
                Grade::Binary64 => GradeRecord::Binary64,
                Grade::Resolution => GradeRecord::Resolution,
            },
            delta_mm: Binary(head.budget.delta),
            needed_share_of_beta: tally.needed_share().map(Binary),
            red: tally.red(),
            counts: tally.counts,
            expected_failures: Vec::new(),
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
