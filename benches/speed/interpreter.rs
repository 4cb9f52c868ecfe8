//! A control beside the implementation: LinuxCNC's `rs274` interpreter, which reads G-code and prints canonical moves.

use std::ffi::OsString;
use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use crate::contour::Contour;
use crate::measure::median;

/// Blocks of the program that is timed.
const BLOCKS: usize = 10_000;

/// Nanoseconds per block with compensation on, reading and printing included, starting up not; `None` where there is no
/// `rs274` on PATH or in `$RS274`.
pub fn nanoseconds_per_block(contour: &Contour, rounds: usize) -> Option<f64> {
    let command = std::env::var_os("RS274").unwrap_or_else(|| "rs274".into());
    // It keeps a tool file in its home.
    let home = std::env::temp_dir().join(format!("radcomp-speed-{}", std::process::id()));
    std::fs::create_dir_all(&home).ok()?;
    let (empty, full) = (program(contour, 0), program(contour, BLOCKS));
    let turns = (0..rounds)
        .map(|_| Some((seconds(&command, &home, &full)? - seconds(&command, &home, &empty)?) * 1e9 / BLOCKS as f64))
        .collect::<Option<Vec<f64>>>();
    // Nothing depends on whether the folder is gone.
    let _ = std::fs::remove_dir_all(&home);
    turns.map(median)
}

/// Without a percent sign on the first line the interpreter reads that line twice, which standard input does not allow.
fn program(contour: &Contour, blocks: usize) -> String {
    format!("%\n{}%\n", contour.g_code(blocks))
}

fn seconds(command: &OsString, home: &Path, program: &str) -> Option<f64> {
    let start = Instant::now();
    let child = Command::new(command)
        .args(["-t", "/dev/null", "-g", "/dev/stdin"])
        .env("HOME", home)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let mut child = match child {
        Ok(child) => child,
        Err(error) if error.kind() == ErrorKind::NotFound => return None,
        Err(error) => {
            eprintln!("rs274 does not start: {error}");
            return None;
        }
    };
    let written = child.stdin.take()?.write_all(program.as_bytes());
    let status = child.wait().ok()?;
    if written.is_err() || !status.success() {
        eprintln!("rs274 does not run the program: {status}");
        return None;
    }
    Some(start.elapsed().as_secs_f64())
}
