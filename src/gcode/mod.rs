//! G-code: read into blocks, and written from them.
//!
//! The reader keeps every decimal exact, resolves modal codes, units and diameters, and hands out one block at a time.
//! What it does not know it refuses: a word that it passed over could have moved the tool. Each refusal is a
//! [`Diagnostic`] that points at the word and cites the clause concerned.
//!
//! ```
//! use radcomp::gcode::{Tools, read};
//! use radcomp_spec::profile::Profile;
//! let mill = Profile::builtin("seed-mill").unwrap();
//! let tools = Tools::parse("[[tool]]\nnumber = 1\nradius = \"5\"", "tools.toml")?;
//! let program = read("part.nc", b"G41 D1 G01 X10. Y0\nX25.4\n", &mill, &tools)?;
//! assert_eq!(program.blocks.len(), 2);
//! # Ok::<(), radcomp::gcode::Diagnostic>(())
//! ```

mod arrange;
mod axes;
mod codes;
mod diagnostic;
mod offsets;
mod print;
mod reader;
mod state;
#[cfg(test)]
mod tests;
mod tools;
mod word;

use radcomp_spec::Block;
use radcomp_spec::parameters::{Measure, Plane, Tip};
use radcomp_spec::profile::Profile;
use rug::Rational;

pub use diagnostic::{Diagnostic, Fault, Kind};
pub use print::{Listing, PrintError, print, print_blocks};
pub use reader::{MOST_LINE_BYTES, Reader};
pub use tools::{Tool, Tools};
pub use word::MOST_DIGITS;

/// A program, read.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// The file's name, for messages.
    pub name: String,
    /// The plane of all its movements.
    pub plane: Plane,
    /// What the X words of the program measured; the blocks hold radius values.
    pub x_words: Measure,
    /// Its blocks. The tool starts at the point (0, 0) of the plane, with 0 on the normal.
    pub blocks: Vec<ReadBlock>,
}

/// The nose of a turning tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Nose {
    /// Its radius, in millimetres; not negative.
    pub radius: Rational,
    /// Where the imaginary tip stands, seen from its centre.
    pub tip: Tip,
}

/// A block of a program, with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadBlock {
    /// What compensation sees. `rapid` is set where G00 moves an axis, the normal one too, and in a dummy block under G00.
    pub block: Block<Rational>,
    /// The line, from 1.
    pub line: u32,
    /// The digits of its N word.
    pub sequence: Option<String>,
    /// The coordinate on the plane's normal axis at the end of the block, absolute, in millimetres.
    pub normal: Rational,
    /// The nose of the tool at the vectors that belong to the block; none for a tool without an orientation
    /// ([TRC-TIP-01], [TRC-TIP-03]).
    pub nose: Option<Nose>,
    /// The tip orientation of the tool that the block selects, if it selects one that has an orientation.
    pub orientation: Option<u8>,
}

/// Reads a whole program.
///
/// # Errors
///
/// The first fault of the program.
///
/// # Exactness
///
/// Every number is the decimal as written, times 25.4 in inches and halved where it is a diameter.
pub fn read(name: &str, text: &[u8], profile: &Profile, tools: &Tools) -> Result<Program, Diagnostic> {
    let mut reader = Reader::new(name, text, profile, tools);
    let blocks = reader.by_ref().collect::<Result<Vec<_>, _>>()?;
    Ok(Program { name: name.to_owned(), plane: reader.plane(), x_words: profile.machine.x_words, blocks })
}
