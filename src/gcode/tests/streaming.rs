//! A program of a million lines, read in the memory of one.

use std::cell::Cell;
use std::io::{BufReader, Read};

use radcomp_spec::profile::Profile;

use super::tools;
use crate::gcode::{Kind, MOST_LINE_BYTES, Reader};

/// The lines of a zigzag, made as they are read: the program never stands in memory.
struct Zigzag {
    lines: u32,
    rest: Vec<u8>,
}

impl Read for Zigzag {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        if self.rest.is_empty() && self.lines > 0 {
            self.lines -= 1;
            let n = self.lines;
            self.rest = format!("N{n} G01 X{}.{:03} Y-{}.5 (line {n})\r\n", n % 1000, n % 997, n % 77).into_bytes();
        }
        let count = self.rest.len().min(into.len());
        into[..count].copy_from_slice(&self.rest[..count]);
        self.rest.drain(..count);
        Ok(count)
    }
}

#[test]
fn a_million_lines_are_read_in_the_memory_of_one() {
    let (profile, tools) = (Profile::builtin("seed-mill").unwrap(), tools());
    let source = BufReader::new(Zigzag { lines: 1_000_000, rest: Vec::new() });
    let mut reader = Reader::new("zigzag.nc", source, &profile, &tools);
    let mut last = 0;
    for read in reader.by_ref() {
        last = read.unwrap().line;
    }
    assert_eq!(last, 1_000_000);
    assert!(reader.buffer_capacity() <= 256, "the line buffer has grown to {} bytes", reader.buffer_capacity());
}

/// Blanks without end, and how many of them were taken.
struct Counted<'a> {
    given: &'a Cell<usize>,
}

impl Read for Counted<'_> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        into.fill(b' ');
        self.given.set(self.given.get() + into.len());
        Ok(into.len())
    }
}

#[test]
fn a_line_without_end_is_not_read_into_memory() {
    let (profile, tools) = (Profile::builtin("seed-mill").unwrap(), tools());
    let given = Cell::new(0);
    let source = BufReader::with_capacity(1, Counted { given: &given });
    let mut reader = Reader::new("endless.nc", source, &profile, &tools);
    let fault = reader.next().unwrap().unwrap_err();
    assert_eq!((fault.kind, fault.line, fault.column as usize), (Kind::LineTooLong, 1, MOST_LINE_BYTES + 1));
    assert!(reader.next().is_none());
    assert_eq!(given.get(), MOST_LINE_BYTES + 2);
    assert!(reader.buffer_capacity() <= 4 * MOST_LINE_BYTES);
}

#[test]
fn the_longest_line_is_read_with_either_end() {
    let (profile, tools) = (Profile::builtin("seed-mill").unwrap(), tools());
    for end in ["", "\n", "\r\n"] {
        let comment = "x".repeat(MOST_LINE_BYTES - "G01X1()".len());
        let text = format!("G01X1({comment}){end}");
        let reads: Vec<_> = Reader::new("long.nc", text.as_bytes(), &profile, &tools).collect();
        assert!(matches!(&reads[..], [Ok(_)]), "{reads:?}");
        let longer = format!(" {text}");
        let fault = Reader::new("long.nc", longer.as_bytes(), &profile, &tools).next().unwrap().unwrap_err();
        assert_eq!(fault.kind, Kind::LineTooLong);
    }
}

/// A source that fails.
struct Broken;

impl Read for Broken {
    fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
        Err(std::io::Error::other("the disk is gone"))
    }
}

#[test]
fn a_source_that_fails_is_named() {
    let (profile, tools) = (Profile::builtin("seed-mill").unwrap(), tools());
    let source = BufReader::new("G01 X1\n".as_bytes().chain(Broken));
    let reads: Vec<_> = Reader::new("part.nc", source, &profile, &tools).collect();
    let fault = reads[1].as_ref().unwrap_err();
    assert_eq!((reads.len(), fault.kind), (2, Kind::Unreadable));
    assert!(fault.to_string().contains("part.nc: the disk is gone"));
    assert_eq!(fault.help.as_deref(), Some("lines before 2 were read"));
    let at_once = Reader::new("part.nc", BufReader::new(Broken), &profile, &tools).next().unwrap().unwrap_err();
    assert_eq!((at_once.kind, at_once.help), (Kind::Unreadable, None));
}

#[test]
fn a_byte_that_is_no_text_is_pointed_at() {
    let (profile, tools) = (Profile::builtin("seed-mill").unwrap(), tools());
    let fault =
        Reader::new("part.nc", &b"G01 X1\nG01 (\xFFab) X2\n"[..], &profile, &tools).nth(1).unwrap().unwrap_err();
    assert_eq!((fault.kind, fault.line, fault.column, fault.length), (Kind::NotText, 2, 6, 1));
}

#[test]
fn a_block_tells_the_orientation_of_the_tool_it_selects() {
    let (profile, tools) = (Profile::builtin("yasnac-lx").unwrap(), tools());
    let reads = Reader::new("part.nc", &b"T0303\nG01 Z1\nT0101\n"[..], &profile, &tools);
    let orientations: Vec<_> = reads.map(|read| read.unwrap().orientation).collect();
    assert_eq!(orientations, [Some(3), None, None]);
}
