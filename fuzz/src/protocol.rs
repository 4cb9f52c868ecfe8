//! Targets over the pipe protocol: lines of a hostile device, lines of a hostile caller, and a real device.

use std::cell::RefCell;
use std::collections::HashMap;

use radcomp::device::pipe::Limits;
use radcomp::device::wire::{Reply, serve};
use radcomp::device::{Answer, Builtin, Device, DeviceFault, DeviceName};
use radcomp::generate::{Reach, program};
use radcomp::judge::{Verdict, judge};
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters, Segment};
use rug::Rational;

use crate::programs::{self, BUDGET};

/// Bytes before the line: the number of the program that it answers.
const HEAD: usize = 2;

/// What a hostile device writes is read or refused with a message, and judged like any answer: a number that is not
/// finite is no answer, and an answer to a block that the program does not have is none.
pub fn hostile_device(bytes: &[u8]) {
    let Some((head, line)) = bytes.split_at_checked(HEAD) else { return };
    let profile = Profile::builtin("seed-mill").expect("built in");
    let blocks = program(1, u64::from(u16::from_le_bytes([head[0], head[1]])), Reach::of(&profile));
    let reply = match Reply::read(line) {
        Err(error) => return assert!(!error.0.is_empty()),
        Ok(reply) => reply.within(blocks.len()),
    };
    let finite = reply.answer.as_ref().is_ok_and(|answer| answer.steps.iter().all(|step| is_finite(&step.segment)));
    let verdict = judge(&mut Said(reply.answer), &profile.parameters, &blocks, &BUDGET).verdict;
    assert!(finite || !matches!(verdict, Verdict::Exact | Verdict::Admissible(_)), "{verdict:?}");
}

/// A device that has said this.
struct Said(Result<Answer, DeviceFault>);

impl Device for Said {
    fn name(&self) -> &str {
        "said"
    }

    fn answer(&mut self, _: &Parameters, _: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        self.0.clone()
    }
}

fn is_finite(segment: &Segment<f64>) -> bool {
    let finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
    match segment {
        Segment::Line { end } => finite(end),
        Segment::Arc { end, centre, .. } => finite(end) && finite(centre),
        Segment::Hold => true,
    }
}

/// Requests of any bytes: the device's side answers each line that is a request, and ends at one that is none.
pub fn hostile_caller(bytes: &[u8]) {
    let mut written = Vec::new();
    let lines = bytes.split(|byte| *byte == b'\n').filter(|line| !line.iter().all(u8::is_ascii_whitespace)).count();
    let _ = serve(&mut Builtin, bytes, &mut written);
    assert!(written.iter().filter(|byte| **byte == b'\n').count() <= lines, "one answer a request");
}

/// The device of the environment variable `RADCOMP_DEVICE`, such as `pipe:COMMAND`: no answer of it is red.
///
/// # Panics
/// When the variable names no device; and when a verdict is red.
pub fn external(bytes: &[u8]) {
    thread_local! {
        /// The device for each profile: a process is started once, not for each program.
        static OPEN: RefCell<HashMap<String, Box<dyn Device>>> = RefCell::default();
    }
    let Some(radcomp::edited::Edited { profile, .. }) = radcomp::edited::Edited::from_bytes(bytes) else { return };
    OPEN.with_borrow_mut(|open| {
        let key = format!("{:?}", profile.parameters);
        let device = open.entry(key).or_insert_with(|| {
            let name = std::env::var("RADCOMP_DEVICE").unwrap_or_default();
            let name = DeviceName::parse(&name).unwrap_or_else(|error| panic!("RADCOMP_DEVICE: {error}"));
            name.open(&profile, Limits::default())
        });
        programs::judged(device.as_mut(), bytes);
    });
}
