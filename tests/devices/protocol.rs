//! The pipe protocol: what passes over the pipe fits the published schema, and every wrong line is told in plain words.

use std::io::{BufRead, Cursor, Write};
use std::process::{Command, Stdio};

use radcomp::certify::programs;
use radcomp::device::pipe::{Limits, Pipe};
use radcomp::device::wire::{Asked, ProfileRecord, Reply, SCHEMA, request};
use radcomp::device::{Device, DeviceFault};
use radcomp::judge::Grade;
use radcomp_spec::profile::Profile;
use radcomp_spec::{Block, Movement, Segment};
use rug::Rational;
use serde_json::Value;

use super::schema::violation;
use super::{RADCOMP, limits, profile};

fn line() -> Vec<Block<Rational>> {
    vec![Block::moving(Movement::Line { end: [Rational::from(1), Rational::from(2)] })]
}

/// What a shell command is charged with for one program.
fn fault_of(command: &str) -> DeviceFault {
    let hangs = command.contains("sleep 60");
    let short = if hangs { Limits { timeout: std::time::Duration::from_millis(300), ..limits() } } else { limits() };
    let answer = Pipe::shell(command, &profile(), short).answer(&profile().parameters, &line());
    answer.expect_err("the device gives no answer")
}

/// What an answer of this text is charged with.
fn garbled(answer: &str) -> String {
    match Reply::read(answer.as_bytes()) {
        Err(error) => error.0,
        Ok(reply) => match reply.within(3).answer {
            Err(DeviceFault::Garbled(text)) => text,
            other => panic!("{answer} is read as {other:?}"),
        },
    }
}

#[test]
fn requests_and_answers_fit_the_schema() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    for (name, _) in radcomp_spec::profile::BUILTIN {
        let profile = Profile::builtin(name).unwrap();
        let record = ProfileRecord::new(&profile, &profile.parameters);
        let requests: String = programs(&profile, 1, 400, Grade::Binary64)
            .filter_map(|(id, blocks)| request(&id, &profile, &record, &blocks).ok())
            .collect();
        assert!(requests.lines().count() > 400);
        let mut device = Command::new(RADCOMP)
            .args(["answer", "--profile", name])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (mut input, told) = (device.stdin.take().unwrap(), requests.clone());
        let writer = std::thread::spawn(move || input.write_all(told.as_bytes()).unwrap());
        let output = device.wait_with_output().unwrap().stdout;
        writer.join().unwrap();
        assert_eq!(output.lines().count(), requests.lines().count());
        for line in Cursor::new(requests).lines().chain(output.lines()) {
            let value: Value = serde_json::from_str(&line.unwrap()).unwrap();
            assert_eq!(violation(&schema, &value), None);
        }
    }
}

#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    for text in [
        r#"{"id":"1","steps":[]}"#,
        r#"{"id":"1","alarm":null}"#,
        r#"{"id":"1","steps":[],"alarm":{"block":0}}"#,
        r#"{"id":"1","steps":[],"alarm":{"block":0,"alarm":"broken"}}"#,
        r#"{"id":"1","steps":[{"block":-1,"shape":"hold"}],"alarm":null}"#,
        r#"{"id":"1","steps":[{"block":0,"shape":"line","end":[1]}],"alarm":null}"#,
        r#"{"id":"1","steps":[{"block":0,"shape":"curve"}],"alarm":null}"#,
        r#"{"id":"1","steps":[],"alarm":null,"unsupported":"no"}"#,
        r#"{"id":1,"steps":[],"alarm":null}"#,
        r#"{"steps":[],"alarm":null}"#,
    ] {
        assert!(violation(&schema, &serde_json::from_str(text).unwrap()).is_some(), "{text}");
        assert!(!garbled(text).is_empty());
    }
}

#[test]
fn every_alarm_of_the_specification_is_in_the_schema() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let ids: Vec<Value> = radcomp_spec::AlarmKind::ALL.iter().map(|kind| Value::from(kind.id())).collect();
    assert_eq!(schema["$defs"]["alarm"]["enum"], Value::from(ids));
}

#[test]
fn a_wrong_answer_is_told_in_plain_words() {
    for (answer, words) in [
        ("", "the line is empty"),
        ("ready", "messages belong on the standard error output: `ready`"),
        (r#"{"id":"1","steps":[],"alarm":null} {}"#, "each line is one JSON object and nothing else"),
        (r#"{"id":"1","steps":[{"block":0,"shape":"line","end":[NaN,0]}],"alarm":null}"#, "JSON has no NaN"),
        (r#"{"id":"1","steps":[{"block":0,"shape":"line","end":["inf",0]}],"alarm":null}"#, "not a finite number"),
        (r#"{"id":"1","steps":[{"block":0,"shape":"line","end":[1e999,0]}],"alarm":null}"#, "number out of range"),
        (
            r#"{"id":"1","steps":[{"block":0,"shape":"line","end":["a",0]}],"alarm":null}"#,
            "expected a number in millimetres",
        ),
        (r#"{"id":"1","alarm":null}"#, "\"steps\" is missing; a path without elements is []"),
        (r#"{"id":"1","steps":[]}"#, "\"alarm\" is missing; without an alarm it is null"),
        (
            r#"{"id":"1","steps":[{"block":0,"shape":"line"}],"alarm":null}"#,
            "step 0, counted from 0: a line has an \"end\"",
        ),
        (r#"{"id":"1","steps":[{"block":0,"shape":"arc","end":[1,2]}],"alarm":null}"#, "an arc has a \"centre\""),
        (r#"{"id":"1","steps":[{"shape":"hold"}],"alarm":null}"#, "missing field `block`"),
        (r#"{"id":"1","steps":[{"block":3,"shape":"hold"}],"alarm":null}"#, "names block 3, but the program has 3"),
        (r#"{"id":"1","steps":[],"alarm":{"block":0,"alarm":"E12"}}"#, "\"E12\" is not the name of a alarm"),
        (r#"{"steps":[],"alarm":null}"#, "the line has no \"id\""),
        (r#"{"id":7,"steps":[],"alarm":null}"#, "the id 7 is a number"),
        (r#"{"id":"1","id":"2","steps":[],"alarm":null}"#, "duplicate field `id`"),
    ] {
        let told = garbled(answer);
        assert!(told.contains(words), "{answer}\n{told}");
    }
}

#[test]
fn a_device_that_does_not_answer_is_told_in_plain_words() {
    let told = |command| fault_of(command).to_string();
    assert_eq!(told("sleep 60"), "timeout: no answer within 0.3 s");
    assert_eq!(told("printf '{'; sleep 60"), "timeout: no answer within 0.3 s; a line that is not complete was there");
    assert_eq!(told("true"), "no-answer: the device ended, exit status 0, without answering");
    assert_eq!(
        told("printf '{'"),
        "no-answer: the device ended, exit status 0, without answering; its last line is not complete"
    );
    assert_eq!(told("exec >&-; sleep 61"), "no-answer: the device closed its standard output");
    assert_eq!(told("echo broken >&2; exit 3"), "crash: the device ended with exit status 3; it said: broken");
    assert_eq!(told("kill -SEGV $$"), "crash: the device ended with SIGSEGV, a wrong memory access");
    assert!(told("no-such-command").starts_with("crash: the device ended with the shell's complaint"));
    assert_eq!(told("cat /dev/zero"), "garbled: a line of more than 1048576 bytes");
    assert!(
        told(r#"echo '{"id":"5","steps":[],"alarm":null}'"#).contains("an answer for the id `5`, which nothing waits")
    );
}

#[test]
fn what_a_device_started_ends_with_it() {
    let marker = tempfile::NamedTempFile::new().unwrap();
    let path = marker.path().display();
    // The child of the device writes on, once the device itself has been killed.
    fault_of(&format!("(sleep 1; echo alive > '{path}') & sleep 60"));
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert_eq!(std::fs::read_to_string(marker.path()).unwrap(), "");
}

#[test]
fn a_device_may_answer_in_any_order_and_name_numbers_as_strings() {
    // Answers are kept back until two requests have come, and given last one first.
    let command = r#"while read -r one && read -r two; do
        for line in "$two" "$one"; do
            id=${line#*'"id":"'}; id=${id%%'"'*}
            echo "{\"id\":\"$id\",\"steps\":[{\"block\":0,\"shape\":\"line\",\"end\":[\"0.1\",2e-1]}],\"alarm\":null}"
        done
    done"#;
    let mut device = Pipe::shell(command, &profile(), limits());
    let answers = device.answer_all(&profile().parameters, &[line(), line(), line(), line()]);
    assert_eq!(answers.len(), 4);
    for answer in answers {
        assert_eq!(answer.unwrap().steps[0].segment, Segment::Line { end: [0.1, 0.2] });
    }
}

#[test]
fn a_number_without_a_finite_decimal_is_not_asked() {
    let third = Movement::Line { end: [Rational::from((1, 3)), Rational::new()] };
    let mut device = Pipe::shell("exit 1", &profile(), limits());
    let answer = device.answer(&profile().parameters, &[Block::moving(third)]);
    assert!(matches!(answer, Err(DeviceFault::Unsupported(_))), "{answer:?}");
}

#[test]
fn a_request_reads_back_to_its_program() {
    for (name, _) in radcomp_spec::profile::BUILTIN {
        let profile = Profile::builtin(name).unwrap();
        let record = ProfileRecord::new(&profile, &profile.parameters);
        for (id, blocks) in programs(&profile, 2, 400, Grade::Binary64) {
            let Ok(line) = request(&id, &profile, &record, &blocks) else { continue };
            let asked = Asked::read(line.as_bytes()).unwrap();
            assert_eq!((asked.id, asked.parameters, asked.blocks), (id, profile.parameters, blocks));
        }
    }
}
