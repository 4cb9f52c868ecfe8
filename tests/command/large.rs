//! A program of a million blocks, in bounded memory.

use std::io::{BufRead, BufReader, BufWriter, Write};
use std::process::{Command, Stdio};

/// Blocks of the program.
const BLOCKS: usize = 1_000_000;
/// The most memory that the command may have had, in kilobytes.
const MOST_MEMORY: u64 = 64 * 1024;

#[test]
#[cfg_attr(not(target_os = "linux"), ignore = "reads the memory from /proc")]
fn a_million_blocks_run_in_bounded_memory_in_doubles() {
    run_a_million_blocks(&["--engine", "impl"]);
}

#[test]
#[ignore = "the model needs 25 s optimised, minutes else: cargo test --release --test command -- --ignored"]
fn a_million_blocks_run_in_bounded_memory_exactly() {
    run_a_million_blocks(&["--engine", "model"]);
}

fn run_a_million_blocks(engine: &[&str]) {
    let mut child = Command::new(assert_cmd::cargo::cargo_bin("radcomp"))
        .args(["run", "-", "-p", "seed-mill", "-r", "1", "--format", "canon"])
        .args(engine)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut program = BufWriter::new(child.stdin.take().unwrap());
    let output = BufReader::new(child.stdout.take().unwrap());
    let (finish, finished) = std::sync::mpsc::channel::<()>();
    let writer = std::thread::spawn(move || {
        writeln!(program, "G41 D1 G91 G01 X10 F100").unwrap();
        for index in 1..BLOCKS {
            // A staircase with corners that are not rational, and comments between.
            match index % 4 {
                0 => writeln!(program, "X7 Y3"),
                1 => writeln!(program, "X5 (a comment)"),
                2 => writeln!(program, "N{} X3 Y-2", index % 10_000),
                _ => writeln!(program, "\nX4 Y1"),
            }
            .unwrap();
        }
        program.flush().unwrap();
        // The command stays alive until its memory has been read.
        finished.recv().unwrap();
    });
    let (mut lines, mut memory) = (0, 0);
    for line in output.lines() {
        line.unwrap();
        lines += 1;
        if lines == BLOCKS - 10_000 {
            memory = peak_memory(child.id());
            finish.send(()).unwrap();
        }
    }
    writer.join().unwrap();
    assert!(child.wait().unwrap().success());
    assert_eq!(lines, BLOCKS);
    assert!(memory > 0 && memory < MOST_MEMORY, "{memory} kB");
}

/// The most memory that a process has had so far, in kilobytes.
fn peak_memory(process: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    peak.split_whitespace().next().unwrap().parse().unwrap()
}
