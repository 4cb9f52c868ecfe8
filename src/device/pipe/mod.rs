//! The device `pipe:COMMAND`: a process that speaks the pipe protocol ([`super::wire`]).
//!
//! Several requests are in flight at a time. When the process dies, hangs, or says what is no answer, it is killed and
//! started again, and the requests that were in flight are asked again one at a time: the guilty one alone is charged.
//! Ids are not consecutive, so that an answer for a neighbour is seen for what it is.

mod dialect;
mod ending;
pub(crate) mod process;

use std::collections::VecDeque;
use std::ffi::OsString;
use std::time::{Duration, Instant};

use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Parameters};
use rug::Rational;

use super::wire::Reply;
use super::{Answer, Device, DeviceFault};
pub(crate) use dialect::Dialect;
use dialect::JsonLines;
use process::{Event, Process};

/// What a device process may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The time from a request, or from the answer before, to the next answer.
    pub timeout: Duration,
    /// The bytes of one answer.
    pub most_bytes: usize,
    /// Requests that may wait for their answers at a time; at least 1.
    pub in_flight: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { timeout: Duration::from_secs(10), most_bytes: 16 << 20, in_flight: 16 }
    }
}

/// A device behind a pipe.
pub struct Pipe {
    name: String,
    words: Vec<OsString>,
    environment: Vec<(OsString, OsString)>,
    dialect: Box<dyn Dialect>,
    limits: Limits,
    process: Option<Process>,
    /// How many requests have been made.
    asked: u64,
}

/// A request on its way.
struct Question {
    id: String,
    line: String,
    /// How many blocks its program has.
    blocks: usize,
}

/// The process can no longer be trusted: requests that it has not answered, and why.
struct Trouble {
    unanswered: VecDeque<usize>,
    fault: DeviceFault,
}

/// The distance of two ids that follow each other.
const ID_STEP: u64 = 10;

impl Pipe {
    /// A device that is a shell command.
    pub fn shell(command: &str, control: &Profile, limits: Limits) -> Pipe {
        Pipe::new(format!("pipe:{command}"), ["sh", "-c", command].map(OsString::from).to_vec(), control, limits)
    }

    /// A device that is a program with its arguments and speaks the pipe protocol.
    pub fn new(name: String, words: Vec<OsString>, control: &Profile, limits: Limits) -> Pipe {
        Pipe::speaking(Box::new(JsonLines::new(control)), name, words, Vec::new(), limits)
    }

    /// A device that speaks otherwise, with what its environment has beside this process's.
    pub(crate) fn speaking(
        dialect: Box<dyn Dialect>,
        name: String,
        words: Vec<OsString>,
        environment: Vec<(OsString, OsString)>,
        limits: Limits,
    ) -> Pipe {
        Pipe { name, words, environment, dialect, limits, process: None, asked: 0 }
    }

    /// Asks the questions with these indices, so many at a time, and notes each result.
    fn exchange(
        &mut self,
        questions: &[Question],
        indices: &mut VecDeque<usize>,
        in_flight: usize,
        results: &mut [Option<Result<Answer, DeviceFault>>],
    ) -> Result<(), Trouble> {
        let mut waiting = VecDeque::new();
        let mut deadline = Instant::now() + self.limits.timeout;
        while !indices.is_empty() || !waiting.is_empty() {
            let process = match &self.process {
                Some(process) => process,
                None => match Process::start(&self.words, &self.environment, self.limits.most_bytes) {
                    Ok(process) => {
                        self.dialect.restart();
                        self.process.insert(process)
                    }
                    Err(error) => {
                        let fault = DeviceFault::NoAnswer(format!("the device does not start: {error}"));
                        return Err(Trouble { unanswered: indices.pop_front().into_iter().collect(), fault });
                    }
                },
            };
            while waiting.len() < in_flight
                && let Some(index) = indices.pop_front()
            {
                process.write(questions[index].line.clone());
                waiting.push_back(index);
            }
            let fault = match process.listen(deadline.saturating_duration_since(Instant::now())) {
                Event::Line(line) => match self.dialect.read(&line) {
                    Ok(None) => continue,
                    Ok(Some(reply)) => match note(reply, questions, &mut waiting, results) {
                        Ok(()) => {
                            deadline = Instant::now() + self.limits.timeout;
                            continue;
                        }
                        Err(fault) => fault,
                    },
                    Err(error) => DeviceFault::Garbled(error.0),
                },
                Event::TooLong => DeviceFault::Garbled(format!("a line of more than {} bytes", self.limits.most_bytes)),
                Event::Silence => {
                    let seconds = self.limits.timeout.as_secs_f64();
                    DeviceFault::Timeout(format!("no answer within {seconds} s"))
                }
                Event::End(bytes) => self.ending(bytes),
            };
            return Err(Trouble { unanswered: waiting, fault: self.stop(fault) });
        }
        Ok(())
    }

    /// Why the device's output has ended.
    fn ending(&mut self, bytes: usize) -> DeviceFault {
        let ended = || DeviceFault::NoAnswer("the device has ended".to_owned());
        self.process.as_mut().map_or_else(ended, |process| ending::ending(process, bytes))
    }

    /// Ends the process, and adds what it left unfinished to the fault.
    fn stop(&mut self, fault: DeviceFault) -> DeviceFault {
        let Some(mut process) = self.process.take() else { return fault };
        match (process.stop(), fault) {
            (1.., DeviceFault::Timeout(text)) => {
                DeviceFault::Timeout(format!("{text}; a line that is not complete was there"))
            }
            (_, fault) => fault,
        }
    }
}

impl Device for Pipe {
    fn name(&self) -> &str {
        &self.name
    }

    fn answer(&mut self, parameters: &Parameters, blocks: &[Block<Rational>]) -> Result<Answer, DeviceFault> {
        let mut answers = self.answer_all(parameters, &[blocks.to_vec()]);
        answers.pop().unwrap_or_else(|| Err(DeviceFault::NoAnswer("not asked".to_owned())))
    }

    fn answer_all(
        &mut self,
        parameters: &Parameters,
        programs: &[Vec<Block<Rational>>],
    ) -> Vec<Result<Answer, DeviceFault>> {
        self.dialect.begin(parameters);
        let mut results: Vec<Option<Result<Answer, DeviceFault>>> = Vec::with_capacity(programs.len());
        let mut questions = Vec::with_capacity(programs.len());
        for blocks in programs {
            self.asked += ID_STEP;
            let id = self.asked.to_string();
            let (line, refused) = match self.dialect.question(&id, blocks) {
                Ok(line) => (line, None),
                Err(fault) => (String::new(), Some(Err(fault))),
            };
            questions.push(Question { id, line, blocks: blocks.len() });
            results.push(refused);
        }
        let mut left: VecDeque<usize> = (0..programs.len()).filter(|index| results[*index].is_none()).collect();
        while !left.is_empty() {
            let Err(trouble) = self.exchange(&questions, &mut left, self.limits.in_flight.max(1), &mut results) else {
                break;
            };
            let suspects = trouble.unanswered;
            // One suspect needs no second hearing.
            if suspects.len() == 1 {
                results[suspects[0]] = Some(Err(trouble.fault));
                continue;
            }
            for index in suspects {
                if let Err(trouble) = self.exchange(&questions, &mut VecDeque::from([index]), 1, &mut results) {
                    results[index] = Some(Err(trouble.fault));
                }
            }
        }
        let missing = || Err(DeviceFault::NoAnswer("no answer".to_owned()));
        results.into_iter().map(|result| result.unwrap_or_else(missing)).collect()
    }
}

/// Notes an answer for the question that it names.
fn note(
    reply: Reply,
    questions: &[Question],
    waiting: &mut VecDeque<usize>,
    results: &mut [Option<Result<Answer, DeviceFault>>],
) -> Result<(), DeviceFault> {
    if let Some(place) = waiting.iter().position(|index| questions[*index].id == reply.id)
        && let Some(index) = waiting.remove(place)
    {
        results[index] = Some(reply.within(questions[index].blocks).answer);
        return Ok(());
    }
    let shown = super::wire::shown(reply.id.as_bytes());
    match questions.iter().position(|question| question.id == reply.id) {
        Some(index) => {
            results[index] =
                Some(Err(DeviceFault::Garbled(format!("the request with the id {shown} was answered twice"))));
            Ok(())
        }
        None => Err(DeviceFault::Garbled(format!("an answer for the id {shown}, which nothing waits for"))),
    }
}
