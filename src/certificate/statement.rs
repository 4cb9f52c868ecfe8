//! The statement and its signature.

use std::fmt;

use ed25519_dalek::{Signature, VerifyingKey};
use serde::{Deserialize, Serialize};

use super::key::Key;
use crate::report::{Binary, Buckets, ExpectedFailure, FileRecord, GradeRecord, Report, hex};

/// The number of this format.
pub const FORMAT: u64 = 1;

/// A signed statement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Certificate {
    /// What is certified.
    pub statement: Statement,
    /// The signer's Ed25519 key, as hexadecimal digits.
    pub public_key: String,
    /// The signature of the statement, as hexadecimal digits.
    pub signature: String,
}

/// What is certified. Each field but the last two is the report's of the same name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "each is the field of Report with its name")]
pub struct Statement {
    pub format: u64,
    pub radcomp: String,
    pub commit: String,
    pub device: String,
    pub device_version: Option<String>,
    pub device_files: Vec<FileRecord>,
    pub profile: String,
    pub profile_sha256: String,
    pub level: Option<u8>,
    pub seed: u64,
    pub generated_programs: u64,
    pub programs: u64,
    pub grade: GradeRecord,
    pub delta_mm: Binary,
    pub counts: Buckets,
    pub expected_failures: Vec<ExpectedFailure>,
    /// SHA-256 of the report's file.
    pub report_sha256: String,
    /// What the report supports.
    pub theorem: String,
    /// What it does not.
    pub limits: Vec<String>,
}

impl Statement {
    /// The statement of a report whose file has this hash.
    pub fn of(report: &Report, report_sha256: &str) -> Statement {
        Statement {
            format: FORMAT,
            radcomp: report.radcomp.clone(),
            commit: report.commit.clone(),
            device: report.device.clone(),
            device_version: report.device_version.clone(),
            device_files: report.device_files.clone(),
            profile: report.profile.clone(),
            profile_sha256: report.profile_sha256.clone(),
            level: report.level,
            seed: report.seed,
            generated_programs: report.generated_programs,
            programs: report.tally.programs,
            grade: report.grade,
            delta_mm: report.delta_mm,
            counts: report.counts,
            expected_failures: report.expected_failures.clone(),
            report_sha256: report_sha256.to_owned(),
            theorem: theorem(report),
            limits: limits(report),
        }
    }

    /// The bytes that are signed.
    ///
    /// # Errors
    ///
    /// If they cannot be written, in words: a fault of the toolkit.
    pub fn bytes(&self) -> Result<Vec<u8>, String> {
        serde_json::to_vec(self).map_err(|error| error.to_string())
    }
}

impl Certificate {
    /// Signs a statement.
    ///
    /// # Errors
    ///
    /// As [`Statement::bytes`].
    pub fn sign(statement: Statement, key: &Key) -> Result<Certificate, String> {
        let signature = hex(&key.sign(&statement.bytes()?));
        Ok(Certificate { statement, public_key: key.public(), signature })
    }

    /// Whether the signature is that of the statement by the key that the certificate names.
    pub fn is_signed(&self) -> bool {
        let bytes = |text: &str| -> Option<Vec<u8>> {
            let pairs = (0..text.len()).step_by(2).map(|at| text.get(at..at + 2));
            pairs.map(|pair| u8::from_str_radix(pair?, 16).ok()).collect()
        };
        let key = bytes(&self.public_key).and_then(|key| VerifyingKey::from_bytes(&key.try_into().ok()?).ok());
        let signature = bytes(&self.signature).and_then(|signature| Signature::from_slice(&signature).ok());
        match (key, signature, self.statement.bytes()) {
            (Some(key), Some(signature), Ok(bytes)) => key.verify_strict(&bytes, &signature).is_ok(),
            _ => false,
        }
    }
}

/// What a green run supports, in one sentence: the numbers of a run, or names that stand for them.
#[derive(Clone, Copy, Debug)]
pub struct Claim<'a> {
    /// How many programs were judged.
    pub programs: &'a str,
    /// How many passed.
    pub pass: &'a str,
    /// How far a point may lie off, in millimetres.
    pub delta: &'a str,
    /// The profile.
    pub profile: &'a str,
    /// How wide the band is.
    pub band: &'a str,
}

impl fmt::Display for Claim<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Claim { programs, pass, delta, profile, band } = self;
        write!(
            f,
            "Of the {programs} programs judged, {pass} pass: the device's path is, to within {delta} mm at every end \
             point and arc centre, the exact outcome of the program under the profile {profile}, or that of a program whose \
             numbers differ from its own by no more than the band of {band}, or the outcome with some decisions taken \
             another way whose exact margins lie within that band."
        )
    }
}

/// What no green run says.
pub const LIMITS: [&str; 5] = [
    "It says nothing of a program that was not judged.",
    "The profile is a reading of documents: that the maker meant the same is not shown.",
    "It is about the path of the tool's centre: not about feed, servo, tool wear or the machine.",
    "The answers are those that the device gave when it was asked: that the same device is sold is not shown. The \
     hashes are of the files that its command names, not of what these load.",
    "Exact answers are counted in the report and not kept in it: that they were given rests on the signer.",
];

/// What a run does not say where some verdict is `admissible-without-witness`.
pub const BARE_ADMISSIBLE: &str =
    "For some answers on other branches in the band no input that has them was constructed.";

fn theorem(report: &Report) -> String {
    let Buckets { pass, expected_failure, unsupported, .. } = report.counts;
    let mut text = Claim {
        programs: &report.tally.programs.to_string(),
        pass: &pass.to_string(),
        delta: &report.delta_mm.text(),
        profile: &report.profile,
        band: report.grade.band(),
    }
    .to_string();
    if expected_failure > 0 {
        text.push_str(&format!(" {expected_failure} programs fail as the waivers say."));
    }
    if unsupported > 0 {
        text.push_str(&format!(" {unsupported} programs use what the device does not support."));
    }
    text
}

fn limits(report: &Report) -> Vec<String> {
    let mut limits: Vec<String> = LIMITS.map(str::to_owned).into();
    if report.tally.verdicts.get("admissible-without-witness").is_some_and(|count| *count > 0) {
        limits.push(BARE_ADMISSIBLE.to_owned());
    }
    limits
}
