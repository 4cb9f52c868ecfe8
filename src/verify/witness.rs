//! Whether a program is another one but for small changes of its numbers.

use radcomp_spec::{Block, Centre, Movement};
use rug::Rational;

/// The largest change of one number that makes `program` the `witness`; why they are not one program otherwise.
///
/// # Exactness
///
/// Exact.
pub(super) fn change(program: &[Block<Rational>], witness: &[Block<Rational>]) -> Result<Rational, String> {
    if program.len() != witness.len() {
        return Err(format!("the witness has {} blocks, the program {}", witness.len(), program.len()));
    }
    let mut largest = Rational::new();
    for (index, (block, moved)) in program.iter().zip(witness).enumerate() {
        if structure(block) != structure(moved) {
            return Err(format!("block N{} of the witness is another one, not only in its numbers", index + 1));
        }
        for (number, changed) in numbers(block).into_iter().zip(numbers(moved)) {
            let change = Rational::from(changed - number).abs();
            if change > largest {
                largest = change;
            }
        }
    }
    Ok(largest)
}

/// The largest magnitude among a program's numbers.
///
/// # Exactness
///
/// Exact.
pub(super) fn largest(program: &[Block<Rational>]) -> Rational {
    program.iter().flat_map(numbers).map(|number| number.clone().abs()).max().unwrap_or_default()
}

/// The numbers of a block, in an order that its structure fixes.
fn numbers(block: &Block<Rational>) -> Vec<&Rational> {
    let mut numbers: Vec<&Rational> = Vec::new();
    match &block.movement {
        Movement::None | Movement::CornerArc { vector: None } => {}
        Movement::Line { end } | Movement::HeldVector { end } => numbers.extend(end),
        Movement::Dummy { vector } | Movement::NewVector { vector } | Movement::CornerArc { vector: Some(vector) } => {
            numbers.extend(vector)
        }
        Movement::Arc { end, centre, .. } => {
            numbers.extend(end);
            match centre {
                Centre::FromStart(vector) => numbers.extend(vector),
                Centre::Radius(radius) => numbers.push(radius),
            }
        }
    }
    numbers.extend(&block.radius);
    numbers.extend(block.vector.iter().flatten());
    numbers
}

/// The block with every number zero: what is left is its structure.
fn structure(block: &Block<Rational>) -> Block<Rational> {
    let zero = || [Rational::new(), Rational::new()];
    Block {
        movement: match &block.movement {
            Movement::None => Movement::None,
            Movement::Line { .. } => Movement::Line { end: zero() },
            Movement::Dummy { .. } => Movement::Dummy { vector: zero() },
            Movement::HeldVector { .. } => Movement::HeldVector { end: zero() },
            Movement::NewVector { .. } => Movement::NewVector { vector: zero() },
            Movement::CornerArc { vector } => Movement::CornerArc { vector: vector.as_ref().map(|_| zero()) },
            Movement::Arc { centre, direction, .. } => Movement::Arc {
                end: zero(),
                centre: match centre {
                    Centre::FromStart(_) => Centre::FromStart(zero()),
                    Centre::Radius(_) => Centre::Radius(Rational::new()),
                },
                direction: *direction,
            },
        },
        rapid: block.rapid,
        compensation: block.compensation,
        vector: block.vector.as_ref().map(|_| zero()),
        radius: block.radius.as_ref().map(|_| Rational::new()),
        corner: block.corner,
        approach: block.approach,
        stops_look_ahead: block.stops_look_ahead,
        not_in_mode: block.not_in_mode,
    }
}
