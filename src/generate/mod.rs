//! Programs for certification: random, but full of what decides something.
//!
//! Directions are axis-parallel, diagonal and Pythagorean, arcs have rational centres and ends exactly on them, tools
//! fit exactly as often as not, and every program comes three times: as made, and with one number moved by one least
//! increment down and up. One seed gives the same programs on every machine, each one independent of the others.

mod codes;
mod contour;
mod dice;
mod features;

use radcomp_spec::Block;
use radcomp_spec::parameters::{CornerCodes, Dummy};
use radcomp_spec::profile::Profile;
use rug::Rational;

use dice::Dice;

/// What a profile lets programs hold.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// Blocks without movement allowed between moves.
    pub non_moving_allowed: u8,
    /// Dummy blocks exist.
    pub dummies: bool,
    /// M96 and M97 exist.
    pub corner_codes: bool,
}

impl Reach {
    /// What a profile's programs may hold.
    pub fn of(profile: &Profile) -> Self {
        Reach {
            non_moving_allowed: profile.parameters.non_moving_allowed,
            dummies: profile.machine.dummy == Dummy::Ijk,
            corner_codes: profile.machine.corner_codes == CornerCodes::M96M97,
        }
    }
}

/// The program with this number in the sequence of a seed; about ten blocks.
pub fn program(seed: u64, number: u64, reach: Reach) -> Vec<Block<Rational>> {
    // Three programs in a row share what they are made of.
    let mut dice = Dice::new(seed, number / 3);
    let contour = contour::contour(&mut dice);
    let mut blocks = codes::with_codes(contour, &mut dice, reach);
    features::decorate(&mut blocks, &mut dice, reach);
    match number % 3 {
        0 => {}
        1 => features::nudge(&mut blocks, &mut dice, -1),
        _ => features::nudge(&mut blocks, &mut dice, 1),
    }
    blocks
}

/// A number of thousandths of a millimetre.
fn thousandths(value: i64) -> Rational {
    Rational::from((value, 1000))
}
