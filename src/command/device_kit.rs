//! `radcomp device-kit`.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

use clap::Args;
use clap::builder::PossibleValuesParser;
use radcomp::device::kit::{self, KitFile};

use super::failure::{Failure, Verdict};
use super::terminal;

/// Write a small working adapter to start from, with the schema or the header it speaks
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  radcomp device-kit python --output my-adapter
  radcomp ping \"pipe:python3 my-adapter/adapter.py\"")]
pub struct DeviceKit {
    /// The language of the adapter
    #[arg(value_name = "LANGUAGE", value_parser = PossibleValuesParser::new(["python", "c", "rust"]))]
    language: String,

    /// The folder to write it into; made if it is not there
    #[arg(long, short, value_name = "FOLDER", default_value = ".")]
    output: PathBuf,
}

impl DeviceKit {
    /// Writes the files; none that is there already.
    pub fn execute(&self) -> Result<Verdict, Failure> {
        let mut out = terminal::output();
        for KitFile { path, text } in kit::files(&self.language).unwrap_or_default() {
            let path = self.output.join(path);
            let failed = |reason: std::io::Error| match reason.kind() {
                ErrorKind::AlreadyExists => {
                    Failure::Input(format!("{} is there already; nothing is overwritten", path.display()))
                }
                _ => Failure::Input(format!("{} cannot be written: {reason}", path.display())),
            };
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder).map_err(failed)?;
            }
            fs::File::create_new(&path).and_then(|mut file| file.write_all(text.as_bytes())).map_err(failed)?;
            writeln!(out, "{}", path.display())?;
        }
        out.flush()?;
        Ok(Verdict::Green)
    }
}
