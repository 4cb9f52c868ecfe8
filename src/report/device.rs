//! Which device was certified.

use std::path::{Path, PathBuf};
use std::{env, io};

use serde::{Deserialize, Serialize};

use super::hash::sha256_of_file;
use crate::device::DeviceName;

/// A device by its name, its version and its files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceRecord {
    /// The name, as the command line gives it.
    pub name: String,
    /// The version, if it is known.
    pub version: Option<String>,
    /// The files that it consists of, as far as its name tells them.
    pub files: Vec<FileRecord>,
}

/// A file and its hash.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileRecord {
    /// The file, as the device's name gives it.
    pub file: String,
    /// SHA-256.
    pub sha256: String,
}

impl DeviceRecord {
    /// A device without files.
    pub fn named(name: &str) -> DeviceRecord {
        DeviceRecord { name: name.to_owned(), ..DeviceRecord::default() }
    }

    /// A device of the command line. The version of `builtin` is the toolkit's; `version` tells that of another one.
    ///
    /// The files are, of `builtin`, this program; of `lib:`, the library; of `linuxcnc`, the interpreter; of `pipe:`, the
    /// program that the command starts with and every other word of it that is a file. What these load is not told.
    ///
    /// # Errors
    ///
    /// When one of the files cannot be read.
    pub fn of(text: &str, device: &DeviceName, version: Option<String>) -> io::Result<DeviceRecord> {
        let own = (*device == DeviceName::Builtin).then(|| env!("CARGO_PKG_VERSION").to_owned());
        let files = match device {
            DeviceName::Builtin => vec![("radcomp".to_owned(), env::current_exe()?)],
            DeviceName::Library(file) => vec![(file.display().to_string(), file.clone())],
            DeviceName::LinuxCnc => {
                let rs274 = env::var("RS274").unwrap_or_else(|_| "rs274".to_owned());
                program(&rs274).map(|file| (rs274, file)).into_iter().collect()
            }
            DeviceName::Pipe(command) => words(command),
        };
        let hashed = |(file, path): (String, PathBuf)| Ok(FileRecord { file, sha256: sha256_of_file(&path)? });
        let files = files.into_iter().map(hashed).collect::<io::Result<Vec<_>>>()?;
        Ok(DeviceRecord { name: text.to_owned(), version: version.or(own), files })
    }
}

/// The words of a shell command that are files; the first one also if it is found on PATH.
fn words(command: &str) -> Vec<(String, PathBuf)> {
    let plain = |word: &str| word.trim_matches(['"', '\'']).to_owned();
    let mut found = Vec::new();
    for (index, word) in command.split_whitespace().map(plain).enumerate() {
        let file = if index == 0 { program(&word) } else { Some(PathBuf::from(&word)).filter(|file| file.is_file()) };
        found.extend(file.map(|file| (word, file)));
    }
    found
}

/// The file of a program, as the shell finds it.
fn program(name: &str) -> Option<PathBuf> {
    if name.contains('/') {
        return Some(PathBuf::from(name)).filter(|file| file.is_file());
    }
    let path = env::var_os("PATH")?;
    env::split_paths(&path).map(|folder| folder.join(Path::new(name))).find(|file| file.is_file())
}
