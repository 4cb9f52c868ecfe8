//! The two budgets, never mixed: β, which branch; δ, how far a point may lie off.

use radcomp_model::number::nearest_f64;
use radcomp_spec::{Block, Centre, Movement};
use rug::Rational;

/// How wide the band around a decision is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// β = 2⁻⁴⁰ times the largest number of the program: what arithmetic in f64 may lose.
    Binary64,
    /// β = half the least input increment.
    Resolution,
}

/// Both budgets, in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// How wide the band is.
    pub grade: Grade,
    /// Least input increment of the control.
    pub least_increment: f64,
    /// How far a point may lie from where its branch puts it, beside a unit in the last place of its larger coordinate, for
    /// coordinates are compared as f64.
    pub delta: f64,
}

impl Budget {
    /// The band β of a program, in millimetres.
    pub fn beta(&self, blocks: &[Block<Rational>]) -> f64 {
        match self.grade {
            Grade::Binary64 => largest(blocks) / (1u64 << 40) as f64,
            Grade::Resolution => self.least_increment / 2.0,
        }
    }
}

/// The largest magnitude among a program's numbers.
fn largest(blocks: &[Block<Rational>]) -> f64 {
    let mut largest = 0.0_f64;
    let mut see = |value: &Rational| largest = largest.max(nearest_f64(value).abs());
    for block in blocks {
        match &block.movement {
            Movement::None | Movement::CornerArc { vector: None } => {}
            Movement::Line { end } | Movement::HeldVector { end } => end.iter().for_each(&mut see),
            Movement::Dummy { vector }
            | Movement::NewVector { vector }
            | Movement::CornerArc { vector: Some(vector) } => vector.iter().for_each(&mut see),
            Movement::Arc { end, centre, .. } => {
                end.iter().for_each(&mut see);
                match centre {
                    Centre::FromStart(vector) => vector.iter().for_each(&mut see),
                    Centre::Radius(radius) => see(radius),
                }
            }
        }
        block.radius.iter().for_each(&mut see);
        block.vector.iter().flatten().for_each(&mut see);
    }
    largest
}
