//! The options that say which program runs on which control.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use clap::Args;
use radcomp::gcode::{MOST_DIGITS, Tool, Tools};
use radcomp_model::number::parse_decimal;
use radcomp_spec::profile::{BUILTIN, Profile};
use rug::Rational;

use super::failure::Failure;
use super::nearest::suggestion;
use super::program::Control;

/// A program and the control that runs it.
#[derive(Debug, Args)]
pub struct Options {
    /// The program, G-code; - reads the standard input
    #[arg(value_name = "FILE")]
    file: String,

    /// The control: a built-in profile (see `radcomp profiles`) or a profile file
    #[arg(long, short, value_name = "NAME|FILE.toml")]
    profile: String,

    /// The tool table: radius, wear and tip orientation of each offset number
    #[arg(long, short, value_name = "FILE.toml")]
    tools: Option<PathBuf>,

    /// The radius of offset 1 in millimetres, wear included, whatever the tool table says
    #[arg(long, short, value_name = "R", value_parser = radius, allow_hyphen_values = true)]
    radius: Option<Rational>,

    /// Skip the blocks that start with /
    #[arg(long)]
    block_delete: bool,
}

impl Options {
    /// The control and the program's text.
    pub fn open(&self) -> Result<(Control, Box<dyn BufRead>), Failure> {
        let profile = profile(&self.profile)?;
        let mut tools = match &self.tools {
            Some(path) => Tools::parse(&text_of(path)?, &path.display().to_string())?,
            None => Tools::empty(),
        };
        if let Some(radius) = &self.radius {
            let orientation = tools.tool(1).and_then(|tool| tool.orientation);
            tools = tools.with_tool(1, Tool { orientation, ..Tool::of_radius(radius.clone()) });
        }
        let name = if self.file == "-" { "standard input".to_owned() } else { self.file.clone() };
        let source = open(&self.file)?;
        Ok((Control { name, profile, tools, skip_deleted: self.block_delete }, source))
    }
}

/// A radius in millimetres, exactly.
fn radius(text: &str) -> Result<Rational, String> {
    let (digits, decimals) = text.split_once('.').unwrap_or((text, ""));
    let short = digits.trim_start_matches('-').len() <= MOST_DIGITS && decimals.len() <= MOST_DIGITS;
    let radius = parse_decimal(text).filter(|_| short);
    radius.ok_or_else(|| format!("a radius is a decimal of at most {MOST_DIGITS} digits and decimals"))
}

fn open(file: &str) -> Result<Box<dyn BufRead>, Failure> {
    if file == "-" {
        return Ok(Box::new(BufReader::with_capacity(1 << 16, io::stdin())));
    }
    let path = Path::new(file);
    check_is_file(path)?;
    let file = File::open(path).map_err(|reason| unreadable(path, &reason))?;
    Ok(Box::new(BufReader::with_capacity(1 << 16, file)))
}

/// The built-in profile of that name, or the profile file.
pub fn profile(name: &str) -> Result<Profile, Failure> {
    if let Some(profile) = Profile::builtin(name) {
        return Ok(profile);
    }
    let path = Path::new(name);
    if path.exists() || name.ends_with(".toml") || name.contains('/') {
        check_is_file(path)?;
        return Profile::load(path).map_err(|error| Failure::from(radcomp::gcode::Diagnostic::from(error)));
    }
    let names = BUILTIN.iter().map(|(builtin, _)| *builtin);
    let suggestion = suggestion(name, names.clone());
    let names = names.collect::<Vec<_>>().join(", ");
    Err(Failure::Input(format!("there is no profile {name}{suggestion}\nbuilt in are {names}; a file ends in .toml")))
}

fn text_of(path: &Path) -> Result<String, Failure> {
    check_is_file(path)?;
    fs::read_to_string(path).map_err(|reason| unreadable(path, &reason))
}

fn check_is_file(path: &Path) -> Result<(), Failure> {
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => {
            Err(Failure::Input(format!("{} is a directory, not a file", path.display())))
        }
        Ok(_) => Ok(()),
        Err(reason) => Err(unreadable(path, &reason)),
    }
}

fn unreadable(path: &Path, reason: &io::Error) -> Failure {
    let path = path.display();
    match reason.kind() {
        io::ErrorKind::NotFound => Failure::Input(format!("there is no file {path}")),
        io::ErrorKind::InvalidData => Failure::Input(format!("{path} is not text")),
        _ => Failure::Input(format!("{path} cannot be read: {reason}")),
    }
}
