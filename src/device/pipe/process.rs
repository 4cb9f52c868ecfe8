//! One running process of a device: lines in, lines out, bounded in time and memory.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::os::unix::process::CommandExt;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender, SyncSender};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, WaitId, WaitIdOptions, kill_process_group, waitid};

/// What a process has to say.
#[derive(Debug)]
pub(crate) enum Event {
    /// A line of its standard output, without its end.
    Line(Vec<u8>),
    /// A line longer than the limit; nothing more is read.
    TooLong,
    /// The end of its standard output, and how many bytes of an incomplete line were there.
    End(usize),
    /// Nothing in the time given.
    Silence,
}

/// A process in a group of its own, killed with all that it started when this is dropped.
pub(crate) struct Process {
    child: Child,
    group: Option<Pid>,
    /// Lines to write; gone once the input is closed.
    input: Option<Sender<String>>,
    output: Receiver<Event>,
    /// The end of its standard error output.
    complaints: Arc<Mutex<Vec<u8>>>,
    /// Closed when the standard error output is.
    complained: Receiver<()>,
}

/// Lines that wait to be looked at: a process that prints more has to wait.
const MOST_WAITING: usize = 16;
/// Bytes that are kept of the standard error output.
const MOST_COMPLAINTS: usize = 1024;
/// How long a process may take to end once its input is closed.
const GRACE: Duration = Duration::from_millis(500);

impl Process {
    /// Starts a command, given as its words.
    ///
    /// # Errors
    ///
    /// When there is no such program.
    pub(crate) fn start(
        words: &[OsString],
        environment: &[(OsString, OsString)],
        most_bytes: usize,
    ) -> io::Result<Process> {
        let (program, arguments) = words.split_first().ok_or(io::ErrorKind::InvalidInput)?;
        let mut child = Command::new(program)
            .args(arguments)
            .envs(environment.iter().map(|(name, value)| (name, value)))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .process_group(0)
            .spawn()?;
        let group = i32::try_from(child.id()).ok().and_then(Pid::from_raw);
        let (input, lines) = mpsc::channel::<String>();
        let (events, output) = mpsc::sync_channel(MOST_WAITING);
        let (ended, complained) = mpsc::sync_channel(0);
        let complaints = Arc::new(Mutex::new(Vec::new()));
        if let Some(mut stdin) = child.stdin.take() {
            // A process that has closed its input is heard of through its output.
            thread::spawn(move || lines.iter().try_for_each(|line| stdin.write_all(line.as_bytes())));
        }
        if let Some(stdout) = child.stdout.take() {
            thread::spawn(move || read_lines(stdout, most_bytes, &events));
        }
        if let Some(stderr) = child.stderr.take() {
            let kept = complaints.clone();
            thread::spawn(move || keep_end(stderr, &kept, ended));
        }
        Ok(Process { child, group, input: Some(input), output, complaints, complained })
    }

    /// Writes a line, with its end, as soon as the process takes it.
    pub(crate) fn write(&self, line: String) {
        if let Some(input) = &self.input {
            // A process that takes no more input is heard of through its output.
            let _ = input.send(line);
        }
    }

    /// Closes the process's input.
    pub(crate) fn close_input(&mut self) {
        self.input = None;
    }

    /// The next thing that it says within a time.
    pub(crate) fn listen(&self, timeout: Duration) -> Event {
        match self.output.recv_timeout(timeout) {
            Ok(event) => event,
            Err(RecvTimeoutError::Timeout) => Event::Silence,
            Err(RecvTimeoutError::Disconnected) => Event::End(0),
        }
    }

    /// How it ended, if it does within a time.
    pub(crate) fn wait(&mut self, timeout: Duration) -> Option<ExitStatus> {
        if !self.has_exited(timeout) {
            return None;
        }
        self.kill();
        self.child.wait().ok()
    }

    /// Kills it, with all that it started, and answers how many bytes of an incomplete line it had written.
    pub(crate) fn stop(&mut self) -> usize {
        self.kill();
        // Nothing depends on how a killed process ended.
        let _ = self.child.wait();
        let deadline = Instant::now() + GRACE;
        loop {
            match self.listen(deadline.saturating_duration_since(Instant::now())) {
                Event::Line(_) => {}
                Event::End(bytes) => return bytes,
                Event::TooLong | Event::Silence => return 0,
            }
        }
    }

    /// The end of what it wrote on its standard error output, in one line.
    pub(crate) fn last_words(&self) -> String {
        // Its end, if it comes soon; what is there, if not.
        let _ = self.complained.recv_timeout(GRACE);
        let kept = self.complaints.lock().map(|kept| kept.clone()).unwrap_or_default();
        let text = String::from_utf8_lossy(&kept);
        let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
        let text = lines[lines.len().saturating_sub(4)..].join(" / ");
        text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
    }

    /// Whether it ends within a time. It is not waited for, so that its number stays its own.
    fn has_exited(&self, timeout: Duration) -> bool {
        let Some(pid) = self.group else { return false };
        let deadline = Instant::now() + timeout;
        let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
        loop {
            if !matches!(waitid(WaitId::Pid(pid), options), Ok(None)) {
                return true;
            }
            if Instant::now() >= deadline {
                return false;
            }
            thread::sleep(Duration::from_millis(2));
        }
    }

    fn kill(&self) {
        if let Some(group) = self.group {
            // A group that is gone needs no killing.
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.close_input();
        self.has_exited(GRACE);
        self.kill();
        let _ = self.child.wait();
    }
}

fn read_lines(output: impl Read, most_bytes: usize, events: &SyncSender<Event>) {
    let mut output = BufReader::with_capacity(1 << 16, output);
    loop {
        let mut line = Vec::new();
        let limit = u64::try_from(most_bytes).unwrap_or(u64::MAX).saturating_add(1);
        let read = output.by_ref().take(limit).read_until(b'\n', &mut line);
        let event = match line.pop() {
            Some(b'\n') if read.is_ok() => Event::Line(line),
            Some(_) if line.len() >= most_bytes => Event::TooLong,
            Some(_) => Event::End(line.len() + 1),
            None => Event::End(0),
        };
        let ended = !matches!(event, Event::Line(_));
        // Nobody listens to a process that was stopped.
        if events.send(event).is_err() || ended {
            return;
        }
    }
}

fn keep_end(mut errors: impl Read, kept: &Mutex<Vec<u8>>, _ended: SyncSender<()>) {
    let mut buffer = [0; 4096];
    while let Ok(count @ 1..) = errors.read(&mut buffer) {
        let Ok(mut kept) = kept.lock() else { return };
        kept.extend_from_slice(&buffer[..count]);
        let surplus = kept.len().saturating_sub(MOST_COMPLAINTS);
        kept.drain(..surplus);
    }
}
