//! The device `linuxcnc`: the stock `rs274` interpreter of LinuxCNC, started once and fed programs over its standard
//! input, as if they were typed at its keyboard.
//!
//! One error does not stop it. The interpreter is the one on PATH or in `$RS274`, and stays as it is installed: a small
//! library of our own, built with `cc` and preloaded, makes it print 17 digits instead of four decimals. Each process has
//! a home of its own. What a program cannot say to it (dummy blocks, the choice of an outer corner, another radius in
//! mode) is [`DeviceFault::Unsupported`].
//!
//! The interpreter compensates as its own control does, whatever the parameters of a profile: it ignores them.

mod canon;
mod program;

use std::collections::HashMap;
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;
use std::{env, fs, io};

use radcomp_spec::parameters::Plane;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;
use tempfile::TempDir;

use super::pipe::{Dialect, Limits, Pipe};
use super::wire::{Reply, ReplyError};
use super::{Answer, Device, DeviceFault};
use canon::Transcript;
use program::{BEGIN, END, Place};

/// LinuxCNC's interpreter.
pub struct LinuxCnc {
    pipe: Pipe,
    /// The process's home, and the library that widens its numbers; gone with the device.
    _folder: TempDir,
}

impl LinuxCnc {
    /// The interpreter in `$RS274`, or the one on PATH.
    ///
    /// # Errors
    ///
    /// When the library that widens its numbers cannot be built, or there is no folder for it.
    pub fn open(control: &Profile, limits: Limits) -> io::Result<LinuxCnc> {
        LinuxCnc::run(env::var_os("RS274").unwrap_or_else(|| "rs274".into()), control, limits)
    }

    /// The interpreter that this command runs.
    ///
    /// # Errors
    ///
    /// As [`LinuxCnc::open`].
    pub fn run(rs274: OsString, control: &Profile, limits: Limits) -> io::Result<LinuxCnc> {
        let folder = tempfile::Builder::new().prefix("radcomp-rs274-").tempdir()?;
        let library = folder.path().join("widen.so");
        fs::write(&library, widener()?)?;
        // Errors go where the calls go, so that their order is kept; the library is for the interpreter alone.
        let script = "LD_PRELOAD=$RADCOMP_WIDEN exec \"$0\" -t /dev/null -g 2>&1";
        let words = [OsString::from("sh"), "-c".into(), script.into(), rs274].to_vec();
        let environment = [
            ("RADCOMP_WIDEN", library.into_os_string()),
            ("HOME", folder.path().as_os_str().to_owned()),
            ("RS274_HISTORY", "/dev/null".into()),
        ];
        let environment = environment.map(|(name, value)| (OsString::from(name), value)).to_vec();
        let dialect = Canonical { plane: control.machine.plane, asked: HashMap::new(), open: None };
        let pipe = Pipe::speaking(Box::new(dialect), "linuxcnc".to_owned(), words, environment, limits);
        Ok(LinuxCnc { pipe, _folder: folder })
    }
}

impl Device for LinuxCnc {
    fn name(&self) -> &str {
        self.pipe.name()
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        self.pipe.answer(parameters, blocks)
    }

    fn answer_all(
        &mut self,
        parameters: &Parameters,
        programs: &[Vec<Block<Rational>>],
    ) -> Vec<Result<Answer, DeviceFault>> {
        self.pipe.answer_all(parameters, programs)
    }
}

/// Programs typed at a keyboard, answered in canonical calls.
struct Canonical {
    plane: Plane,
    /// The programs that are not answered yet, by id.
    asked: HashMap<String, Vec<Place>>,
    /// The answer that is being read.
    open: Option<(String, Transcript)>,
}

impl Dialect for Canonical {
    fn begin(&mut self, _: &Parameters) {
        self.asked.clear();
    }

    fn question(&mut self, id: &str, blocks: &[Block<Rational>]) -> Result<String, DeviceFault> {
        let (text, places) = program::program(id, self.plane, blocks)?;
        self.asked.insert(id.to_owned(), places);
        Ok(text)
    }

    fn read(&mut self, line: &[u8]) -> Result<Option<Reply>, ReplyError> {
        let line = String::from_utf8_lossy(line);
        if let Some(id) = line.strip_prefix(BEGIN) {
            let Some(places) = self.asked.get(id) else {
                return Err(ReplyError(format!("rs274 begins a program that nothing waits for: {id:?}")));
            };
            self.open = Some((id.to_owned(), Transcript::new(self.plane, places.clone())));
        } else if let Some(ended) = line.strip_prefix(END) {
            let Some((id, transcript)) = self.open.take().filter(|(id, _)| id == ended) else {
                return Err(ReplyError(format!("rs274 ends a program that it has not begun: {ended:?}")));
            };
            return Ok(Some(Reply { id, answer: transcript.finish() }));
        } else if let Some((_, transcript)) = &mut self.open {
            transcript.line(&line);
        }
        Ok(None)
    }

    fn restart(&mut self) {
        self.open = None;
    }
}

/// The library that widens numbers, built once by this process.
fn widener() -> io::Result<&'static [u8]> {
    static LIBRARY: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();
    let built = LIBRARY.get_or_init(|| {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        build(folder.path()).map_err(|error| format!("a C compiler, cc, is needed to read rs274's numbers: {error}"))
    });
    built.as_deref().map_err(|text| io::Error::other(text.clone()))
}

fn build(folder: &Path) -> io::Result<Vec<u8>> {
    let (source, library) = (folder.join("widen.c"), folder.join("widen.so"));
    fs::write(&source, include_str!("widen.c"))?;
    let output = Command::new("cc")
        .args(["-O1", "-shared", "-fPIC", "-U_FORTIFY_SOURCE", "-o"])
        .args([&library, &source])
        .output()?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned()));
    }
    fs::read(library)
}
