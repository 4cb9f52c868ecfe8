//! How a device's output ended.

use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;
use std::time::Duration;

use super::process::Process;
use crate::device::DeviceFault;

/// How long a process whose output has ended may take to end itself.
const GRACE: Duration = Duration::from_millis(500);

/// Why the output of a device has ended, with so many bytes of a line that is not complete.
pub(super) fn ending(process: &mut Process, bytes: usize) -> DeviceFault {
    let half = if bytes == 0 { "" } else { "; its last line is not complete" };
    match process.wait(GRACE) {
        None => DeviceFault::NoAnswer(format!("the device closed its standard output{half}")),
        Some(status) if status.success() => {
            DeviceFault::NoAnswer(format!("the device ended, exit status 0, without answering{half}"))
        }
        Some(status) => {
            let words = match &*process.last_words() {
                "" => String::new(),
                words => format!("; it said: {words}"),
            };
            DeviceFault::Crash(format!("the device ended with {}{half}{words}", told(status)))
        }
    }
}

/// How a process ended, in words.
fn told(status: ExitStatus) -> String {
    const NAMES: [(i32, &str); 6] = [
        (4, "SIGILL, an illegal instruction"),
        (6, "SIGABRT, an abort"),
        (8, "SIGFPE, an arithmetic fault"),
        (9, "SIGKILL"),
        (11, "SIGSEGV, a wrong memory access"),
        (15, "SIGTERM"),
    ];
    let name = |signal: i32| {
        let known = NAMES.iter().find(|(number, _)| *number == signal);
        known.map_or_else(|| format!("signal {signal}"), |(_, name)| (*name).to_owned())
    };
    match (status.signal(), status.code()) {
        (Some(signal), _) => name(signal),
        // A shell reports a child's signal so.
        (None, Some(code @ 129..=159)) => format!("exit status {code}: {}", name(code - 128)),
        (None, Some(126 | 127)) => "the shell's complaint that there is no such command".to_owned(),
        (None, code) => format!("exit status {}", code.unwrap_or_default()),
    }
}
