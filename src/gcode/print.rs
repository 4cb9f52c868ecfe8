//! Programs written as G-code that reads back to the same blocks.

mod error;
mod line;

use radcomp_spec::parameters::{Activation, ApproachCodes, CornerCodes, Measure, Plane};
use radcomp_spec::profile::Profile;
use radcomp_spec::{AlarmKind, Approach, Block, Centre, Compensation, Direction, Movement, OuterCorner, Side};
use rug::Rational;

use super::axes::{AXES, CENTRES, axes_of, name_of};
use super::{Program, Tool, Tools, offsets, read};
use line::Words;

pub use error::PrintError;

/// A program written as G-code, with the tool table that it needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The G-code.
    pub program: String,
    /// The tool table.
    pub tools: Tools,
    /// The tool table as its file's text.
    pub tool_table: String,
}

/// Writes a program, with its sequence numbers and its moves along the normal.
///
/// # Errors
///
/// When the blocks have no G-code under this profile.
pub fn print(program: &Program, profile: &Profile) -> Result<Listing, PrintError> {
    let lines = program.blocks.iter().map(|read| Source {
        block: &read.block,
        sequence: read.sequence.clone(),
        normal: Some(&read.normal),
        orientation: read.orientation,
    });
    listing(lines.collect(), program.plane, profile)
}

/// Writes blocks as a program in the profile's plane, numbered N1, N2, … so that N is the block's index plus one.
///
/// The program reads back to the same blocks, with one liberty that changes no outcome: where compensation comes on before
/// any radius is in force, the radius 0 that counts there ([TRC-MODE-03]) is written out.
///
/// # Errors
///
/// When the blocks have no G-code under this profile: a number with more decimals than the reader takes, a code that the
/// profile does not have or does not tell, an arc at rapid traverse, a dummy block outside offset mode, a code that is
/// not for offset mode outside it or with a movement.
pub fn print_blocks(blocks: &[Block<Rational>], profile: &Profile) -> Result<Listing, PrintError> {
    let lines = blocks.iter().enumerate().map(|(index, block)| Source {
        block,
        sequence: Some((index + 1).to_string()),
        normal: None,
        orientation: None,
    });
    listing(lines.collect(), profile.machine.plane, profile)
}

/// A block to write.
struct Source<'b> {
    block: &'b Block<Rational>,
    sequence: Option<String>,
    normal: Option<&'b Rational>,
    orientation: Option<u8>,
}

fn listing(lines: Vec<Source<'_>>, plane: Plane, profile: &Profile) -> Result<Listing, PrintError> {
    let mut printer = Printer { profile, plane, tools: Vec::new(), normal: Rational::new(), expected: Vec::new() };
    let mut program = format!("%\n(profile {}, plane {})\n", profile.name, brief(plane));
    for (index, source) in lines.iter().enumerate() {
        let mut line = Words::of_block(index);
        printer.block(source, &mut line)?;
        program.push_str(line.text());
        program.push('\n');
    }
    program.push_str("%\n");
    let tools = printer.table();
    printer.check(&program, &tools)?;
    // `offset` has made sure that the radii have decimals.
    let tool_table = tools.to_toml().unwrap_or_default();
    Ok(Listing { program, tools, tool_table })
}

/// A plane without parentheses, which would end a comment.
fn brief(plane: Plane) -> &'static str {
    &name_of(plane)[..3]
}

struct Printer<'p> {
    profile: &'p Profile,
    plane: Plane,
    /// The tool of each offset number, from 1.
    tools: Vec<Tool>,
    /// The coordinate on the normal axis.
    normal: Rational,
    /// What the program has to read back as.
    expected: Vec<Block<Rational>>,
}

impl Printer<'_> {
    fn block(&mut self, source: &Source<'_>, line: &mut Words) -> Result<(), PrintError> {
        let block = source.block;
        if let Some(sequence) = &source.sequence {
            line.word('N', sequence);
        }
        if self.expected.is_empty() && self.plane != self.profile.machine.plane {
            line.code(brief(self.plane));
        }
        let mut expected = block.clone();
        let unset = matches!(block.compensation, Some(Compensation::On(_))) && self.tools.is_empty();
        if unset && block.radius.is_none() {
            expected.radius = Some(Rational::new());
        }
        if let Some(compensation) = block.compensation {
            line.code(self.compensation_code(compensation, line.block())?);
        }
        if let Some(corner) = block.corner {
            line.code(self.corner_code(corner, line.block())?);
        }
        if let Some(approach) = block.approach {
            line.code(self.approach_code(approach, line.block())?);
        }
        if let Some(radius) = &expected.radius {
            self.offset(radius, source.orientation, line)?;
        }
        match block.not_in_mode {
            // The movement of such a block is not looked at.
            Some(kind) => line.code(self.code_not_in_mode(kind, line.block())?),
            None => self.movement(block, source.normal, line)?,
        }
        if block.stops_look_ahead {
            line.code("M01");
        }
        if line.text().is_empty() {
            line.code("G04 P0");
        }
        self.expected.push(expected);
        Ok(())
    }

    fn compensation_code(&self, wanted: Compensation, block: usize) -> Result<&'static str, PrintError> {
        let (activation, name) = match wanted {
            Compensation::Off => (Activation::Cancel, "compensation off"),
            Compensation::On(Side::Left) => (Activation::Left, "compensation left"),
            Compensation::On(Side::Right) => (Activation::Right, "compensation right"),
        };
        let codes = ["G40", "G41", "G42", "G43", "G44"];
        let mut known = codes.into_iter().zip(self.profile.activation);
        let code = known.find(|(_, meaning)| *meaning == activation).map(|(code, _)| code);
        code.ok_or(PrintError::NoCode { block, wanted: name })
    }

    fn corner_code(&self, wanted: OuterCorner, block: usize) -> Result<&'static str, PrintError> {
        match (self.profile.machine.corner_codes, wanted) {
            (CornerCodes::M96M97, OuterCorner::Arc) => Ok("M96"),
            (CornerCodes::M96M97, OuterCorner::Intersection) => Ok("M97"),
            (CornerCodes::G450G451, OuterCorner::Arc) => Ok("G450"),
            (CornerCodes::G450G451, OuterCorner::LimitAngle) => Ok("G451"),
            _ => Err(PrintError::NoCode { block, wanted: "this choice of the outer corner" }),
        }
    }

    fn approach_code(&self, wanted: Approach, block: usize) -> Result<&'static str, PrintError> {
        match (self.profile.machine.approach_codes, wanted) {
            (ApproachCodes::NormKont, Approach::Norm) => Ok("NORM"),
            (ApproachCodes::NormKont, Approach::Kont) => Ok("KONT"),
            _ => Err(PrintError::NoCode { block, wanted: "this choice of start-up and cancel" }),
        }
    }

    /// The code that is not for offset mode, with the fewest words that a control would want with it.
    fn code_not_in_mode(&self, kind: AlarmKind, block: usize) -> Result<&'static str, PrintError> {
        match kind {
            AlarmKind::PlaneChangeInMode if self.plane == Plane::Xy => Ok("G18"),
            AlarmKind::PlaneChangeInMode => Ok("G17"),
            AlarmKind::ReferenceReturnInMode => Ok("G28"),
            AlarmKind::MachineCoordinatesInMode => Ok("G53 G00 X0"),
            AlarmKind::SetCoordinatesInMode => Ok("G92 X0"),
            AlarmKind::ToolChangeInMode => Ok("M06"),
            AlarmKind::CannedCycleInMode => Ok("G81 X0 Z0 R0"),
            _ => Err(PrintError::NoCode { block, wanted: "an alarm of another kind than that of a code" }),
        }
    }

    /// The word that selects a tool.
    fn offset(&mut self, radius: &Rational, orientation: Option<u8>, line: &mut Words) -> Result<(), PrintError> {
        // The table has to be able to hold it.
        line.decimal(radius)?;
        let tool = Tool { orientation, ..Tool::of_radius(radius.clone()) };
        let index = self.tools.iter().position(|known| *known == tool).unwrap_or_else(|| {
            self.tools.push(tool);
            self.tools.len() - 1
        });
        let number = index + 1;
        if offsets::t_selects_offset(self.profile) {
            if number > 99 {
                return Err(PrintError::TooManyRadii);
            }
            line.word('T', &format!("{number:02}{number:02}"));
        } else {
            line.word('D', &number.to_string());
        }
        Ok(())
    }

    fn movement(
        &mut self,
        block: &Block<Rational>,
        normal: Option<&Rational>,
        line: &mut Words,
    ) -> Result<(), PrintError> {
        let [a, b, normal_axis] = axes_of(self.plane);
        let straight = if block.rapid { "G00" } else { "G01" };
        let mut to_normal = normal.filter(|normal| **normal != self.normal).cloned();
        match &block.movement {
            // A vector beside a code stands with a straight move in force, even if the block does not move.
            Movement::None if block.vector.is_some() => line.code(straight),
            Movement::None => {
                if block.rapid {
                    // What moves nothing in the plane at rapid traverse moves along the normal, if only to where it is.
                    to_normal = to_normal.or_else(|| Some(self.normal.clone()));
                }
                if to_normal.is_some() {
                    line.code(straight);
                }
            }
            Movement::Line { end } => {
                line.code(straight);
                self.point(AXES, end, line)?;
            }
            Movement::HeldVector { end } => {
                line.code(straight);
                line.code("G38");
                self.point(AXES, end, line)?;
            }
            Movement::NewVector { vector } => {
                line.code(straight);
                line.code("G38");
                self.vector(vector, line)?;
            }
            Movement::CornerArc { vector } => {
                line.code(straight);
                line.code("G39");
                if let Some(vector) = vector {
                    self.vector(vector, line)?;
                }
            }
            Movement::Arc { .. } if block.rapid => {
                return Err(PrintError::NoCode { block: line.block(), wanted: "an arc at rapid traverse" });
            }
            Movement::Arc { end, centre, direction } => {
                line.code(if *direction == Direction::Clockwise { "G02" } else { "G03" });
                self.point(AXES, end, line)?;
                match centre {
                    Centre::Radius(radius) => line.number('R', radius)?,
                    Centre::FromStart([first, second]) => {
                        line.number(CENTRES[a], first)?;
                        line.number(CENTRES[b], second)?;
                    }
                }
            }
            Movement::Dummy { vector } => {
                line.code(straight);
                for (axis, component) in [a, b].into_iter().zip(vector) {
                    let doubled = axis == 0 && self.profile.machine.dummy_first_axis == Measure::Diameter;
                    line.number(CENTRES[axis], &if doubled { component.clone() * 2 } else { component.clone() })?;
                }
            }
        }
        if let Some(vector) = &block.vector {
            self.vector(vector, line)?;
        }
        if let Some(normal) = to_normal {
            self.coordinate(AXES[normal_axis], &normal, line)?;
            self.normal = normal;
        }
        Ok(())
    }

    fn point(&self, letters: [char; 3], point: &[Rational; 2], line: &mut Words) -> Result<(), PrintError> {
        let [a, b, _] = axes_of(self.plane);
        self.coordinate(letters[a], &point[0], line)?;
        self.coordinate(letters[b], &point[1], line)
    }

    /// I, J, K beside a code: radius values ([TRC-VEC-01], [TRC-START-10], [TRC-CANCEL-08]).
    fn vector(&self, vector: &[Rational; 2], line: &mut Words) -> Result<(), PrintError> {
        let [a, b, _] = axes_of(self.plane);
        line.number(CENTRES[a], &vector[0])?;
        line.number(CENTRES[b], &vector[1])
    }

    /// An axis word: X as the profile measures it.
    fn coordinate(&self, letter: char, value: &Rational, line: &mut Words) -> Result<(), PrintError> {
        let doubled = letter == 'X' && self.profile.machine.x_words == Measure::Diameter;
        line.number(letter, &if doubled { value.clone() * 2 } else { value.clone() })
    }

    fn table(&self) -> Tools {
        let numbered = (1..).zip(&self.tools);
        numbered.fold(Tools::empty(), |table, (number, tool)| table.with_tool(number, tool.clone()))
    }

    /// Reads the program back and compares.
    fn check(&self, program: &str, tools: &Tools) -> Result<(), PrintError> {
        let read = read("printed program", program.as_bytes(), self.profile, tools);
        let read = read.map_err(|diagnostic| PrintError::Refused(Box::new(diagnostic)))?;
        let same = read.blocks.iter().zip(&self.expected).take_while(|(read, expected)| read.block == **expected);
        match same.count() {
            count if count == self.expected.len() && count == read.blocks.len() => Ok(()),
            block => Err(PrintError::Different { block }),
        }
    }
}
