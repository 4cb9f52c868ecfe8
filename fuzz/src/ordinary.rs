//! A target as an ordinary program, without libFuzzer: `TARGET [--seconds N] [--seed N] [FILE OR FOLDER]...` runs it over
//! the files, and then for so many seconds over inputs made from the seed, most of them files with some bytes changed.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use crate::ledger;

/// Runs a target over what the arguments name; a panic of the target ends the program, its input printed before.
pub fn main(target: fn(&[u8])) -> ExitCode {
    let (mut seconds, mut seed, mut files) = (0, 1, Vec::new());
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let number = |text: Option<String>| text.and_then(|text| text.parse().ok());
        match argument.as_str() {
            "--seconds" | "--seed" => {
                let Some(value) = number(arguments.next()) else {
                    eprintln!("{argument} takes a whole number");
                    return ExitCode::from(2);
                };
                *(if argument == "--seed" { &mut seed } else { &mut seconds }) = value;
            }
            _ => collect(Path::new(&argument), &mut files),
        }
    }
    let inputs: Vec<_> = files.iter().filter_map(|file| std::fs::read(file).ok()).collect();
    inputs.iter().for_each(|input| run(target, input));
    let started = Instant::now();
    let (mut dice, mut made) = (Dice(seed), 0_u64);
    while started.elapsed() < Duration::from_secs(seconds) {
        run(target, &dice.input(&inputs));
        made += 1;
    }
    let rate = made as f64 / started.elapsed().as_secs_f64().max(1e-9);
    println!("{} files, then {made} inputs made from seed {seed}, {rate:.0} a second", inputs.len());
    print!("{}", ledger::report());
    ExitCode::SUCCESS
}

fn run(target: fn(&[u8]), input: &[u8]) {
    ledger::ran();
    let told = Told(input);
    target(input);
    std::mem::forget(told);
}

/// Tells the input if the target panics.
struct Told<'a>(&'a [u8]);

impl Drop for Told<'_> {
    fn drop(&mut self) {
        eprintln!("the input: {:?}", self.0);
    }
}

/// The files of a folder, or the file.
fn collect(path: &Path, files: &mut Vec<PathBuf>) {
    match std::fs::read_dir(path) {
        Ok(entries) => {
            let mut entries: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
            entries.sort();
            entries.iter().for_each(|entry| collect(entry, files));
        }
        Err(_) => files.push(path.to_owned()),
    }
}

/// A small generator of numbers: SplitMix64.
#[derive(Debug)]
pub struct Dice(pub u64);

impl Dice {
    /// The next number.
    pub fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// An input: some bytes, or one of the inputs with some bytes changed.
    pub fn input(&mut self, inputs: &[Vec<u8>]) -> Vec<u8> {
        if inputs.is_empty() || self.roll().is_multiple_of(4) {
            let length = self.roll() % 64;
            return (0..length).map(|_| self.roll() as u8).collect();
        }
        let mut input = inputs[(self.roll() % inputs.len() as u64) as usize].clone();
        for _ in 0..=self.roll() % 4 {
            if !input.is_empty() {
                let at = (self.roll() % input.len() as u64) as usize;
                input[at] = self.roll() as u8;
            }
        }
        input
    }
}
