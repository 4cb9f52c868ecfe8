//! Programs as `rs274` reads them.
//!
//! Each line has an N word, which comes back with an error message, and an F word, which comes back as a feed rate
//! between the moves. The interpreter keeps feed rates and moves in one queue, so that a move belongs to the block whose
//! feed it runs with, however late it is printed. The radius of the tool stands in the program, with `G41.1 D`.

use std::fmt::Write;

use radcomp_model::number::format_decimal;
use radcomp_spec::parameters::Plane;
use radcomp_spec::{Block, Centre, Compensation, Direction, Movement, Side};
use rug::Rational;

use crate::device::DeviceFault;

/// What an answer to a program is read with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// The block moves in the plane, or leads the tool back to where it is programmed ([TRC-CANCEL-03]).
    pub moves: bool,
    /// It is an arc.
    pub arc: bool,
    /// It is an arc that ends where it starts.
    pub whole_turn: bool,
    /// It gives the compensation code that is in force already.
    pub same_code: bool,
    /// It puts the radius in force with the other sign, without a compensation code.
    pub other_sign: bool,
}

/// The line that comes before a program's answer, and the one after it, without the id.
pub(super) const BEGIN: &str = "radcomp begin ";
pub(super) const END: &str = "radcomp end ";

/// The lines of a program with its marks, and what is known of each block.
///
/// # Errors
///
/// [`DeviceFault::Unsupported`] for what `rs274` has no words for.
pub(super) fn program(id: &str, plane: Plane, blocks: &[Block<Rational>]) -> Result<(String, Vec<Place>), DeviceFault> {
    let (code, [a, b], [i, j]) = match plane {
        Plane::Xy => ("g17", ['x', 'y'], ['i', 'j']),
        Plane::Zx => ("g18", ['z', 'x'], ['k', 'i']),
        Plane::Yz => return unsupported("compensation in the plane G19"),
    };
    // What an error has left behind ends here; the tool starts at the origin, without compensation.
    let mut text = format!("m2\ng21 {code} g90 g40 g64\ng0 x0 y0 z0\n(print,{BEGIN}{id})\n");
    let mut state = State {
        at: [Rational::new(), Rational::new()],
        radius: Rational::new(),
        side: None,
        started: false,
        off_contour: false,
    };
    let mut places = Vec::with_capacity(blocks.len());
    for (index, block) in blocks.iter().enumerate() {
        let number = index + 1;
        // Writing to a string cannot fail.
        let _ = write!(text, "n{number}");
        let side = state.side;
        let negated = Rational::from(-&state.radius);
        let other_sign = side.is_some() && block.compensation.is_none() && block.radius.as_ref() == Some(&negated);
        state.codes(block, &mut text)?;
        let same_code = side.is_some_and(|side| block.compensation == Some(Compensation::On(side)));
        let point = |[first, second]: &[Rational; 2]| Ok(format!(" {a}{} {b}{}", decimal(first)?, decimal(second)?));
        let mut place = Place { moves: false, arc: false, whole_turn: false, same_code, other_sign };
        match &block.movement {
            // A dwell of no time is a block without movement.
            Movement::None if block.compensation.is_none() => text.push_str(" g4 p0"),
            Movement::None => {}
            Movement::Dummy { .. } => return unsupported("dummy blocks"),
            Movement::HeldVector { .. } | Movement::NewVector { .. } | Movement::CornerArc { .. } => {
                return unsupported("vectors given by the program");
            }
            Movement::Line { end } => {
                text.push_str(if block.rapid { " g0" } else { " g1" });
                text.push_str(&point(end)?);
                place.moves = *end != state.at || state.off_contour;
                state.move_to(end);
            }
            Movement::Arc { end, centre, direction } => {
                text.push_str(if *direction == Direction::Clockwise { " g2" } else { " g3" });
                text.push_str(&point(end)?);
                match centre {
                    Centre::FromStart([first, second]) => {
                        let _ = write!(text, " {i}{} {j}{}", decimal(first)?, decimal(second)?);
                    }
                    Centre::Radius(radius) => {
                        let _ = write!(text, " r{}", decimal(radius)?);
                    }
                }
                place = Place { moves: true, arc: true, whole_turn: *end == state.at, ..place };
                state.move_to(end);
            }
        }
        let _ = writeln!(text, " f{number}");
        places.push(place);
    }
    let _ = writeln!(text, "m2\n(print,{END}{id})");
    Ok((text, places))
}

/// As much of the program's state as its lines depend on.
struct State {
    at: [Rational; 2],
    radius: Rational,
    /// The tool's side; none without compensation.
    side: Option<Side>,
    /// A block has moved with compensation on.
    started: bool,
    /// Compensation has been cancelled, and no block has moved since.
    off_contour: bool,
}

impl State {
    fn move_to(&mut self, end: &[Rational; 2]) {
        self.at.clone_from(end);
        self.started = self.side.is_some();
        self.off_contour = false;
    }

    fn codes(&mut self, block: &Block<Rational>, text: &mut String) -> Result<(), DeviceFault> {
        if block.stops_look_ahead {
            return unsupported("codes that stop reading ahead");
        }
        if block.not_in_mode.is_some() {
            return unsupported("codes that are not for offset mode");
        }
        if block.vector.is_some() {
            return unsupported("I, J and K beside a compensation code");
        }
        if block.corner.is_some() {
            return unsupported("a choice of the outer corner");
        }
        if block.approach.is_some() {
            return unsupported("NORM and KONT");
        }
        if let Some(radius) = &block.radius {
            // The interpreter takes a D word with G41 and G42 alone. Without them it is told where it matters.
            if self.side.is_some() && *radius != self.radius && block.compensation.is_none() {
                let _ = write!(text, " d{}", decimal(&Rational::from(radius * 2))?);
            }
            self.radius.clone_from(radius);
        }
        match block.compensation {
            None => {}
            Some(Compensation::Off) => {
                self.side = None;
                self.off_contour |= self.started;
                self.started = false;
                text.push_str(" g40");
            }
            Some(Compensation::On(side)) => {
                self.side = Some(side);
                self.off_contour = false;
                let code = if side == Side::Left { "g41.1" } else { "g42.1" };
                let diameter = decimal(&Rational::from(&self.radius * 2))?;
                let _ = write!(text, " {code} d{diameter}");
            }
        }
        Ok(())
    }
}

fn decimal(value: &Rational) -> Result<String, DeviceFault> {
    format_decimal(value).ok_or_else(|| DeviceFault::Unsupported("numbers without a finite decimal".to_owned()))
}

fn unsupported<T>(what: &str) -> Result<T, DeviceFault> {
    Err(DeviceFault::Unsupported(format!("rs274 has no words for {what}")))
}
