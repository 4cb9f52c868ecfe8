//! `radcomp certificate` and `radcomp verify-certificate`.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use radcomp::certificate::{Certificate as Signed, Key, Statement, objections, objections_to_report, page};
use radcomp::report::{Report, sha256_of_file};

use super::failure::{Failure, Verdict};
use super::terminal::{self, bold};

/// Sign a short statement of what a green report supports and what it does not
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  radcomp certificate report.json --make-key key.pem --output certificate.json
  radcomp certificate report.json --key key.pem --output certificate.json --html certificate.html

Exit status: 0 signed; 1 the report supports no certificate; 2 wrong usage or input.")]
pub struct Certificate {
    /// The report, as `radcomp certify --report` writes it
    #[arg(value_name = "REPORT.json")]
    report: PathBuf,

    /// The private Ed25519 key, in PKCS #8 PEM
    #[arg(long, value_name = "FILE.pem", required_unless_present = "make_key")]
    key: Option<PathBuf>,

    /// Make a new key and write it here; the file must not be there yet
    #[arg(long, value_name = "FILE.pem", conflicts_with = "key")]
    make_key: Option<PathBuf>,

    /// The certificate
    #[arg(long, short, value_name = "FILE.json")]
    output: PathBuf,

    /// The certificate as a page to read
    #[arg(long, value_name = "FILE.html")]
    html: Option<PathBuf>,
}

/// Check a certificate's signature and hashes, and that its report is complete
#[derive(Debug, Args)]
#[command(after_help = "\
The model runs every program of the level again, and the report's counts must be its
counts; every case of the report is checked as `radcomp verify-witness` does.

Examples:
  radcomp verify-certificate certificate.json --report report.json
  radcomp verify-certificate certificate.json --report report.json --public-key 3d40…

Exit status: 0 it is right; 1 it is not; 2 wrong usage or input.")]
pub struct VerifyCertificate {
    /// The certificate
    #[arg(value_name = "CERTIFICATE.json")]
    certificate: PathBuf,

    /// The report that it is of
    #[arg(long, value_name = "REPORT.json")]
    report: PathBuf,

    /// The signer's public key, as hexadecimal digits; without it, that the signer is the right one is not checked
    #[arg(long, value_name = "HEX")]
    public_key: Option<String>,

    /// Do not run the level's programs again
    #[arg(long)]
    quick: bool,
}

impl Certificate {
    /// Signs the certificate.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let (report, hash) = open(&self.report)?;
        let mut out = terminal::output();
        let objections = objections_to_report(&report, false);
        if !objections.is_empty() {
            return tell(&mut out, "NO CERTIFICATE", &objections);
        }
        let key = self.key()?;
        let certificate = Signed::sign(Statement::of(&report, &hash), &key).map_err(Failure::Input)?;
        let text = serde_json::to_string_pretty(&certificate).map_err(|error| Failure::Input(error.to_string()))?;
        write(&self.output, &(text + "\n"))?;
        if let Some(file) = &self.html {
            write(file, &page(&certificate).map_err(Failure::Input)?)?;
        }
        writeln!(out, "{}", certificate.statement.theorem)?;
        writeln!(out, "signed by {}", certificate.public_key)?;
        out.flush()?;
        Ok(Verdict::Green)
    }

    fn key(&self) -> Result<Key, Failure> {
        let wrong =
            |file: &Path, reason: &dyn ToString| Failure::Input(format!("{}: {}", file.display(), reason.to_string()));
        if let Some(file) = &self.key {
            let text = fs::read_to_string(file).map_err(|reason| wrong(file, &reason))?;
            return Key::parse(&text).map_err(|error| wrong(file, &error));
        }
        let Some(file) = &self.make_key else { return Err(Failure::Input("there is no key".to_owned())) };
        let key = Key::generate().map_err(|error| wrong(file, &error))?;
        let pem = key.pem().map_err(|error| wrong(file, &error))?;
        let mut options = fs::OpenOptions::new();
        options.write(true).create_new(true);
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        options
            .open(file)
            .and_then(|mut file| file.write_all(pem.as_bytes()))
            .map_err(|reason| wrong(file, &reason))?;
        Ok(key)
    }
}

impl VerifyCertificate {
    /// Checks the certificate.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let file = self.certificate.display();
        let text = fs::read_to_string(&self.certificate).map_err(|error| Failure::Input(format!("{file}: {error}")))?;
        let certificate: Signed = serde_json::from_str(&text)
            .map_err(|error| Failure::Input(format!("{file}: not a certificate: {error}")))?;
        let (report, hash) = open(&self.report)?;
        let mut found = objections(&certificate, &report, &hash, !self.quick);
        if self.public_key.as_ref().is_some_and(|key| !key.eq_ignore_ascii_case(&certificate.public_key)) {
            found.push("it is signed with another key".to_owned());
        }
        let mut out = terminal::output();
        if !found.is_empty() {
            return tell(&mut out, "NOT VERIFIED", &found);
        }
        writeln!(out, "{}", certificate.statement.theorem)?;
        if self.public_key.is_none() {
            writeln!(out, "signed by {}: whose key that is was not asked (--public-key)", certificate.public_key)?;
        }
        if self.quick {
            writeln!(out, "the level's programs were not run again (--quick)")?;
        }
        writeln!(out, "{}", bold("VERIFIED"))?;
        out.flush()?;
        Ok(Verdict::Green)
    }
}

fn tell(out: &mut dyn Write, verdict: &str, objections: &[String]) -> Result<Verdict, Failure> {
    for objection in objections {
        writeln!(out, "{objection}")?;
    }
    writeln!(out, "{}", bold(verdict))?;
    out.flush()?;
    Ok(Verdict::Red)
}

fn open(file: &Path) -> Result<(Report, String), Failure> {
    let wrong = |reason: String| Failure::Input(format!("{}: {reason}", file.display()));
    let report = Report::open(file).map_err(|error| wrong(error.to_string()))?;
    let hash = sha256_of_file(file).map_err(|error| wrong(error.to_string()))?;
    Ok((report, hash))
}

fn write(file: &Path, text: &str) -> Result<(), Failure> {
    fs::write(file, text).map_err(|reason| Failure::Input(format!("{} cannot be written: {reason}", file.display())))
}
