//! The canonical calls that the LinuxCNC interpreter `rs274` prints, for the path of the tool's centre.
//!
//! The calls and their arguments are those of `rs274`, which writes four decimals; here every number has 17 significant
//! digits, so that two outcomes are told apart whenever their doubles differ. X is a radius value. A block that moves
//! nothing makes no call; `rs274` writes one for a straight move of no length. Calls for anything
//! but moves (feed, units, plane) are left out, so the calls are numbered differently.

use std::io::{self, Write};

use radcomp_spec::block::Point;
use radcomp_spec::parameters::Plane;
use radcomp_spec::{Direction, Segment, Step};
use rug::Rational;

use crate::explain::Coordinate;

/// Significant digits that tell all doubles apart.
pub const SIGNIFICANT_DIGITS: usize = 17;

/// The most decimals that are written of a small number.
const MOST_DECIMALS: usize = 40;

/// Writes path elements as canonical calls.
#[derive(Debug)]
pub struct Canon<N> {
    /// Where the tool's centre stands in the plane.
    tool: Point<N>,
    /// Where it stands on the normal axis, in millimetres.
    normal: Rational,
    /// The number of the next call.
    call: u64,
    digits: Option<usize>,
}

impl<N: Coordinate> Canon<N> {
    /// A writer with the tool's centre at this point of the plane and 0 on the normal axis; numbers have so many
    /// decimals if `digits` are given, else [`SIGNIFICANT_DIGITS`].
    pub fn new(start: Point<N>, digits: Option<usize>) -> Self {
        Canon { tool: start, normal: Rational::new(), call: 1, digits }
    }

    /// Writes the call of one path element, if it makes one.
    ///
    /// `normal` is the coordinate on the normal axis at the end of the element's block. It belongs to the block's own
    /// move; a block that moves along the normal axis alone is a straight move at the tool's place.
    ///
    /// # Errors
    ///
    /// Those of the output.
    pub fn step(
        &mut self,
        out: &mut impl Write,
        step: &Step<N>,
        sequence: Option<&str>,
        normal: &Rational,
        plane: Plane,
    ) -> io::Result<()> {
        match &step.segment {
            Segment::Hold if *normal == self.normal => return Ok(()),
            Segment::Hold => self.normal.clone_from(normal),
            Segment::Line { end } | Segment::Arc { end, .. } => {
                self.tool.clone_from(end);
                if step.main {
                    self.normal.clone_from(normal);
                }
            }
        }
        let [a, b] = self.tool.clone().map(|value| self.number(&value));
        let normal = self.number(&radcomp_model::number::Real::from(&self.normal));
        let zero = self.number(&0.0_f64);
        let call = match &step.segment {
            Segment::Hold | Segment::Line { .. } => {
                let name = if step.rapid { "STRAIGHT_TRAVERSE" } else { "STRAIGHT_FEED" };
                let [x, y, z] = match plane {
                    Plane::Xy => [a, b, normal],
                    Plane::Zx => [b, normal, a],
                    Plane::Yz => [normal, a, b],
                };
                format!("{name}({x}, {y}, {z}, {zero}, {zero}, {zero})")
            }
            Segment::Arc { centre, direction, .. } => {
                let [first, second] = centre.clone().map(|value| self.number(&value));
                let rotation = match direction {
                    Direction::Counterclockwise => 1,
                    Direction::Clockwise => -1,
                };
                format!("ARC_FEED({a}, {b}, {first}, {second}, {rotation}, {normal}, {zero}, {zero}, {zero})")
            }
        };
        let number = sequence.unwrap_or(".....");
        writeln!(out, "{:5} N{number:<6}{call}", self.call)?;
        self.call += 1;
        Ok(())
    }

    fn number(&self, value: &impl Coordinate) -> String {
        let decimals = self.digits.unwrap_or_else(|| decimals(value.approximate()));
        value.decimal(decimals)
    }
}

/// How many decimals a number of this size has after [`SIGNIFICANT_DIGITS`] significant digits.
fn decimals(size: f64) -> usize {
    if size == 0.0 || !size.is_finite() {
        return SIGNIFICANT_DIGITS - 1;
    }
    // At most 309 before the point, or as many after it.
    let before = size.abs().log10().floor() as i64 + 1;
    let after = SIGNIFICANT_DIGITS as i64 - before;
    usize::try_from(after).unwrap_or(0).min(MOST_DECIMALS)
}

#[cfg(test)]
mod tests {
    use radcomp_model::number::Real;
    use radcomp_spec::clause;

    use super::*;

    fn line(end: [&str; 2], main: bool) -> Step<Real> {
        let end = end.map(|number| Real::parse(number).unwrap());
        Step { block: 0, clause: clause::TRC_MODE_01, rapid: false, main, segment: Segment::Line { end } }
    }

    fn written(steps: &[(Step<Real>, i32)], plane: Plane, digits: Option<usize>) -> String {
        let mut out = Vec::new();
        let mut canon = Canon::new([Real::zero(), Real::zero()], digits);
        for (step, normal) in steps {
            canon.step(&mut out, step, Some("10"), &Rational::from(*normal), plane).unwrap();
        }
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn four_decimals_are_what_rs274_prints() {
        let steps = [(line(["1", "5"], true), 0)];
        let expected = "    1 N10    STRAIGHT_FEED(1.0000, 5.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n";
        assert_eq!(written(&steps, Plane::Xy, Some(4)), expected);
        let turned = "    1 N10    STRAIGHT_FEED(5.0000, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)\n";
        assert_eq!(written(&steps, Plane::Zx, Some(4)), turned);
    }

    #[test]
    fn the_normal_axis_moves_with_the_blocks_own_move() {
        let corner = (line(["1", "0"], false), -2);
        let own = (line(["2", "0"], true), -2);
        let hold = Step { segment: Segment::Hold, ..line(["0", "0"], false) };
        let text = written(&[corner, own, (hold.clone(), -2), (hold, -3)], Plane::Xy, Some(0));
        let depths: Vec<&str> = text.lines().map(|call| call.split(", ").nth(2).unwrap()).collect();
        assert_eq!(depths, ["0", "-2", "-3"]);
    }

    #[test]
    fn numbers_have_seventeen_significant_digits() {
        let text = written(&[(line(["10 + 5·√2", "1/300"], true), 0)], Plane::Xy, None);
        assert!(text.contains("STRAIGHT_FEED(17.071067811865475, 0.0033333333333333333, "), "{text}");
    }
}
